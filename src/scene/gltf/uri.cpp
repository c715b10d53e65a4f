#include "scene/gltf/uri.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

#include "scene/gltf/fault.h"

namespace crsh::scene {

namespace {

namespace fs = std::filesystem;
// A GLB can be no larger, and nothing that fits a renderer's memory is.
constexpr uint64_t largest_file = uint64_t{4} << 30;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percent_decoded(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (size_t i = 0; i < text.size(); ++i) {
    const int high = text[i] == '%' && i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = high >= 0 ? hex_digit(text[i + 2]) : -1;
    out += low >= 0 ? static_cast<char>(high * 16 + low) : text[i];
    if (low >= 0) i += 2;
  }
  return out;
}

/// The value of each base64 digit (RFC 4648, also the URL alphabet), 64 for all other characters.
constexpr std::array<uint8_t, 256> base64_values() {
  std::array<uint8_t, 256> values{};
  values.fill(64);
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (size_t i = 0; i < digits.size(); ++i) values[static_cast<uint8_t>(digits[i])] = static_cast<uint8_t>(i);
  values[uint8_t{'-'}] = 62;
  values[uint8_t{'_'}] = 63;
  return values;
}

Bytes base64_decoded(std::string_view text) {
  static constexpr std::array<uint8_t, 256> values = base64_values();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  Bytes out;
  out.reserve(text.size() / 4 * 3 + 3);
  uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const uint8_t value = values[static_cast<uint8_t>(c)];
    if (value == 64) throw Fault("embedded data is not base64");
    bits = bits << 6u | value;
    held += 6;
    if (held < 8) continue;
    held -= 8;
    out.push_back(static_cast<uint8_t>(bits >> static_cast<unsigned>(held)));
  }
  return out;
}

bool is_data(std::string_view uri) { return uri.starts_with("data:"); }

/// RFC 2397: data:[<media type>][;base64],<data>
Bytes data_of(std::string_view uri) {
  const size_t comma = uri.find(',');
  if (comma == std::string_view::npos) throw Fault("embedded data has no comma before its content");
  const std::string_view content = uri.substr(comma + 1);
  // Percent signs are no base64 digits, so there only a URI that uses them pays for decoding them.
  const bool plain = content.find('%') == std::string_view::npos;
  const std::string decoded = plain ? std::string() : percent_decoded(content);
  const std::string_view text = plain ? content : std::string_view(decoded);
  if (uri.substr(0, comma).ends_with(";base64")) return base64_decoded(text);
  return {text.begin(), text.end()};
}

/// The scheme of an absolute URI ("https"), else empty.
std::string_view scheme_of(std::string_view uri) {
  const size_t colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 0) return {};
  const std::string_view scheme = uri.substr(0, colon);
  const bool valid = std::all_of(scheme.begin(), scheme.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '+' || c == '-' ||
           c == '.';
  });
  return valid ? scheme : std::string_view{};
}

/// Where the path leads, all links followed as far as there is anything.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path out = fs::weakly_canonical(path, error);
  if (error) throw Fault("cannot be found", "check the path and its permissions");
  return out;
}

bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// The file that a relative URI names.
fs::path place_of(const std::string& name, const fs::path& folder, Reach reach) {
  if (name.find('\0') != std::string::npos) throw Fault("cannot be found", "check the path and its permissions");
  const fs::path own = resolved(folder.empty() ? "." : folder), path = resolved(own / name);
  if (reach == Reach::folder && !is_below(path, own)) throw OutsideFault();
  return path;
}

/// The file that a relative URI means; one named with a literal "%20" is found as well.
fs::path local_path(const std::string& uri, const fs::path& folder, Reach reach) {
  std::error_code ignored;
  const fs::path decoded = place_of(percent_decoded(uri), folder, reach);
  const fs::path literal = place_of(uri, folder, reach);
  return !fs::exists(decoded, ignored) && fs::exists(literal, ignored) ? literal : decoded;
}

}  // namespace

Bytes read_file(const fs::path& path, uint64_t most) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) throw Fault("no such file", "check the path");
  if (status.type() == fs::file_type::directory) throw Fault("is a directory", "name the .gltf or .glb file in it");
  if (status.type() != fs::file_type::regular)
    throw Fault("cannot be read as a file", "check the path and its permissions");
  const uint64_t size = std::min<uint64_t>(fs::file_size(path, error), most);
  if (error || size > largest_file) throw Fault("is larger than 4 GiB", "split the scene");
  Bytes bytes(size);
  std::ifstream in(path, std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)) && size > 0)
    throw Fault("cannot be read", "check its permissions");
  return bytes;
}

std::string uri_name(const std::string& uri) {
  return is_data(uri) ? std::string("embedded data") : in_quotes(percent_decoded(uri.substr(0, 400)));
}

Bytes read_uri(const std::string& uri, const fs::path& folder, Reach reach, uint64_t most) {
  if (is_data(uri)) return data_of(uri);
  if (const std::string_view scheme = scheme_of(uri); !scheme.empty())
    throw Fault(uri_name(uri) + " is not a local file",
                "save it beside the scene and name it without '" + printable(scheme, 16) + ":'");
  try {
    return read_file(local_path(uri, folder, reach), most);
  } catch (const OutsideFault& fault) {
    throw OutsideFault(uri_name(uri) + ", which it refers to: ");
  } catch (const Fault& fault) {
    throw Fault(uri_name(uri) + ", which it refers to: " + fault.what(), "put the file where the scene expects it");
  }
}

}  // namespace crsh::scene
