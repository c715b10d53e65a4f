// Pictures that are broken, cut short or hostile: each is drawn, or left out with a reason, in bounded time and memory.

#include <doctest/doctest.h>

#include <ctime>
#include <functional>
#include <random>

#include "scene/gltf/image.h"
#include "support/image_files.h"

using namespace crsh;
using test::ramps;

namespace {

std::span<const uint8_t> bytes_of(const std::string& file) {
  return {reinterpret_cast<const uint8_t*>(file.data()), file.size()};
}

/// Why the picture is not drawn, or, in brackets, what is wrong with it all the same. A picture has the size that its
/// head told.
std::string verdict(const std::string& file) {
  try {
    const scene::ImageSize size = scene::image_size(bytes_of(file));
    const scene::DecodedImage out = scene::decode_image(bytes_of(file));
    CHECK(out.image.width == size.width);
    CHECK(out.image.height == size.height);
    CHECK(out.image.rgba.size() == size.texels() * 4);
    return out.remark.empty() ? "" : "(" + out.remark + ")";
  } catch (const scene::Fault& fault) {
    return fault.what();
  }
}

struct Sample {
  std::string name;
  std::string file;
};

/// One of each decoder's ways.
std::vector<Sample> samples() {
  const test::Samples colour = ramps(37, 29, 3), alpha = ramps(37, 29, 4);
  return {{"png", png_file(alpha)},
          {"interlaced", png_file(ramps(37, 29, 3, 65535), {.colour_type = 2, .bits = 16, .interlaced = true})},
          {"jpeg", jpeg_file(colour)},
          {"progressive", jpeg_file(colour, {.progressive = true, .restart_rows = 1})},
          {"inks", jpeg_file(alpha, {.inks = true})},
          {"webp", webp_file(alpha, true)},
          {"webp with loss", webp_file(alpha, false)},
          {"avif", test::avif_file(alpha)}};
}

bool is_jpeg(const Sample& sample) { return sample.file[0] == '\xFF'; }

double seconds_of(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Two bytes, the higher first.
std::string big16(uint32_t value) { return {static_cast<char>(value >> 8u), static_cast<char>(value)}; }

std::string big32(uint32_t value) { return big16(value >> 16u) + big16(value & 0xFFFFu); }

/// Replaces the size in a baseline or progressive frame's head.
std::string jpeg_of_size(std::string file, uint32_t width, uint32_t height, char frame) {
  const size_t at = file.find(std::string("\xFF") + frame);
  REQUIRE(at != std::string::npos);
  return file.replace(at + 5, 4, big16(height) + big16(width));
}

}  // namespace

TEST_CASE("pictures that end early: a JPEG is drawn as far as it goes, others are left out") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    CHECK(verdict(sample.file).empty());
    size_t drawn = 0;
    for (size_t length = 0; length < sample.file.size(); ++length) {
      const std::string said = verdict(sample.file.substr(0, length));
      drawn += said.empty() || said.starts_with("(");
      if (said.starts_with("(")) CHECK(said == "(is cut short)");
    }
    if (is_jpeg(sample)) CHECK(drawn > sample.file.size() / 4);
    else CHECK(drawn < 24);  // only the end marker is missing, or zeros
    const std::string most = sample.file.substr(0, sample.file.size() * 7 / 8);
    CHECK(verdict(most) == (is_jpeg(sample) ? "(is cut short)" : "is cut short"));
  }
}

TEST_CASE("a JPEG without its end marker is whole") {
  const std::string file = jpeg_file(ramps(37, 29, 3));
  CHECK(verdict(file.substr(0, file.size() - 2)).empty());
}

TEST_CASE("damaged pictures are drawn or left out") {
  std::mt19937 random(12);
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    for (int round = 0; round < 2000; ++round) {
      std::string file = sample.file;
      for (uint32_t hits = 1 + random() % 4; hits > 0; --hits) {
        char& byte = file[random() % (round % 2 == 0 ? file.size() : std::min<size_t>(file.size(), 64))];
        byte = random() % 2 == 0 ? static_cast<char>(random()) : static_cast<char>(byte ^ 1 << random() % 8);
      }
      (void)verdict(file);
    }
  }
}

TEST_CASE("heads that claim more texels than a picture may have, or than their bytes can hold") {
  const std::string start = "\x89PNG\r\n\x1A\n", behind = std::string("\x08\x06\0\0\0", 5) + std::string(300, '\0');
  const auto png = [&](uint32_t width, uint32_t height) {
    return start + std::string("\0\0\0\rIHDR", 8) + big32(width) + big32(height) + behind;
  };
  CHECK(verdict(png(65500, 1)) == "has too many texels");
  CHECK(verdict(png(16384, 16384)) == "has too many texels");
  CHECK(verdict(png(0xFFFFFFFFu, 0xFFFFFFFFu)) == "has too many texels");
  CHECK(verdict(png(8192, 8192)) == "is cut short");
  CHECK(verdict(png(0, 8)) == "has no texels");
  const std::string jpeg = jpeg_file(ramps(8, 8, 3)), progressive = jpeg_file(ramps(8, 8, 3), {.progressive = true});
  CHECK(verdict(jpeg_of_size(jpeg, 65500, 65500, '\xC0')) == "has too many texels");
  CHECK(verdict(jpeg_of_size(jpeg, 8192, 8192, '\xC0')) == "is cut short");
  CHECK(verdict(jpeg_of_size(progressive, 8192, 8192, '\xC2')) == "is cut short");
  std::string webp = webp_file(ramps(8, 8, 4), true);
  webp.replace(webp.find("VP8L") + 9, 4, "\xFF\xFF\xFF\x1F");  // 16384 x 16384
  CHECK(verdict(webp) == "has too many texels");
  std::string avif = test::avif_file(ramps(8, 8, 4));
  for (size_t at = avif.find("ispe"); at != std::string::npos; at = avif.find("ispe", at + 1))
    avif.replace(at + 8, 8, big32(16384) + big32(16384));
  CHECK_FALSE(verdict(avif).empty());
}

TEST_CASE("a JPEG of thousands of scans is given up") {
  const std::string file = jpeg_file(ramps(1024, 1024, 3), {.progressive = true});
  const size_t last = file.rfind("\xFF\xDA");
  std::string many = file.substr(0, last);
  const std::string scan = file.substr(last, file.size() - 2 - last);
  const std::string nothing = scan.substr(0, 2 + 8) + std::string(8, '\0');
  for (int i = 0; i < 20000; ++i) many += nothing;
  std::string said;
  CHECK(seconds_of([&] { said = verdict(many + "\xFF\xD9"); }) < 20);
  CHECK(said == "has too many scans");
}

TEST_CASE("formats that are not read are told from those that are broken") {
  CHECK(verdict(std::string("\xABKTX 20\xBB\r\n\x1A\n\0\0\0\0", 16)) == "is KTX2, which crsh does not read");
  CHECK(verdict("GIF89a") == "is neither PNG, JPEG, WebP nor AVIF");
  CHECK(verdict("") == "is neither PNG, JPEG, WebP nor AVIF");
}
