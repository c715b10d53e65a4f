// OpenEXR files: what is written comes back, always the same bytes, nothing of this machine in them.

#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfThreading.h>
#include <doctest/doctest.h>
#include <half.h>

#include <bit>
#include <cmath>
#include <set>

#include "crsh/error.h"
#include "output/exr.h"
#include "output/memory_stream.h"
#include "output/whole_file.h"
#include "support/pictures.h"
#include "support/temporary_folder.h"

namespace crsh::output {
namespace {

const std::vector<std::string> all_layers = {"", "Z", "N", "Albedo"};
const Attributes attributes = {{"crsh:bounces", "4"}, {"crsh:rays", "shadow,reflection"}};

TEST_CASE("an EXR gives back every value: the beauty as half, the other layers as float") {
  const Picture picture = test::varied_picture(17, 5);
  const Image image = decode_exr(encode_exr(picture, all_layers, attributes).bytes, "name");
  CHECK(image.width == 17);
  CHECK(image.height == 5);
  CHECK(image.channels.size() == 11);
  for (const Layer& layer : picture.layers)
    for (size_t index = 0; index < layer.channels.size(); ++index) {
      const Channel* channel = image.find(layer.channels[index]);
      REQUIRE(channel);
      CHECK(channel->sample == (layer.name.empty() ? Sample::half : Sample::real));
      for (size_t pixel = 0; pixel < 17 * 5; ++pixel) {
        const float value = layer.values[pixel * layer.channels.size() + index];
        CHECK(channel->value(pixel) == (layer.name.empty() ? float(half(value)) : value));
      }
    }
}

TEST_CASE("only the layers that were asked for are written") {
  const Image image =
      decode_exr(encode_exr(test::varied_picture(4, 4), std::vector<std::string>{"Z"}, {}).bytes, "name");
  CHECK(image.channels.size() == 1);
  CHECK(image.find("Z"));
}

TEST_CASE("numbers are written as floats, or as such where asked for, however large") {
  Picture picture = test::varied_picture(2, 1);
  picture.layers.push_back({"Object", {"Object.id"}, {}, {7, UINT32_MAX}});
  const std::vector<std::string> layers = {"", "Object"};
  const Image real = decode_exr(encode_exr(picture, layers, {}).bytes, "name");
  CHECK(real.find("Object.id")->sample == Sample::real);
  CHECK(real.find("Object.id")->value(0) == 7);
  const Image image = decode_exr(encode_exr(picture, layers, {}, Ids::uint).bytes, "name");
  REQUIRE(image.find("Object.id"));
  CHECK(image.find("Object.id")->sample == Sample::id);
  CHECK(image.find("Object.id")->bits == std::vector<uint32_t>{7, UINT32_MAX});
}

TEST_CASE("two writes of a picture give the same bytes, with and without OpenEXR's threads") {
  const Picture picture = test::varied_picture(200, 150);
  const std::string first = encode_exr(picture, all_layers, attributes).bytes;
  for (const int threads : {0, 1, 4}) {
    Imf::setGlobalThreadCount(threads);
    CHECK(encode_exr(picture, all_layers, attributes).bytes == first);
  }
}

TEST_CASE("half values beyond 65504 are clamped and counted") {
  Picture picture = test::plain_picture(2, 1, {65504, 65505, -70000, 1});
  picture.layers[0].values[4] = INFINITY;
  picture.layers[0].values[5] = NAN;
  picture.layers[0].values[6] = 0;
  const EncodedExr encoded = encode_exr(picture, all_layers, {});
  const Image image = decode_exr(encoded.bytes, "name");
  CHECK(encoded.clamped == 3);
  CHECK(image.find("R")->value(0) == 65504);
  CHECK(image.find("G")->value(0) == 65504);
  CHECK(image.find("B")->value(0) == -65504);
  CHECK(image.find("R")->value(1) == 65504);
  CHECK(std::isnan(image.find("G")->value(1)));
}

TEST_CASE("the header holds matrices and options, and no path, date, time or device") {
  const Picture picture = test::varied_picture(3, 3);
  const std::string bytes = encode_exr(picture, all_layers, attributes).bytes;
  MemoryInput stream(bytes, "name");
  const Imf::InputFile file(stream);
  std::set<std::string> names;
  for (auto attribute = file.header().begin(); attribute != file.header().end(); ++attribute)
    names.insert(attribute.name());
  CHECK(names == std::set<std::string>{"channels", "compression", "dataWindow", "displayWindow", "lineOrder",
                                       "pixelAspectRatio", "screenWindowCenter", "screenWindowWidth", "worldToCamera",
                                       "worldToNDC", "crsh:bounces", "crsh:rays"});
  CHECK(file.header().compression() == Imf::ZIP_COMPRESSION);
  CHECK(Imf::worldToCamera(file.header())[3][1] == 2);  // a translation is in the last row, as Imath multiplies
  CHECK(Imf::worldToNDC(file.header())[0][0] == 0.5f);
}

TEST_CASE("every way to break an EXR is an error with its name, not a crash") {
  const std::string whole = encode_exr(test::varied_picture(40, 40), all_layers, {}).bytes;
  for (size_t length = 4; length < whole.size(); length += 97)
    CHECK_THROWS_WITH_AS((void)decode_exr(whole.substr(0, length), "half.exr"), doctest::Contains("half.exr: broken"),
                         UserError);
  for (size_t place = 4; place < 1200; ++place) {
    std::string broken = whole;
    broken[place] = static_cast<char>(~broken[place]);
    try {
      (void)decode_exr(broken, "broken.exr");
    } catch (const UserError& error) {
      CHECK(std::string(error.what()).starts_with("broken.exr: broken"));
    }
  }
}

TEST_CASE("an image is told by its first bytes, not by its name") {
  const test::TemporaryFolder folder;
  write_exr(folder / "picture.png", test::varied_picture(3, 2), all_layers, {});
  CHECK(read_image(folder / "picture.png").format == Format::exr);
  write_whole(folder / "text.exr", "hello");
  CHECK_THROWS_WITH_AS((void)read_image(folder / "text.exr"), doctest::Contains("not an OpenEXR or PNG image"),
                       UserError);
  write_whole(folder / "empty.exr", "");
  CHECK_THROWS_WITH_AS((void)read_image(folder / "empty.exr"), doctest::Contains("an empty file"), UserError);
  CHECK_THROWS_WITH_AS((void)read_image(folder / "none.exr"), doctest::Contains("No such file"), UserError);
  CHECK_THROWS_WITH_AS((void)read_image(folder.path()), doctest::Contains("is a folder"), UserError);
}

}  // namespace
}  // namespace crsh::output
