#include "output/exr.h"

#include <ImathBox.h>
#include <ImathMatrix.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <list>
#include <thread>

#include "crsh/error.h"
#include "output/memory_stream.h"
#include "output/whole_file.h"

namespace crsh::output {
namespace {

constexpr float largest_half = 65504;

/// The same sixteen floats: GLM stores columns, and Imath, which multiplies a row vector from the left, stores rows.
Imath::M44f imath(const glm::dmat4& matrix) {
  const glm::mat4 rounded(matrix);
  Imath::M44f result;
  std::memcpy(&result.x[0][0], &rounded[0][0], sizeof(result.x));
  return result;
}

Imf::Header header_of(const Picture& picture, const Attributes& attributes) {
  Imf::Header header(static_cast<int>(picture.width), static_cast<int>(picture.height));
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addWorldToCamera(header, imath(picture.world_to_camera));
  Imf::addWorldToNDC(header, imath(picture.world_to_ndc));
  for (const auto& [name, value] : attributes) header.insert(name, Imf::StringAttribute(value));
  return header;
}

/// Adds to `clamped` where the value is beyond 65504. Not a number stays what it is.
half clamped_half(float value, uint64_t& clamped) {
  if (std::abs(value) > largest_half) ++clamped;
  return half(std::isnan(value) ? value : std::clamp(value, -largest_half, largest_half));
}

/// The values of layers as half floats, and whole numbers as floats, kept until the file is written because the frame
/// buffer points to them.
struct Converted {
  std::list<std::vector<half>> layers;
  std::list<std::vector<float>> numbers;
  uint64_t clamped = 0;
  const half* add(const std::vector<float>& values) {
    std::vector<half>& halves = layers.emplace_back(values.size());
    std::ranges::transform(values, halves.begin(), [this](float value) { return clamped_half(value, clamped); });
    return halves.data();
  }
  const float* add(const std::vector<uint32_t>& ids) { return numbers.emplace_back(ids.begin(), ids.end()).data(); }
};

/// Adds a layer's channels to the header and the frame buffer; `first` points to its interleaved values.
template <class T>
void add_channels(Imf::Header& header, Imf::FrameBuffer& buffer, const Layer& layer, uint32_t width, const T* first) {
  constexpr Imf::PixelType type = std::is_same_v<T, half>    ? Imf::HALF
                                  : std::is_same_v<T, float> ? Imf::FLOAT
                                                             : Imf::UINT;
  const size_t stride = layer.channels.size() * sizeof(T);
  for (size_t index = 0; index < layer.channels.size(); ++index) {
    header.channels().insert(layer.channels[index], Imf::Channel(type));
    char* base = reinterpret_cast<char*>(const_cast<T*>(first + index));
    buffer.insert(layer.channels[index], Imf::Slice(type, base, stride, stride * width));
  }
}

/// Lets OpenEXR compress in several threads, which takes most of the time. It writes the chunks in order all the same.
void use_all_cores() {
  static const bool once = (Imf::setGlobalThreadCount(static_cast<int>(std::thread::hardware_concurrency())), true);
  (void)once;
}

Sample sample_of(Imf::PixelType type) {
  return type == Imf::HALF ? Sample::half : type == Imf::FLOAT ? Sample::real : Sample::id;
}

/// The image's window. Throws std::runtime_error with the reason where such images are not read.
Imath::Box2i checked_window(const Imf::Header& header) {
  const Imath::Box2i window = header.dataWindow();
  const int64_t width = int64_t(window.max.x) - window.min.x + 1, height = int64_t(window.max.y) - window.min.y + 1;
  if (width < 1 || height < 1 || width > longest_side || height > longest_side)
    throw std::runtime_error(fmt::format("{}x{} pixels, more than {} a side", width, height, longest_side));
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
      throw std::runtime_error(fmt::format("channel {} is subsampled, which is not supported", channel.name()));
  return window;
}

/// Half floats come to lie in the lower 16 bits of a word: OpenEXR writes two bytes into words that are 0
/// (little-endian).
Image read_channels(Imf::InputFile& file) {
  const Imath::Box2i window = checked_window(file.header());
  Image image{.format = Format::exr,
              .width = static_cast<uint32_t>(window.max.x - window.min.x + 1),
              .height = static_cast<uint32_t>(window.max.y - window.min.y + 1),
              .left = window.min.x,
              .top = window.min.y,
              .channels = {}};
  const Imf::ChannelList& list = file.header().channels();
  for (auto channel = list.begin(); channel != list.end(); ++channel)
    image.channels.push_back({channel.name(), sample_of(channel.channel().type), {}});
  Imf::FrameBuffer buffer;
  for (Channel& channel : image.channels) {
    channel.bits.resize(size_t(image.width) * image.height);
    const Imf::PixelType type = list.findChannel(channel.name)->type;
    buffer.insert(channel.name, Imf::Slice::Make(type, channel.bits.data(), window, sizeof(uint32_t),
                                                 sizeof(uint32_t) * image.width));
  }
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return image;
}

/// A message of OpenEXR's, made one line.
std::string one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

}  // namespace

EncodedExr encode_exr(const Picture& picture, std::span<const std::string> layers, const Attributes& attributes,
                      Ids ids) {
  use_all_cores();
  Imf::Header header = header_of(picture, attributes);
  Imf::FrameBuffer buffer;
  Converted converted;
  for (const Layer& layer : picture.layers) {
    if (std::ranges::find(layers, layer.name) == layers.end()) continue;
    if (layer.name.empty()) add_channels(header, buffer, layer, picture.width, converted.add(layer.values));
    else if (!layer.ids.empty() && ids == Ids::real)
      add_channels(header, buffer, layer, picture.width, converted.add(layer.ids));
    else if (!layer.ids.empty()) add_channels(header, buffer, layer, picture.width, layer.ids.data());
    else add_channels(header, buffer, layer, picture.width, layer.values.data());
  }
  MemoryOutput stream;
  {
    Imf::OutputFile file(stream, header);  // in a scope of its own: the destructor writes the table of chunks
    file.setFrameBuffer(buffer);
    file.writePixels(static_cast<int>(picture.height));
  }
  return {stream.take(), converted.clamped};
}

uint64_t write_exr(const std::filesystem::path& path, const Picture& picture, std::span<const std::string> layers,
                   const Attributes& attributes, Ids ids) {
  const EncodedExr encoded = encode_exr(picture, layers, attributes, ids);
  write_whole(path, encoded.bytes);
  return encoded.clamped;
}

Image decode_exr(const std::string& bytes, const std::string& name) {
  try {
    MemoryInput stream(bytes, name);
    Imf::InputFile file(stream);
    return read_channels(file);
  } catch (const std::exception& error) {
    throw UserError(fmt::format("{}: broken or unsupported OpenEXR file ({})", name, one_line(error.what())));
  }
}

}  // namespace crsh::output
