// The exact counters of every preset on rays that are checked in (tests/rays): one test more or less is seen.
// CRSH_BLESS=1 takes new counters; where a file of rays is missing, also new rays.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <sstream>
#include <string>

#include "output/ray_file.h"
#include "output/whole_file.h"
#include "rays/hash.h"
#include "support/arithmetic.h"
#include "support/device.h"
#include "support/render.h"

namespace crsh::test {
namespace {

const std::filesystem::path folder = CRSH_SOURCE_DIR "/tests/rays";
const std::filesystem::path table_file = folder / "counters.txt";
constexpr uintmax_t max_bytes = 300 << 10;

bool blesses() {
  const char* bless = std::getenv("CRSH_BLESS");
  return bless && std::string(bless) == "1";
}

/// A scene of the project, the size of the picture that its rays come from, and which of its animations played.
struct Recording {
  const char* scene;
  uint32_t width, height;
  const char* animation = "";
};
constexpr Recording recordings[] = {{"cornell", 36, 24}, {"glass", 28, 20},     {"moving", 36, 24, "fairground"},
                                    {"office", 18, 12},  {"colonnade", 28, 20}, {"walking", 24, 16},
                                    {"morphing", 24, 16}};

/// One function whose result may differ between drivers by a bit makes these keys: they are taken from the file.
constexpr const char* inexact_key = "spherical";

void record(const Recording& recording, const std::filesystem::path& file) {
  RenderOptions options;
  options.width = recording.width;
  options.height = recording.height;
  options.bounces = 1;
  options.animation = recording.animation;
  options.algorithm = preset("crsh-2017");
  RayTable rays;
  Renderer renderer(borrowed(device()), borrowed(own_scene(recording.scene)), options);
  (void)renderer.render(0, {}, &rays);
  output::write_rays(file, rays);
}

/// A line a kind and bounce.
std::string lines_of(const std::string& start, const Statistics& statistics) {
  std::string text;
  for (const RayStatistics& rays : statistics.rays) {
    if (!rays.count) continue;
    text += fmt::format("{} {} {}: rays {} hits {:016x} mesh {} box {}", start, rays.kind, rays.bounce, rays.count,
                        rays.hits_digest, rays.mesh_tests, rays.box_tests);
    for (const LevelStatistics& level : rays.levels)
      text += fmt::format(" level{} {}/{}/{}", level.level, level.nodes, level.tests, level.hits);
    text += fmt::format(" triangle {}\n", rays.triangle_tests);
  }
  return text;
}

std::string replayed(const Recording& recording, const RayTable& rays, const std::string& name) {
  RenderOptions options;
  options.bounces = 1;
  options.animation = recording.animation;
  options.algorithm = preset(name);
  options.algorithm.least_rays = 0;  // pictures are so small that most rays would be too scattered for nodes
  for (std::string& key : options.algorithm.keys)
    if (key == inexact_key) key = rays::key_of_file;
  Renderer renderer(borrowed(device()), borrowed(own_scene(recording.scene)), options);
  renderer.replay(rays, 0);
  return lines_of(fmt::format("{} {}", recording.scene, name), renderer.statistics());
}

/// The lines of the table by what they begin with: "office crsh".
std::map<std::string, std::string> recorded() {
  std::map<std::string, std::string> lines;
  if (!std::filesystem::exists(table_file)) return lines;
  std::istringstream stream(output::read_whole(table_file));
  for (std::string line; std::getline(stream, line);)
    lines[line.substr(0, line.find(' ', line.find(' ') + 1))] += line + "\n";
  return lines;
}

std::vector<std::string> words_of(const std::string& text) {
  std::string spaced = text;
  std::ranges::replace(spaced, '/', ' ');
  std::istringstream stream(spaced);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// A preset's digests, one after the other.
std::string digests_of(const std::string& lines) {
  std::string digests;
  const std::vector<std::string> words = words_of(lines);
  for (size_t i = 1; i < words.size(); ++i)
    if (words[i - 1] == "hits") digests += words[i] + " ";
  return digests;
}

/// Whether these are the recorded counters but for what last bits decide: digests, which are of distances, are left
/// out; numbers of tests agree within 2% and numbers of rays and nodes do, too.
std::string difference_but_for_bits(const std::string& lines, const std::string& expected) {
  const std::vector<std::string> a = words_of(lines), b = words_of(expected);
  if (a.size() != b.size()) return "other rays or levels:\n" + lines;
  for (size_t i = 1; i < a.size(); ++i) {
    if (a[i] == b[i] || a[i - 1] == "hits") continue;
    const double left = std::atof(a[i].c_str()), right = std::atof(b[i].c_str());
    if (a[i - 1] == "rays" || std::abs(left - right) > std::max(0.02 * right, 10.0))
      return fmt::format("{} against {} after {} in\n{}", a[i], b[i], a[i - 1], lines);
  }
  return {};
}

/// Holds a preset's counters against the recorded ones: with other arithmetic than IEEE's, as far as they can be the
/// same, and the digests against the first preset's.
void check_lines(const std::string& lines, const std::string& expected, std::string& digests) {
  INFO("where that is meant: CRSH_BLESS=1 build/test_images -tc='*recorded*', and look at the difference");
  if (arithmetic().is_ieee()) {
    CHECK(lines == expected);
    return;
  }
  CHECK(difference_but_for_bits(lines, expected) == "");
  if (digests.empty()) digests = digests_of(lines);
  CHECK(digests_of(lines) == digests);
}

TEST_CASE("every preset has the recorded counters on the recorded rays, to the last test") {
  const std::map<std::string, std::string> expected = recorded();
  std::string all;
  if (!arithmetic().is_ieee())
    MESSAGE("presets are compared among each other, and to the recorded counters within 2%: ", arithmetic().text());
  for (const Recording& recording : recordings) {
    std::string digests;
    const std::filesystem::path file = folder / (std::string(recording.scene) + ".npz");
    if (blesses() && !std::filesystem::exists(file)) record(recording, file);
    CHECK(std::filesystem::file_size(file) <= max_bytes);
    const RayTable rays = output::read_rays(file);
    for (const std::string& name : preset_names()) {
      const std::string lines = replayed(recording, rays, name), start = fmt::format("{} {}", recording.scene, name);
      all += lines;
      const auto found = expected.find(start);
      if (!blesses())
        check_lines(lines, found == expected.end() ? start + ": nothing recorded" : found->second, digests);
    }
  }
  if (blesses()) output::write_whole(table_file, all);
}

TEST_CASE("the recorded table notices a fault that loses one pair in 10,000") {
  if (blesses()) return;
  const std::map<std::string, std::string> expected = recorded();
  const Recording& office = recordings[3];
  REQUIRE(std::string(office.scene) == "office");
  RenderOptions options;
  options.bounces = 1;
  options.algorithm = preset("rah");
  options.mutation = "dropped-pairs";
  Renderer renderer(borrowed(device()), borrowed(own_scene(office.scene)), options);
  renderer.replay(output::read_rays(folder / "office.npz"), 0);
  CHECK(lines_of("office rah", renderer.statistics()) != expected.at("office rah"));
}

}  // namespace
}  // namespace crsh::test
