// The scale of heat maps, measured in CIE lightness, and where values fall on it.

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "output/heat_map.h"
#include "output/image.h"
#include "output/png.h"

namespace crsh::output {
namespace {

double linear(uint8_t byte) {
  const double value = byte / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// CIE L* of a colour, 0 to 100.
double lightness(const std::array<uint8_t, 3>& colour) {
  const double y = 0.2126729 * linear(colour[0]) + 0.7151522 * linear(colour[1]) + 0.0721750 * linear(colour[2]);
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

TEST_CASE("lightness rises in a straight line from dark to light: the scale is readable in grey") {
  for (int i = 0; i <= 100; ++i)
    CHECK(lightness(heat_colour(i / 100.0)) == doctest::Approx(15 + 0.78 * i).epsilon(0.01).scale(40));
}

TEST_CASE("at least 250 steps of the scale can be told apart") {
  std::set<std::array<uint8_t, 3>> colours;
  for (int i = 0; i <= 4000; ++i) colours.insert(heat_colour(i / 4000.0));
  CHECK(colours.size() >= 250);
}

TEST_CASE("what lies outside the scale is its end, and not a number is grey") {
  CHECK(heat_colour(-3) == heat_colour(0));
  CHECK(heat_colour(INFINITY) == heat_colour(1));
  CHECK(heat_colour(NAN) == std::array<uint8_t, 3>{128, 128, 128});
}

TEST_CASE("the maximum is round, above nearly all values, and not led by a few") {
  std::vector<float> values(1000);
  for (size_t i = 0; i < values.size(); ++i) values[i] = float(i) * 0.7f;
  CHECK(heat_maximum(values) == 800);
  values[0] = values[1] = 1e9f;
  values[2] = NAN;
  CHECK(heat_maximum(values) == 800);
  CHECK(heat_maximum({}) == 1);
  CHECK(heat_maximum(std::vector<float>(10, 0.0f)) == 1);
  CHECK(heat_maximum(std::vector<float>(10, 1e6f)) == 1e6);
  for (const float value : {1.01f, 9.9f, 12.0f, 77.0f, 4999.0f, 123456.0f}) {
    CHECK(heat_maximum(std::vector<float>{value}) >= value);
    CHECK(heat_maximum(std::vector<float>{value}) <= 1.5 * value);
  }
}

TEST_CASE("ticks are few, round, and begin with 0") {
  for (const double maximum : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 3000.0, 15000.0, 8e6, 2e9}) {
    CAPTURE(maximum);
    const std::vector<HeatTick> ticks = heat_ticks(maximum);
    CHECK(ticks.size() >= 3);
    CHECK(ticks.size() <= 6);
    CHECK(ticks.front().label == "0");
    for (const HeatTick& tick : ticks) {
      CHECK(tick.place <= 1.000001);
      CHECK(tick.label.size() <= 5);
    }
  }
  CHECK(heat_ticks(15000)[1].label == "5000");
  CHECK(heat_ticks(15000)[2].label == "10k");
  CHECK(heat_ticks(1.5)[1].label == "0.5");
  CHECK(heat_ticks(3e6)[1].label == "1M");
}

TEST_CASE("a picture's tests become its heat map, of all kinds together") {
  Picture picture{.width = 3, .height = 1, .layers = {{"", {"R", "G", "B", "A"}, std::vector<float>(12, 1.0f), {}}}};
  CHECK(tests_of(picture).empty());
  picture.layers.push_back({"Tests.node", {"Tests.node"}, {0, 25, 50}, {}});
  picture.layers.push_back({"Tests.triangle", {"Tests.triangle"}, {0, 25, 150}, {}});
  const std::vector<float> tests = tests_of(picture);
  CHECK(tests == std::vector<float>{0, 50, 200});
  const ColourPicture map = heat_map(tests, 3, 1, 100);
  REQUIRE(map.rgb.size() == 9);
  for (int pixel = 0; pixel < 3; ++pixel)
    for (int c = 0; c < 3; ++c) CHECK(map.rgb[pixel * 3 + c] == heat_colour(std::array{0.0, 0.5, 1.0}[pixel])[c]);
}

TEST_CASE("the legend runs from one end to the other, and is a PNG") {
  const ColourPicture legend = heat_legend(64, 2);
  const Image image = decode_png(encode_colour_png(legend), "legend");
  CHECK(image.width == 64);
  CHECK(image.height == 2);
  CHECK(image.find("R")->bits.front() == heat_colour(0)[0]);
  CHECK(image.find("B")->bits.back() == heat_colour(1)[2]);
}

}  // namespace
}  // namespace crsh::output
