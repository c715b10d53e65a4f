// The creation of rays (section 3.2.2) against the definitions, computed in double.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "rays/create.h"
#include "shared/ray.h"
#include "small_scene.h"
#include "support/kinds.h"
#include "surfaces_by_hand.h"

namespace crsh {
namespace {

using test::Point;

constexpr uint32_t triangles = 100;  // the ids of random_points

/// What the points pretend to lie on: rays leave by a step that their triangle's coordinates bound, too.
test::SmallScene some_triangles() {
  test::Random random(10);
  test::SmallScene small;
  small.material(test::matt(glm::vec3(1)));
  std::vector<glm::vec3> corners;
  for (uint32_t i = 0; i < 3 * triangles; ++i) corners.push_back(random.point(i % 2 ? 3.0f : 300.0f));
  small.mesh(corners, 0);
  small.instance(0);
  return small;
}

struct Created {
  std::vector<glm::vec4> spheres;  // of the triangles
  std::vector<shared::Ray> rays;
  std::vector<uint32_t> flags;
  std::vector<glm::vec4> reflection, refraction;
};

Created create(const std::vector<Point>& points, const std::vector<shared::Light>& lights, const rays::BatchPlan& plan,
               bool mirror = false) {
  gpu::Recorder recorder(test::device());
  test::HandMade made = test::upload_points(points);
  const scene::GpuScene gpu = some_triangles().on(recorder, {lights, {}});
  rays::Sparse sparse;
  rays::create(recorder, {made.surfaces, gpu, plan, mirror}, sparse, made.generation);
  Created out{recorder.read<glm::vec4>(gpu.triangle_spheres, triangles),
              recorder.read<shared::Ray>(sparse.rays, sparse.slots),
              recorder.read<uint32_t>(sparse.flags, sparse.slots),
              {},
              {}};
  const auto weights = [&](const gpu::Buffer& b) {
    return b.bytes() ? recorder.read<glm::vec4>(b, points.size()) : std::vector<glm::vec4>{};
  };
  out.reflection = weights(made.generation.weights[shared::kind_reflection]);
  out.refraction = weights(made.generation.weights[shared::kind_refraction]);
  return out;
}

rays::BatchPlan plan_of(std::vector<rays::Wanted> segments, size_t surfaces) {
  return {std::move(segments), 0, uint32_t(surfaces)};
}

double largest(glm::vec3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

/// How far from its surface a ray starts: 2^-16 of the point's coordinates, 2^-20 of its triangle's and the ray's other
/// end's.
double step(const Created& created, const Point& p, glm::vec3 other_end = glm::vec3(0)) {
  const glm::vec4 sphere = created.spheres[p.triangle];
  return std::max(std::ldexp(largest(p.position), -16),
                  std::ldexp(std::max(largest(sphere) + sphere.w, largest(other_end)), -20));
}

glm::dvec3 moved(const Point& p, double by) { return glm::dvec3(p.position) + glm::dvec3(p.geometric) * by; }
bool near(glm::dvec3 a, glm::dvec3 b, double tolerance) { return glm::distance(a, b) <= tolerance; }

shared::Light light_at(glm::vec3 position, float range, glm::vec2 cone = {0, 1}, glm::vec3 axis = {0, 0, -1}) {
  return {glm::vec4(position, 0), glm::vec4(axis, range), glm::vec4(1, 1, 1, 0), glm::vec4(cone, 0, 0)};
}

TEST_CASE("shadow rays run from the light to the offset point, where it shines on the front and reaches it" *
          doctest::test_suite("subset")) {
  test::Random random(11);
  const std::vector<Point> points = test::random_points(random, 3000);
  const float endless = std::numeric_limits<float>::infinity();
  const std::vector<shared::Light> lights = {
      light_at({3, 4, 5}, endless), light_at({-30, 40, 0}, 60),
      light_at({0, 0, 90}, endless, {8, -7}, glm::normalize(glm::vec3(0.1f, 0, -1)))};
  const Created created = create(points, lights, plan_of({{0, 0}, {0, 1}, {0, 2}}, points.size()));
  uint32_t rays = 0;
  for (size_t slot = 0; slot < created.flags.size(); ++slot) {
    const Point& p = points[slot % points.size()];
    const shared::Light& light = lights[slot / points.size()];
    const glm::dvec3 way = glm::dvec3(light.position) - glm::dvec3(p.position);
    const double facing = glm::dot(glm::normalize(way), glm::dvec3(p.geometric));
    const double angular = light.cone.y - glm::dot(glm::dvec3(light.direction), glm::normalize(way)) * light.cone.x;
    const double reach = 1 - glm::length(way) / light.direction.w;
    if (std::abs(facing) > 1e-5 && std::abs(angular) > 1e-5 && std::abs(reach) > 1e-5)
      CHECK((created.flags[slot] == 1) == (p.triangle != shared::none && facing > 0 && angular > 0 && reach > 0));
    if (!created.flags[slot]) continue;
    ++rays;
    const shared::Ray& ray = created.rays[slot];
    const double by = step(created, p, light.position);
    CHECK(glm::vec3(ray.origin) == glm::vec3(light.position));
    CHECK(near(glm::dvec3(ray.origin) + glm::dvec3(ray.direction) * double(ray.origin.w), moved(p, by), by / 2));
    CHECK(ray.direction.w == float(shared::kind_shadow));
  }
  CHECK(rays > 1000);
}

TEST_CASE("a directional light's rays start on its plane and run along it") {
  test::Random random(12);
  std::vector<Point> points = test::random_points(random, 500);
  for (Point& p : points) p.position = glm::normalize(p.position) * 10.0f;
  shared::Light sun = light_at(glm::vec3(0), std::numeric_limits<float>::infinity());
  const glm::vec3 axis = glm::normalize(glm::vec3(1, -2, 0.5f));
  sun.position = glm::vec4(axis * -20.0f, 2);
  sun.direction = glm::vec4(axis, sun.direction.w);
  const Created created = create(points, {sun}, plan_of({{0, 0}}, points.size()));
  for (size_t i = 0; i < points.size(); ++i) {
    const float facing = -glm::dot(axis, points[i].geometric);
    if (std::abs(facing) > 1e-6f) CHECK((created.flags[i] == 1) == (points[i].triangle != shared::none && facing > 0));
    if (!created.flags[i]) continue;
    CHECK(glm::vec3(created.rays[i].direction) == axis);
    CHECK(glm::dot(glm::vec3(created.rays[i].origin), axis) == doctest::Approx(-20));
    CHECK(near(glm::dvec3(created.rays[i].origin) + glm::dvec3(axis) * double(created.rays[i].origin.w),
               moved(points[i], step(created, points[i], sun.position)), 1e-5));
  }
}

double dielectric(double cosine, double eta) {
  const double squared = 1 - eta * eta * (1 - cosine * cosine);
  if (squared <= 0) return 1;
  const double beyond = std::sqrt(squared);
  const double across = (eta * cosine - beyond) / (eta * cosine + beyond),
               along = (cosine - eta * beyond) / (cosine + eta * beyond);
  return (across * across + along * along) / 2;
}

glm::dvec3 fresnel(const Point& p) {
  const double cosine = -glm::dot(glm::dvec3(p.normal), glm::dvec3(p.incoming));
  double rise = std::pow(1 - cosine, 5);
  if (p.eta != 1.0f) {
    const double base = std::pow((1 - double(p.eta)) / (1 + double(p.eta)), 2);
    rise = (dielectric(cosine, p.eta) - base) / (1 - base);
  }
  return glm::dvec3(p.specular) + (1.0 - glm::dvec3(p.specular)) * std::clamp(rise, 0.0, 1.0);
}

void check_weight(const Point& p, const glm::vec4& weight, uint32_t flag, glm::dvec3 expected) {
  const double largest = std::max({expected.r, expected.g, expected.b});
  const bool expects_ray = p.triangle != shared::none && largest >= 1.0 / 256;
  if (std::abs(largest - 1.0 / 256) > 1e-5) CHECK((flag == 1) == expects_ray);
  if (flag) CHECK(near(glm::dvec3(weight), expected, 3e-5));
  else CHECK(glm::vec3(weight) == glm::vec3(0));
}

TEST_CASE("reflection rays are mirrored about the shading normal, weighed by Fresnel, and stay outside" *
          doctest::test_suite("subset")) {
  test::Random random(13);
  const std::vector<Point> points = test::random_points(random, 3000);
  const Created created = create(points, {}, plan_of({{shared::kind_reflection, 0}}, points.size()));
  for (size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    const double sharp = 1 - double(p.roughness);
    check_weight(p, created.reflection[i], created.flags[i], fresnel(p) * sharp * sharp);
    if (!created.flags[i]) continue;
    const shared::Ray& ray = created.rays[i];
    glm::dvec3 mirrored = glm::reflect(glm::dvec3(p.incoming), glm::dvec3(p.normal));
    const double height = glm::dot(mirrored, glm::dvec3(p.geometric));
    if (height < 0) mirrored -= glm::dvec3(p.geometric) * (2 * height);
    CHECK(near(glm::dvec3(ray.direction), mirrored, 2e-6));
    const double by = step(created, p);
    CHECK(near(glm::dvec3(ray.origin), moved(p, by), by / 16));
    CHECK(std::isinf(ray.origin.w));
    CHECK(ray.direction.w == float(shared::kind_reflection));
  }
}

TEST_CASE("refraction rays go straight through thin walls, bend by Snell's law, and end at total internal reflection") {
  test::Random random(14);
  const std::vector<Point> points = test::random_points(random, 3000);
  const Created created = create(points, {}, plan_of({{shared::kind_refraction, 0}}, points.size()));
  uint32_t bent = 0, total = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    const double cosine = -glm::dot(glm::dvec3(p.normal), glm::dvec3(p.incoming));
    const double left = 1 - double(p.eta) * p.eta * (1 - cosine * cosine);
    check_weight(p, created.refraction[i], created.flags[i],
                 (1.0 - fresnel(p)) * glm::dvec3(p.diffuse) * double(p.transmission));
    if (left < 0) CHECK(created.flags[i] == 0);
    total += left < 0;
    if (!created.flags[i]) continue;
    bent += p.eta != 1.0f;
    glm::dvec3 direction(p.incoming);
    if (p.eta != 1.0f)
      direction = glm::normalize(direction * double(p.eta) + glm::dvec3(p.normal) * (p.eta * cosine - std::sqrt(left)));
    const double height = glm::dot(direction, glm::dvec3(p.geometric));
    if (height > 0) direction -= glm::dvec3(p.geometric) * (2 * height);
    CHECK(near(glm::dvec3(created.rays[i].direction), direction, 2e-5));
    const double by = step(created, p);
    CHECK(near(glm::dvec3(created.rays[i].origin), moved(p, -by), by / 16));
    CHECK(created.rays[i].direction.w == float(shared::kind_refraction));
  }
  CHECK(bent > 100);
  CHECK(total > 50);
}

TEST_CASE("--override-mirror: every surface that was met reflects with weight 1") {
  test::Random random(15);
  const std::vector<Point> points = test::random_points(random, 200);
  const Created created = create(points, {}, plan_of({{shared::kind_reflection, 0}}, points.size()), true);
  for (size_t i = 0; i < points.size(); ++i) {
    CHECK((created.flags[i] == 1) == (points[i].triangle != shared::none));
    CHECK(glm::vec3(created.reflection[i]) == glm::vec3(created.flags[i] ? 1.0f : 0.0f));
  }
}

TEST_CASE("a batch of part of the surfaces and all kinds puts each ray in its own slot") {
  test::Random random(16);
  const std::vector<Point> points = test::random_points(random, 300);
  const std::vector<shared::Light> lights(3, light_at({3, 4, 5}, std::numeric_limits<float>::infinity()));
  const std::vector<rays::Wanted> all = {{0, 1}, {0, 2}, {1, 0}, {2, 0}};
  const Created whole = create(points, lights, plan_of(all, 300));
  const Created part = create(points, lights, {all, 100, 77});
  for (uint32_t segment = 0; segment < 4; ++segment)
    for (uint32_t i = 0; i < 77; ++i) {
      const uint32_t slot = segment * 77 + i, same = segment * 300 + 100 + i;
      CHECK(part.flags[slot] == whole.flags[same]);
      if (part.flags[slot]) CHECK(part.rays[slot].direction == whole.rays[same].direction);
    }
  CHECK(part.reflection[120] == whole.reflection[120]);
}

TEST_CASE("plans keep to 64 segments and the given slots, and leave nothing out") {
  for (const bool mixed : {true, false})
    for (const uint32_t surfaces : {1u, 1000u, 5000u})
      for (const uint32_t lights : {0u, 1u, 70u, 300u}) {
        const auto plans = rays::plan_batches({surfaces, lights, PerKind<bool>(true), mixed, 4096});
        uint64_t wanted = 0;
        for (const rays::BatchPlan& plan : plans) {
          CHECK(plan.slots() <= 4096);
          CHECK(plan.segments.size() <= rays::max_segments);
          if (!mixed)
            for (const rays::Wanted& w : plan.segments) CHECK(w.kind == plan.segments[0].kind);
          wanted += plan.slots();
        }
        uint64_t segments = 0;
        for (const RayKind& kind : ray_kinds) segments += kind.one_a_light ? lights : 1;
        CHECK(wanted == surfaces * segments);
      }
  CHECK(rays::plan_batches({0, 5}).empty());
  CHECK(rays::plan_batches({5, 0, test::only({shared::kind_shadow})}).empty());
}

TEST_CASE("a plan's segments rise by kind and light, and its runs are those of one kind") {
  for (const rays::BatchPlan& plan : rays::plan_batches({.surfaces = 10, .lights = 3})) {
    uint32_t segments = 0;
    for (const rays::KindRun& run : rays::runs_of(plan)) {
      CHECK(run.first == segments);
      CHECK(run.segments == (ray_kinds[run.kind].one_a_light ? 3 : 1));
      for (uint32_t i = 0; i < run.segments; ++i, ++segments) {
        CHECK(plan.segments[segments].kind == run.kind);
        CHECK(plan.segments[segments].light == i);
      }
    }
    CHECK(segments == plan.segments.size());
  }
}

TEST_CASE("shadow rays are cast from the last bounce, too; the others only before it") {
  RenderOptions options;
  options.bounces = 2;
  const uint32_t shadow = shared::kind_shadow, reflection = shared::kind_reflection,
                 refraction = shared::kind_refraction;
  CHECK(rays::kinds_at(options, 1) == test::only({shadow, reflection, refraction}));
  CHECK(rays::kinds_at(options, 2) == test::only({shadow}));
  options.rays[shadow] = false;
  CHECK(rays::kinds_at(options, 0) == test::only({reflection, refraction}));
}

}  // namespace
}  // namespace crsh
