// What a rendered EXR says of itself: matrices by OpenEXR's definition, the options that change pixels, and nothing
// else.

#include <ImathMatrix.h>
#include <ImathVec.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "output/image.h"
#include "output/whole_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace crsh {
namespace {

using test::crsh;
const std::string moving = CRSH_SOURCE_DIR "/scenes/moving.glb";

void render(const std::string& path, std::vector<std::string> options) {
  options.insert(options.begin(), {"render", moving, "--size", "24x16", "--bounces", "0", "-o", path});
  const test::Outcome outcome = crsh(options);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
}

std::map<std::string, std::string> strings_of(const Imf::Header& header) {
  std::map<std::string, std::string> strings;
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute)
    if (const auto* string = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
      strings.emplace(attribute.name(), string->value());
  return strings;
}

TEST_CASE("the matrices take P to Z and to its pixel, points as rows, as OpenEXR has it") {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  render(path, {"--layers", "P,Z"});
  const Imf::InputFile file(path.c_str());
  REQUIRE(Imf::hasWorldToCamera(file.header()));
  REQUIRE(Imf::hasWorldToNDC(file.header()));
  const output::Image image = output::read_image(path);
  size_t met = 0;
  for (size_t pixel = 0; pixel < 24 * 16; ++pixel) {
    const double z = image.find("Z")->value(pixel);
    if (z == 1e10f) continue;
    ++met;
    const auto p = [&](const char* channel) { return float(image.find(channel)->value(pixel)); };
    const Imath::V3f point(p("P.X"), p("P.Y"), p("P.Z"));
    CHECK((point * Imf::worldToCamera(file.header())).z == doctest::Approx(z).epsilon(1e-5));
    const Imath::V3f at = point * Imf::worldToNDC(file.header());  // divides by w
    CHECK(at.x * 24 == doctest::Approx(double(pixel % 24) + 0.5).epsilon(1e-3));
    CHECK(at.y * 16 == doctest::Approx(double(pixel / 24) + 0.5).epsilon(1e-3));
  }
  CHECK(met > 50);
}

TEST_CASE("attributes are the options that change pixels, with their effective values") {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  render(path, {"--seed", "3", "--time", "0.5", "--eye", "0,2,9", "--light", "1,4,2", "--light", "1,5,2,40",
                "--algorithm", "rah", "--layers", "beauty", "--max-memory", "512"});
  const Imf::InputFile file(path.c_str());
  const std::map<std::string, std::string> expected = {{"crsh:size", "24x16"},
                                                       {"crsh:samples", "1"},
                                                       {"crsh:seed", "3"},
                                                       {"crsh:bounces", "0"},
                                                       {"crsh:time", "0.5"},
                                                       {"crsh:rays", "shadow,reflection,refraction"},
                                                       {"crsh:background", "0,0,0"},
                                                       {"crsh:override-mirror", "false"},
                                                       {"crsh:eye", "0,2,9"},
                                                       {"crsh:up", "0,1,0"},
                                                       {"crsh:light", "1,4,2 1,5,2,40"}};
  CHECK(strings_of(file.header()) == expected);
}

/// What oiiotool says of the file's values; empty where it is not installed.
std::string read_by_oiiotool(const std::string& path) {
  const test::Outcome outcome = test::run_program("oiiotool", {"--stats", "-v", path});
  return outcome.status == 0 ? outcome.out : "";
}

TEST_CASE("ids are floats that others read as they are, or uint where asked for, and the same to crsh diff") {
  const test::TemporaryFolder folder;
  render(folder / "float.exr", {"--layers", "Object,Material"});
  render(folder / "uint.exr", {"--layers", "Object,Material", "--ids", "uint"});
  const output::Image real = output::read_image(folder / "float.exr"), whole = output::read_image(folder / "uint.exr");
  CHECK(real.find("Object.id")->sample == output::Sample::real);
  CHECK(whole.find("Object.id")->sample == output::Sample::id);
  CHECK(crsh({"diff", folder / "float.exr", folder / "uint.exr", "--exact", "--layers", "all"}).status == 0);
  const std::string said = read_by_oiiotool(folder / "float.exr");
  if (said.empty()) {
    MESSAGE("skipped: no oiiotool");
    return;
  }
  double most = 0;
  for (size_t pixel = 0; pixel < 24 * 16; ++pixel) most = std::max(most, whole.find("Object.id")->value(pixel));
  CHECK(most > 3);
  CAPTURE(said);
  CHECK(said.find("Stats Max: ") != std::string::npos);
  CHECK(said.find(fmt::format("{:.6f}", most), said.find("Stats Max: ")) != std::string::npos);
}

TEST_CASE("no name, place, algorithm or amount of memory is in the bytes") {
  const test::TemporaryFolder folder;
  render(folder / "a.exr", {});
  render(folder / "another name.exr",
         {"--algorithm", "rah", "--max-memory", "512", "-o", folder / "b.png", "--stats", folder / "s"});
  CHECK(output::read_whole(folder / "a.exr") == output::read_whole(folder / "another name.exr"));
}

}  // namespace
}  // namespace crsh
