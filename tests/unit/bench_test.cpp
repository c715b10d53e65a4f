// Tables, charts and meshes of the bench, without a device.

#include <doctest/doctest.h>

#include "bench/binned_sah.h"
#include "bench/budget.h"
#include "bench/counters.h"
#include "bench/heat_figures.h"
#include "bench/svg.h"
#include "bench/sweep.h"
#include "bench/table.h"

namespace crsh::bench {
namespace {

TEST_CASE("numbers are written as the paper writes them") {
  CHECK(count_text(9133130000) == "9133.13 M");
  CHECK(count_text(251550) == "251.55 K");
  CHECK(count_text(790) == "790");
  CHECK(percent_text(514, 10000) == "5.14%");
  CHECK(percent_text(375, 1000000) == "0.0375%");
  CHECK(percent_text(7, 7) == "100%");
  CHECK(percent_text(1, 0) == "-");
  CHECK(ratio_text(218, 100) == "2.18X");
  CHECK(ratio_text(1, 0) == "-");
}

TEST_CASE("the median is the middle, whatever the order") {
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 3, 2}) == 2.5);
  CHECK(median({}) == 0);
}

TEST_CASE("as many rounds as fit the time, an eighth of them for warming up, and one at least") {
  const Rounds asked{3, 58};
  CHECK(rounds_that_fit(asked, 1000, 1) == asked);
  CHECK(rounds_that_fit(asked, 61, 1) == asked);
  CHECK(rounds_that_fit(asked, 60, 1) == Rounds{3, 57});
  CHECK(rounds_that_fit(asked, 9.5, 1) == Rounds{1, 8});
  CHECK(rounds_that_fit(asked, 4, 1) == Rounds{0, 4});
  CHECK(rounds_that_fit(asked, -5, 1) == Rounds{0, 1});
  CHECK(rounds_that_fit(asked, 5, 0) == asked);
  CHECK(rounds_that_fit({0, 1}, 0, 1) == Rounds{0, 1});
  CHECK(rounds_that_fit({5, 1}, 3, 1) == Rounds{0, 1});
}

TEST_CASE("figures stand flush right below their headings, rows of one cell alone") {
  const Table table{.title = "T",
                    .note = "n",
                    .spans = {{"S", 2}},
                    .columns = {"A", "one", "two"},
                    .rows = {{"x", "1", "22222"}, {"group"}}};
  CHECK(text_of(table) ==
        "T\n"
        "            S\n"
        "A  one    two\n"
        "x    1  22222\n"
        "group\n"
        "n\n");
}

TEST_CASE("a heading wider than its columns widens them") {
  const Table table{
      .title = "T", .note = "", .spans = {{"LONG NAME", 1}}, .columns = {"A", "one"}, .rows = {{"x", "1"}}};
  CHECK(text_of(table) == "T\n   LONG NAME\nA        one\nx          1\n");
}

TEST_CASE("bars of nothing are left out, and what is not text is escaped") {
  const std::string svg =
      bars_svg({{"a<b", {{"none", 0, "0", 0}, {"some", 1000, "1000", 1}, {"more", 100000, "100 K", 2}}}}, "t&t");
  CHECK(svg.find("none") == std::string::npos);
  CHECK(svg.find("a&lt;b") != std::string::npos);
  CHECK(svg.find("<title>t&amp;t</title>") != std::string::npos);
  CHECK(svg.find("url(#p1)") != std::string::npos);
  CHECK(bars_svg({{"a", {{"none", 0, "0", 0}}}}, "t").empty());
}

TEST_CASE("the parts of the longest stack fill the width, those of another in proportion") {
  const std::string svg = stacks_svg({{"a", "4 ms", {1, 3}}, {"b", "2 ms", {2, 0}}}, {"p", "q"}, "ms", "t");
  CHECK(svg.find("width='25.000%'") != std::string::npos);
  CHECK(svg.find("width='75.000%'") != std::string::npos);
  CHECK(svg.find("width='50.000%'") != std::string::npos);
}

TEST_CASE("base64 is padded") {
  CHECK(data_address("a/b", "Man") == "data:a/b;base64,TWFu");
  CHECK(data_address("a/b", "Ma") == "data:a/b;base64,TWE=");
  CHECK(data_address("a/b", "\xff") == "data:a/b;base64,/w==");
}

scene::Scene one_triangle() {
  scene::Scene scene;
  scene::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 6, 1}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.uv[0] = {{0, 0}, {1, 0}, {0, 1}};
  mesh.uv[1].assign(3, {0, 0});
  mesh.colours.assign(3, scene::packed_colour({1, 0.25f, 0.5f, 1}));
  mesh.triangles = {{0, 1, 2}};
  mesh.materials = {5};
  scene.meshes = {mesh};
  scene.nodes.resize(1);
  scene.instances = {{0, 0}};
  return scene;
}

double area(const scene::Mesh& mesh) {
  double sum = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
    sum += glm::length(glm::cross(b - a, c - a)) / 2;
    CHECK(glm::cross(b - a, c - a).z > 0);  // turned as before
  }
  return sum;
}

TEST_CASE("a subdivided mesh has the same surface, in n x n pieces each") {
  const scene::Scene scene = one_triangle(), finer = subdivided(scene, 3);
  const scene::Mesh& mesh = finer.meshes[0];
  CHECK(mesh.triangles.size() == 9);
  CHECK(mesh.materials == std::vector<uint32_t>(9, 5));
  CHECK(area(mesh) == doctest::Approx(area(scene.meshes[0])));
  CHECK(mesh.colours == std::vector(10, scene::packed_colour({1, 0.25f, 0.5f, 1})));
  CHECK(mesh.sphere.radius == doctest::Approx(std::sqrt(9 + 36 + 1) / 2).epsilon(1e-3));
  CHECK(subdivided(scene, 1).meshes[0].triangles == scene.meshes[0].triangles);
}

TEST_CASE("two boxes far apart cost a test each and what is met") {
  const SahBox a{{0, 0, 0}, {1, 1, 1}}, b{{9, 0, 0}, {10, 1, 1}};
  CHECK(binned_sah_cost({a, b}) > 1);
  CHECK(binned_sah_cost({a, b}) < binned_sah_cost({a, {{0.5f, 0, 0}, {10, 1, 1}}}));
  CHECK(binned_sah_cost({}) == 0);
}

TEST_CASE("counters of frames are told apart and summed") {
  Statistics one;
  one.rays = {{.kind = "shadow",
               .bounce = 0,
               .count = 3,
               .hits = 1,
               .triangles = 10,
               .levels = {{.level = 1, .nodes = 2, .tests = 20, .hits = 5}},
               .triangle_tests = 40}};
  one.frames.resize(1);
  const Statistics three = times(one, 3);
  CHECK(three.rays[0].triangle_tests == 120);
  CHECK(three.rays[0].levels[0].tests == 60);
  CHECK(first_difference(difference(three, times(one, 2)), one).empty());
  Statistics other = one;
  other.rays[0].levels[0].hits = 6;
  CHECK(first_difference(one, other) == "shadow 0: level's hits is 5 and 6");
  CHECK(as_brute_force(one).rays[0].paper_tests() == 30);
  CHECK(brute_force_tests(one) == 30);
}

}  // namespace
}  // namespace crsh::bench
