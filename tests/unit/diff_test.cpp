// What `crsh diff` calls equal.

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "crsh/error.h"
#include "output/diff.h"
#include "output/png.h"

namespace crsh::output {
namespace {

Image real_image(std::vector<float> values, const std::string& channel = "R") {
  Image image{
      .format = Format::exr, .width = uint32_t(values.size()), .height = 1, .channels = {{channel, Sample::real, {}}}};
  for (const float value : values) image.channels[0].bits.push_back(std::bit_cast<uint32_t>(value));
  return image;
}

Image byte_image(std::vector<uint32_t> bytes) {
  return {
      .format = Format::png, .width = uint32_t(bytes.size()), .height = 1, .channels = {{"R", Sample::byte, bytes}}};
}

Comparison compared(const Image& a, const Image& b, const Tolerance& tolerance = {}) {
  return compare(a, b, {"beauty"}, tolerance);
}

constexpr Tolerance exact{.exact = true};

TEST_CASE("exact compares bits: minus zero differs from zero, a not-a-number equals itself") {
  CHECK(compared(real_image({NAN, 1}), real_image({NAN, 1}), exact).same);
  const Comparison signs = compared(real_image({0, 1}), real_image({-0.0f, 1}), exact);
  CHECK_FALSE(signs.same);
  REQUIRE(signs.worst);
  CHECK(signs.worst->difference == 0);
  CHECK_FALSE(compared(real_image({1}), real_image({std::nextafter(1.0f, 2.0f)}), exact).same);
}

TEST_CASE("exact does not take a half for a float") {
  Image half = real_image({0});
  half.channels[0].sample = Sample::half;
  CHECK_FALSE(compared(half, real_image({0}), exact).mismatch.empty());
  CHECK(compared(half, real_image({0})).same);
}

TEST_CASE("images whose data windows begin elsewhere are not equal") {
  Image shifted = real_image({0});
  shifted.left = 1;
  CHECK_FALSE(compared(shifted, real_image({0})).same);
  CHECK(compared(shifted, real_image({0})).mismatch == "data windows differ: they begin at 1,0 against 0,0");
}

TEST_CASE("PNG differs absolutely, EXR relatively") {
  CHECK(compared(byte_image({100}), byte_image({102})).worst->difference == doctest::Approx(2 / 255.0));
  CHECK(compared(real_image({100}), real_image({101})).worst->difference == doctest::Approx(1 / 101.0));
  CHECK(compared(real_image({0}), real_image({0.001f})).worst->difference == doctest::Approx(0.1));
}

TEST_CASE("a pixel fails beyond --fail, and not at it") {
  const Tolerance tolerance{.fail = 1 / 255.0, .fail_percent = 0, .hard_fail = 1};
  CHECK(compared(byte_image({0}), byte_image({1}), tolerance).same);
  CHECK_FALSE(compared(byte_image({0}), byte_image({2}), tolerance).same);
}

TEST_CASE("--fail-percent of the pixels may fail, none beyond --hard-fail") {
  std::vector<uint32_t> few(1000, 10);
  few[5] = 13;
  CHECK(compared(byte_image(std::vector<uint32_t>(1000, 10)), byte_image(few)).same);
  few[6] = 13;
  CHECK_FALSE(compared(byte_image(std::vector<uint32_t>(1000, 10)), byte_image(few)).same);
  few[6] = 10;
  few[5] = 10 + 13;
  CHECK_FALSE(compared(byte_image(std::vector<uint32_t>(1000, 10)), byte_image(few)).same);
}

TEST_CASE("a not-a-number or infinity on one side only is an infinite difference") {
  for (const float odd : {float(NAN), float(INFINITY), -float(INFINITY)}) {
    const Comparison comparison = compared(real_image({odd, 1}), real_image({1, 1}));
    CHECK_FALSE(comparison.same);
    CHECK(std::isinf(comparison.worst->difference));
    CHECK(std::isfinite(comparison.mean));
    CHECK(compared(real_image({odd}), real_image({odd})).same);
  }
}

TEST_CASE("ids are equal or different, however large they are") {
  Image a = real_image({0}, "Object.id"), b = a;
  a.channels[0].sample = b.channels[0].sample = Sample::id;
  a.channels[0].bits = {1000000};
  b.channels[0].bits = {1000001};
  CHECK(compare(a, b, {"all"}, {}).worst->difference == 1);
}

TEST_CASE("ids are the same as float and as uint, and floats of them differ wholly, too") {
  const Image real = real_image({3}, "Object.id"), other = real_image({4}, "Object.id");
  Image whole = real;
  whole.channels[0].sample = Sample::id;
  whole.channels[0].bits = {3};
  CHECK(compare(real, whole, {"all"}, {.exact = true}).same);
  CHECK_FALSE(compare(other, whole, {"all"}, {.exact = true}).same);
  CHECK(compare(real, other, {"all"}, {}).worst->difference == 1);
}

TEST_CASE("sizes and channels that differ are said, not compared") {
  CHECK(compared(real_image({1}), real_image({1, 2})).mismatch == "sizes differ: 1x1 against 2x1");
  CHECK(compared(real_image({1}), real_image({1}, "G")).mismatch == "channels differ: R against G");
}

TEST_CASE("layers choose the channels; one that neither image has is wrong usage") {
  Image a = real_image({1}), b = real_image({1});
  a.channels.push_back(real_image({1}, "Z").channels[0]);
  b.channels.push_back(real_image({2}, "Z").channels[0]);
  CHECK(compare(a, b, {"beauty"}, exact).same);
  CHECK_FALSE(compare(a, b, {"Z"}, exact).same);
  CHECK_FALSE(compare(a, b, {"all"}, exact).same);
  CHECK_THROWS_WITH_AS((void)compare(a, b, {"Q"}, exact), "layer Q is in neither image: choose of Z, all, beauty",
                       UserError);
}

TEST_CASE("a layer is meant by its name, its channels' names, or what they begin with") {
  CHECK(in_layer("R", "beauty"));
  CHECK_FALSE(in_layer("Reflection.R", "beauty"));
  CHECK(in_layer("Reflection.R", "Reflection"));
  CHECK(in_layer("Reflection.R", "Reflection.*"));
  CHECK(in_layer("Tests.node", "Tests"));
  CHECK(in_layer("Tests.node", "Tests.node"));
  CHECK_FALSE(in_layer("Tests.node", "Tests.object"));
  CHECK_FALSE(in_layer("N.X", "Nothing"));
  CHECK_FALSE(in_layer("Normal", "N"));
  CHECK_FALSE(in_layer("N.X", ""));
}

TEST_CASE("a PNG is not compared with an EXR") {
  CHECK_THROWS_AS((void)compared(byte_image({1}), real_image({1})), UserError);
}

TEST_CASE("the verdict names the worst pixel, channel and both values") {
  const std::string line = verdict(compared(real_image({1, 1, 1}), real_image({1, 1.01f, 1.5f})), {});
  CHECK(line ==
        "different: 2 of 3 pixels (66.7%) over 0.004, worst at pixel 2,0 channel R: 1 against 1.5 (difference 0.3333)");
  CHECK(verdict(compared(real_image({1}), real_image({1})), {}) == "equal");
}

TEST_CASE("the JSON says the same, also of infinity") {
  const Comparison comparison = compared(real_image({1, 2}), real_image({1, INFINITY}));
  const auto json = nlohmann::json::parse(diff_json(comparison, {}, "a.exr", "b.exr"));
  CHECK(json["schema"] == "crsh-diff/1");
  CHECK(json["same"] == false);
  CHECK(json["failing_pixels"] == 1);
  CHECK(json["worst"]["x"] == 1);
  CHECK(json["worst"]["b"] == "inf");
  CHECK(json["mismatch"].is_null());
}

TEST_CASE("the difference picture is black where equal and white at the worst") {
  const Comparison comparison = compared(byte_image({10, 20, 30}), byte_image({10, 25, 40}));
  const Image picture = decode_png(difference_png(comparison), "name");
  CHECK(picture.find("Y")->bits == std::vector<uint32_t>{0, 188, 255});
}

}  // namespace
}  // namespace crsh::output
