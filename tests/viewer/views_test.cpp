// Ways of looking: layers in colours, two side by side, nodes and bounds.

#include <doctest/doctest.h>

#include <set>

#include "output/image.h"
#include "viewer/show.h"
#include "viewer/view.h"

namespace crsh {
namespace {

using test::cornell;
using test::quick;
using test::TemporaryFolder;
using test::view;

const std::vector<std::string> still = {"--bounces", "0", "--samples", "1", "--quiet"};
const std::string start = "resize 620 420\nwait\n";

/// The picture between panels and the line of state.
std::vector<uint32_t> picture_of(const std::string& path) {
  const output::Image image = output::read_image(path);
  std::vector<uint32_t> pixels;
  for (uint32_t y = 0; y < image.height - 60; ++y)
    for (uint32_t x = 300; x < image.width; ++x) {
      const size_t pixel = size_t(y) * image.width + x;
      pixels.push_back(image.find("R")->bits[pixel] << 16 | image.find("G")->bits[pixel] << 8 |
                       image.find("B")->bits[pixel]);
    }
  return pixels;
}

/// Pictures after each part of a script; all of them differ.
void check_all_differ(const std::vector<std::string>& parts, const std::vector<std::string>& options = still) {
  const TemporaryFolder folder;
  std::string script = start;
  for (size_t i = 0; i < parts.size(); ++i)
    script += parts[i] + "\nwait\nframes 3\nscreenshot " + (folder / std::to_string(i)) + "\n";
  const test::Outcome outcome = view(cornell, script, options);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.err.empty());
  std::set<std::vector<uint32_t>> seen;
  for (size_t i = 0; i < parts.size(); ++i) {
    CAPTURE(parts[i]);
    CHECK(seen.insert(picture_of(folder / std::to_string(i))).second);
  }
}

TEST_CASE("every way of showing a picture looks unlike the others" * doctest::test_suite("subset")) {
  std::vector<std::string> parts;
  for (const viewer::ShowRow& row : viewer::show_table()) parts.push_back("choose show=" + std::string(row.name));
  check_all_differ(parts);
}

TEST_CASE("nodes are drawn for the pixel under the cursor or for all, by level; bounds as balls or boxes" *
          doctest::test_suite("subset")) {
  check_all_differ({"move 480 200", "click ray nodes\nmove 480 200", "move 430 320", "click all nodes\nmove 480 200",
                    "choose of rays=reflection\nmove 480 200",
                    "click all nodes\nclick ray nodes\nclick object bounds\nmove 480 200",
                    "choose algorithm=crsh\nmove 480 200"});
}

TEST_CASE("the line compares two algorithms and is dragged") {
  check_all_differ({"choose show=tests", "click split", "choose right algorithm=brute", "drag left 450 200 520 200",
                    "choose right show=normal"});
}

TEST_CASE("hidden objects, other lights and other rays change the picture") {
  check_all_differ({"click View\nclick Algorithm\nclick Total\nclick Time\nclick Counters\nclick Rays",
                    "click reflection", "click add light", "click Rays\nclick Scene\nclick object 6"},
                   quick);
}

}  // namespace
}  // namespace crsh
