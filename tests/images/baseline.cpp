#include "images/baseline.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "output/diff.h"
#include "output/image.h"
#include "output/png.h"
#include "output/whole_file.h"

namespace crsh::test {
namespace {

namespace fs = std::filesystem;

constexpr size_t max_bytes = 64 << 10;
/// Along edges another driver may draw another triangle: few pixels, however much they differ by.
constexpr output::Tolerance tolerance{.fail = 0.02, .fail_percent = 1, .hard_fail = 1};

std::string blessed(const fs::path& path, const std::string& bytes) {
  if (bytes.size() > max_bytes) return fmt::format("{} would have {} bytes", path.string(), bytes.size());
  output::write_whole(path, bytes);
  return {};
}

std::string without_baseline(const std::string& name, const fs::path& actual) {
  return fmt::format("{} has no baseline yet (CRSH_BLESS=1 makes one); actual: {}", name, actual.string());
}

}  // namespace

std::string difference_to_baseline(const std::string& name, const Picture& picture) {
  const fs::path baseline = fs::path(CRSH_SOURCE_DIR) / "tests/images/baselines" / (name + ".png");
  const std::string bytes = output::encode_png(*picture.find(""), picture.width, picture.height, 0);
  const char* bless = std::getenv("CRSH_BLESS");
  if (bless && std::string_view(bless) == "1") return blessed(baseline, bytes);

  const fs::path folder = fs::path(CRSH_BUILD_DIR) / "test-images";
  const fs::path actual = folder / (name + ".png"), apart = folder / (name + "-difference.png");
  fs::create_directories(folder);
  if (!fs::exists(baseline)) {
    output::write_whole(actual, bytes);
    return without_baseline(name, actual);
  }
  const auto comparison =
      output::compare(output::decode_png(bytes, actual), output::read_image(baseline), {"all"}, tolerance);
  if (comparison.same) return {};
  output::write_whole(actual, bytes);
  if (comparison.mismatch.empty()) output::write_whole(apart, output::difference_png(comparison));
  return fmt::format("{}; actual: {}; difference: {}; baseline: {}", output::verdict(comparison, tolerance),
                     actual.string(), apart.string(), baseline.string());
}

}  // namespace crsh::test
