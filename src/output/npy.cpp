// The format: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html

#include "output/npy.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <charconv>
#include <regex>

#include "crsh/error.h"

namespace crsh::output {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view magic = "\x93NUMPY";
constexpr size_t alignment = 64;  // of the values in the file

/// A shape as NumPy writes it: "(100,)" or "(100, 3)".
std::string shape_text(const std::vector<uint64_t>& shape) {
  return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
  throw UserError(fmt::format("{}: {}", name, reason));
}

/// The header's text; `begin` becomes where the values begin.
std::string header_of(const std::string& bytes, const std::string& name, size_t& begin) {
  const auto byte = [&](size_t at) { return at < bytes.size() ? uint32_t(uint8_t(bytes[at])) : 0u; };
  if (!bytes.starts_with(magic) || byte(6) < 1 || byte(6) > 3) refuse(name, "is not an array of NumPy's (.npy)");
  const bool brief = byte(6) == 1;
  const size_t length = byte(8) | byte(9) << 8 | (brief ? 0 : byte(10) << 16 | byte(11) << 24);
  const size_t first = brief ? 10 : 12;
  begin = first + length;
  if (begin > bytes.size()) refuse(name, "ends within its header");
  return bytes.substr(first, length);
}

constexpr uint32_t max_letters = 256;

/// Bytes of what the type's number counts: NumPy counts letters.
uint32_t unit_of(char kind) { return kind == 'U' ? 4 : 1; }

bool is_type(char kind, uint32_t count) {
  const bool words = kind == 'S' || kind == 'U';
  return words ? count > 0 && count <= max_letters : std::has_single_bit(count) && count <= 8;
}

NpyType type_of(const std::string& text, const std::string& name) {
  static const std::regex form("[<|]([fiubSU])([0-9]{1,3})");
  std::smatch found;
  const bool read = std::regex_match(text, found, form);
  const char kind = read ? found[1].str()[0] : ' ';
  const uint32_t count = read ? uint32_t(std::stoul(found[2])) : 0;
  if (!read || !is_type(kind, count))
    refuse(name, fmt::format("has the type '{}': little-endian numbers are needed", text));
  return {kind, count * unit_of(kind)};
}

/// The numbers of a shape such as "100, 3" or "100,".
std::vector<uint64_t> shape_of(const std::string& text, const std::string& name) {
  static const std::regex number("[0-9]+");
  std::vector<uint64_t> shape;
  for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at) {
    uint64_t extent = 0;
    const std::string digits = at->str();
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), extent);
    if (error != std::errc()) refuse(name, "has a shape beyond all measure");
    shape.push_back(extent);
  }
  return shape;
}

/// Bytes that the values take; the largest number where that would be more.
uint64_t byte_count(const NpyArray& array) {
  uint64_t bytes = array.type.bytes;
  for (const uint64_t extent : array.shape)
    if (__builtin_mul_overflow(bytes, extent, &bytes)) return UINT64_MAX;
  return bytes;
}

}  // namespace

uint64_t NpyArray::size() const { return values.size() / type.bytes; }

std::string NpyArray::description() const {
  if (type.kind == 'S' || type.kind == 'U')
    return fmt::format("words of {} letters {}", type.bytes / unit_of(type.kind), shape_text(shape));
  const char* const kind = type.kind == 'f' ? "float" : type.kind == 'i' ? "int" : type.kind == 'u' ? "uint" : "bool";
  const std::string bits = type.kind == 'b' ? "" : std::to_string(type.bytes * 8);
  return fmt::format("{}{} {}", kind, bits, shape_text(shape));
}

std::string encode_npy(const NpyArray& array) {
  std::string header = fmt::format(
      "{{'descr': '{}{}{}', 'fortran_order': {}, 'shape': {}, }}", array.type.bytes == 1 ? '|' : '<', array.type.kind,
      array.type.bytes / unit_of(array.type.kind), array.columns_first ? "True" : "False", shape_text(array.shape));
  const size_t unpadded = magic.size() + 4 + header.size() + 1;
  header.append((alignment - unpadded % alignment) % alignment, ' ').push_back('\n');
  const char length[] = {char(header.size() & 0xFF), char(header.size() >> 8)};
  return std::string(magic) + std::string("\x01\x00", 2) + std::string(length, 2) + header + array.values;
}

NpyArray decode_npy(std::string bytes, const std::string& name) {
  static const std::regex form(
      R"(\{'descr': '([^']*)', 'fortran_order': (True|False), 'shape': \(([0-9, ]*)\),? *\} *\n?)");
  size_t begin = 0;
  const std::string header = header_of(bytes, name, begin);
  std::smatch found;
  if (!std::regex_match(header, found, form))
    refuse(name, "has a header that is not NumPy's, or values of several parts");
  NpyArray array{type_of(found[1], name), shape_of(found[3], name), found[2] == "True", {}};
  if (byte_count(array) != bytes.size() - begin)
    refuse(name, fmt::format("says {}, and holds {} bytes", array.description(), bytes.size() - begin));
  bytes.erase(0, begin);
  array.values = std::move(bytes);
  return array;
}

}  // namespace crsh::output
