// PNG files: sRGB, exposure, alpha, and the advice on exposure.

#include <doctest/doctest.h>

#include <cmath>

#include "crsh/error.h"
#include "output/exposure.h"
#include "output/png.h"
#include "support/pictures.h"

namespace crsh::output {
namespace {

/// The bytes of the first pixel after a round trip, by channel.
uint32_t byte(const std::string& png, std::string_view channel) {
  return decode_png(png, "name").find(channel)->bits[0];
}

std::string encode(const Picture& picture, double exposure = 0) {
  return encode_png(picture.layers[0], picture.width, picture.height, exposure);
}

TEST_CASE("the sRGB curve has its known points") {
  CHECK(srgb_byte(0) == 0);
  CHECK(srgb_byte(1) == 255);
  CHECK(srgb_byte(0.5) == 188);
  CHECK(srgb_byte(0.21403) == 127);  // 127.5 of 255 lies between
  CHECK(srgb_byte(0.21405) == 128);
  CHECK(srgb_byte(0.18) == 118);
  CHECK(srgb_byte(0.0031308) == 10);
  CHECK(srgb_byte(0.0001517) == 0);
  CHECK(srgb_byte(0.0001519) == 1);
  for (const double odd : {-1.0, double(NAN), -double(INFINITY)}) CHECK(srgb_byte(odd) == 0);
  for (const double odd : {2.0, 1e30, double(INFINITY)}) CHECK(srgb_byte(odd) == 255);
}

TEST_CASE("every byte survives the way there and back") {
  Picture picture = test::plain_picture(256, 1, {0, 0, 0, 1});
  for (uint32_t value = 0; value < 256; ++value) {
    const double encoded = value / 255.0;
    const double linear = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
    picture.layers[0].values[value * 4 + 1] = static_cast<float>(linear);
  }
  const Image image = decode_png(encode(picture), "name");
  for (uint32_t value = 0; value < 256; ++value) CHECK(image.find("G")->bits[value] == value);
}

TEST_CASE("an opaque picture is RGB, any other RGBA") {
  Picture picture = test::plain_picture(3, 2, {0.5f, 0.5f, 0.5f, 1});
  CHECK(decode_png(encode(picture), "name").channels.size() == 3);
  picture.layers[0].values[7] = 0.5f;
  CHECK(decode_png(encode(picture), "name").channels.size() == 4);
}

TEST_CASE("alpha is linear, and colour is no longer premultiplied") {
  const std::string png = encode(test::plain_picture(1, 1, {0.25f, 0, 0.125f, 0.5f}));
  CHECK(byte(png, "A") == 128);
  CHECK(byte(png, "R") == srgb_byte(0.5));
  CHECK(byte(png, "B") == srgb_byte(0.25));
  CHECK(byte(encode(test::plain_picture(1, 1, {1, 1, 1, 0})), "R") == 0);
}

TEST_CASE("a stop of exposure doubles the light") {
  const Picture picture = test::plain_picture(1, 1, {0.1f, 0.1f, 0.1f, 1});
  CHECK(byte(encode(picture, 1), "R") == srgb_byte(0.2));
  CHECK(byte(encode(picture, -2), "R") == srgb_byte(0.025));
}

TEST_CASE("rows run from the top") {
  Picture picture = test::plain_picture(1, 2, {0, 0, 0, 1});
  picture.layers[0].values[0] = 1;
  CHECK(decode_png(encode(picture), "name").find("R")->bits == std::vector<uint32_t>{255, 0});
}

TEST_CASE("a broken PNG is an error with its name") {
  const std::string whole = encode(test::varied_picture(40, 40));
  for (const size_t length : {size_t(8), size_t(20), size_t(33), whole.size() / 2})
    CHECK_THROWS_WITH_AS((void)decode_png(whole.substr(0, length), "half.png"), doctest::Contains("half.png: broken"),
                         UserError);
}

TEST_CASE("a well exposed picture needs no advice") {
  CHECK_FALSE(exposure_advice(test::plain_picture(8, 8, {0.3f, 0.2f, 0.1f, 1}).layers[0], 0));
}

TEST_CASE("a picture that clips or is black gets the value that mends it") {
  for (const float brightness : {1000.0f, 3.0f, 0.0001f, 1e-6f}) {
    const Picture picture = test::plain_picture(8, 8, {brightness, brightness / 2, 0, 1});
    const auto advice = exposure_advice(picture.layers[0], 0);
    REQUIRE(advice);
    const double better = automatic_exposure(picture.layers[0]);
    CHECK(advice->better == better);
    CHECK(advice->reason.starts_with("all of the lit pixels "));
    CHECK_FALSE(exposure_advice(picture.layers[0], better));
    CHECK(brightness * std::exp2(better) == doctest::Approx(0.25).epsilon(0.05));
  }
}

TEST_CASE("a small bright object on black needs no advice, an unlit picture says so") {
  Picture picture = test::plain_picture(8, 8, {0, 0, 0, 1});
  const auto advice = exposure_advice(picture.layers[0], 0);
  REQUIRE(advice);
  CHECK(advice->reason == "every pixel is black: nothing in view is lit");
  CHECK_FALSE(advice->better);
  picture.layers[0].values[0] = 0.4f;
  CHECK_FALSE(exposure_advice(picture.layers[0], 0));
  CHECK(automatic_exposure(test::plain_picture(2, 2, {0, 0, 0, 1}).layers[0]) == 0);
}

}  // namespace
}  // namespace crsh::output
