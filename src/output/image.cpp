#include "output/image.h"

#include <ImathConfig.h>
#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <bit>

#include "crsh/error.h"
#include "output/exr.h"
#include "output/png.h"
#include "output/whole_file.h"

namespace crsh::output {

double Channel::value(size_t pixel) const {
  const uint32_t word = bits[pixel];
  switch (sample) {
    case Sample::half: return imath_half_to_float(static_cast<imath_half_bits_t>(word));
    case Sample::real: return std::bit_cast<float>(word);
    case Sample::byte: return word / 255.0;
    case Sample::word: return word / 65535.0;
    case Sample::id: break;
  }
  return word;
}

const Channel* Image::find(std::string_view name) const {
  const auto found = std::ranges::find(channels, name, &Channel::name);
  return found == channels.end() ? nullptr : &*found;
}

std::string layer_of(std::string_view channel) {
  if (channel.size() == 1 && std::string_view("RGBAY").find(channel) != std::string_view::npos) return "beauty";
  return std::string(channel.substr(0, channel.rfind('.')));
}

bool in_layer(std::string_view channel, std::string_view name) {
  if (name.ends_with(".*")) name.remove_suffix(2);
  return name == channel || name == layer_of(channel) || channel.starts_with(std::string(name) + ".");
}

Image read_image(const std::filesystem::path& path) {
  const std::string bytes = read_whole(path);
  if (bytes.starts_with("\x76\x2f\x31\x01")) return decode_exr(bytes, path.string());
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return decode_png(bytes, path.string());
  throw UserError(fmt::format("{}: {}, not an OpenEXR or PNG image", path.string(),
                              bytes.empty() ? "an empty file" : "some other file"));
}

}  // namespace crsh::output
