#include "output/ray_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "crsh/error.h"
#include "crsh/kinds.h"
#include "output/npy.h"
#include "output/whole_file.h"
#include "output/zip_archive.h"

namespace crsh::output {
namespace {

/// Highest bounce that there are counters for: --bounces.
constexpr uint64_t max_bounces = 64;
/// How far a direction's squared length may be from 1: what normalising in float32 leaves, with room.
constexpr float length_slack = 1e-5f;
constexpr uint64_t any_word = std::numeric_limits<uint32_t>::max();

// Writing.

template <class T>
NpyType type_of() {
  return {std::is_floating_point_v<T> ? 'f' : 'u', sizeof(T)};
}

class Writer {
 public:
  template <class T>
  void add(const std::string& name, const std::vector<T>& values) {
    add(name, type_of<T>(), {values.size()}, std::as_bytes(std::span(values)));
  }
  template <class T, glm::qualifier Q>
  void add(const std::string& name, const std::vector<glm::vec<3, T, Q>>& values) {
    add(name, type_of<T>(), {values.size(), 3}, std::as_bytes(std::span(values)));
  }
  /// As words of NumPy's.
  void add(const std::string& name, const std::vector<std::string_view>& words) {
    const size_t letters = std::ranges::max(words, {}, &std::string_view::size).size();
    std::vector<uint32_t> values(words.size() * letters);
    for (size_t word = 0; word < words.size(); ++word) std::ranges::copy(words[word], &values[word * letters]);
    add(name, {'U', uint32_t(letters * 4)}, {words.size()}, std::as_bytes(std::span(values)));
  }
  /// Small numbers, a byte each.
  void add_bytes(const std::string& name, const std::vector<uint32_t>& values) {
    add(name, std::vector<uint8_t>(values.begin(), values.end()));
  }
  [[nodiscard]] std::string archive() const { return encode_zip(files_); }

 private:
  void add(const std::string& name, NpyType type, std::vector<uint64_t> shape, std::span<const std::byte> bytes) {
    std::string values(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    files_.emplace_back(name + ".npy", encode_npy({type, std::move(shape), false, std::move(values)}));
  }
  std::vector<std::pair<std::string, std::string>> files_;
};

// Reading.

/// Calls `visit` with a value of the type that the array's values have.
template <class Visit>
void with_type(NpyType type, Visit visit) {
  if (type == NpyType{'f', 4}) visit(float());
  if (type == NpyType{'f', 8}) visit(double());
  if (type == NpyType{'b', 1} || type == NpyType{'u', 1}) visit(uint8_t());
  if (type == NpyType{'u', 2}) visit(uint16_t());
  if (type == NpyType{'u', 4}) visit(uint32_t());
  if (type == NpyType{'u', 8}) visit(uint64_t());
  if (type == NpyType{'i', 1}) visit(int8_t());
  if (type == NpyType{'i', 2}) visit(int16_t());
  if (type == NpyType{'i', 4}) visit(int32_t());
  if (type == NpyType{'i', 8}) visit(int64_t());
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : name_(path.string()), archive_(read_whole(path), name_) {}

  [[nodiscard]] bool has(const std::string& array) const { return archive_.has(array + ".npy"); }

  /// Every array has as many rows as this one.
  void take_rows_of(const std::string& array) {
    const NpyArray found = load(array);
    rows_ = found.shape.empty() ? 0 : found.shape[0];
    if (rows_ >= any_word) refuse(array, "has more rays than can be numbered");
  }
  [[nodiscard]] std::vector<float> reals(const std::string& name) const {
    std::vector<float> values(rows_);
    read_reals(name, {rows_}, values.data());
    return values;
  }
  [[nodiscard]] std::vector<glm::vec3> vectors(const std::string& name) const {
    std::vector<glm::vec3> values(rows_);
    read_reals(name, {rows_, 3}, &values.data()->x);
    return values;
  }
  [[nodiscard]] glm::dvec3 place(const std::string& name) const {
    glm::dvec3 value(0);
    read_reals(name, {3}, &value.x);
    return value;
  }
  /// Whole numbers from 0 to `most`; as many as there are rays unless `count` says otherwise. `missing` where the file
  /// has no such array.
  template <class T>
  [[nodiscard]] std::vector<T> integers(const std::string& name, uint64_t most, T missing) const {
    if (!has(name)) return std::vector<T>(rows_, missing);
    return read_integers<T>(name, rows_, most);
  }
  template <class T>
  [[nodiscard]] std::vector<T> read_integers(const std::string& name, uint64_t count, uint64_t most) const {
    const NpyArray array = load(name);
    if (array.type.kind == 'f' || array.type.kind == 'S' || array.type.kind == 'U')
      refuse_type(name, array, {count}, "whole numbers");
    require_shape(name, array, {count}, "whole numbers");
    std::vector<T> values(count);
    copy(array, values.data(), [&](auto value, uint64_t row) {
      if (value < 0 || uint64_t(value) > most)
        refuse(name, fmt::format("of ray {} is {}: 0 to {} is allowed", row, value, most));
      return static_cast<T>(value);
    });
    return values;
  }
  /// Words; `?` stands for what is not in ASCII.
  [[nodiscard]] std::vector<std::string> words(const std::string& name) const {
    const NpyArray array = load(name);
    const size_t letter = array.type.kind == 'U' ? 4 : 1;
    if ((array.type.kind != 'S' && array.type.kind != 'U') || array.shape.size() != 1)
      refuse(name, fmt::format("is {}: words (n,) are needed", array.description()));
    std::vector<std::string> words(array.size());
    for (size_t i = 0; i < array.values.size(); i += letter) {
      uint32_t code = 0;
      std::memcpy(&code, &array.values[i], letter);
      if (code) words[i / array.type.bytes].push_back(code >= 0x20 && code < 0x7F ? char(code) : '?');
    }
    return words;
  }
  [[noreturn]] void refuse(const std::string& array, const std::string& reason) const {
    throw UserError(fmt::format("{}: {} {}", name_, array, reason));
  }

 private:
  using Shape = std::vector<uint64_t>;

  [[nodiscard]] NpyArray load(const std::string& name) const {
    if (!has(name))
      throw UserError(fmt::format("{}: has no array '{}': origin, direction, tmax and kind are needed", name_, name));
    return decode_npy(archive_.read(name + ".npy"), fmt::format("{}: {}", name_, name));
  }
  [[noreturn]] void refuse_type(const std::string& name, const NpyArray& array, const Shape& shape,
                                const std::string& numbers) const {
    const std::string wanted =
        shape.size() == 1 ? fmt::format("({},)", shape[0]) : fmt::format("({}, {})", shape[0], shape[1]);
    refuse(name, fmt::format("is {}: {} {} are needed", array.description(), numbers, wanted));
  }
  void require_shape(const std::string& name, const NpyArray& array, const Shape& shape,
                     const std::string& numbers) const {
    if (array.shape != shape) refuse_type(name, array, shape, numbers);
  }
  template <class T>
  void read_reals(const std::string& name, const Shape& shape, T* values) const {
    const NpyArray array = load(name);
    if (array.type != NpyType{'f', 4} && array.type != NpyType{'f', 8})
      refuse_type(name, array, shape, "float32 or float64");
    require_shape(name, array, shape, "float32 or float64");
    copy(array, values, [&](auto value, uint64_t row) {
      if (std::isnan(value)) refuse(name, fmt::format("of ray {} is not a number", row));
      return static_cast<T>(value);
    });
  }
  /// The array's values row by row, whatever their type and order, each through `convert(value, row)`.
  template <class T, class Convert>
  static void copy(const NpyArray& array, T* target, Convert convert) {
    const uint64_t columns = array.shape.size() > 1 ? array.shape[1] : 1,
                   rows = array.size() / std::max<uint64_t>(columns, 1);
    with_type(array.type, [&](auto value) {
      for (uint64_t row = 0; row < rows; ++row)
        for (uint64_t column = 0; column < columns; ++column) {
          const uint64_t at = array.columns_first ? column * rows + row : row * columns + column;
          std::memcpy(&value, &array.values[at * sizeof(value)], sizeof(value));
          target[row * columns + column] = convert(value, row);
        }
    });
  }

  std::string name_;
  ZipReader archive_;
  uint64_t rows_ = 0;
};

std::vector<std::string_view> kind_names() {
  std::vector<std::string_view> names;
  for (const RayKind& kind : ray_kinds) names.push_back(kind.name);
  return names;
}

template <class T>
bool finite(const glm::vec<3, T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_rays(const Reader& file, const RayTable& table) {
  for (uint32_t row = 0; row < table.size(); ++row) {
    if (!finite(table.origin[row])) file.refuse("origin", fmt::format("of ray {} is not finite", row));
    const glm::vec3& d = table.direction[row];
    if (!(std::abs(glm::dot(d, d) - 1) <= length_slack))
      file.refuse("direction", fmt::format("of ray {} is ({}, {}, {}): a length of 1 is needed", row, d.x, d.y, d.z));
    if (table.tmax[row] < 0) file.refuse("tmax", fmt::format("of ray {} is {}, less than 0", row, table.tmax[row]));
  }
}

/// Kinds by the names that the file has for its numbers; a file without names is one of three kinds.
std::vector<uint32_t> read_kinds(const Reader& file, uint64_t rays) {
  const std::vector<std::string> names =
      file.has("kinds") ? file.words("kinds") : std::vector<std::string>{"shadow", "reflection", "refraction"};
  if (names.empty()) file.refuse("kinds", "is empty: a name for each number in kind is needed");
  std::vector<uint32_t> kinds = file.read_integers<uint32_t>("kind", rays, names.size() - 1);
  for (size_t row = 0; row < kinds.size(); ++row) {
    const std::optional<uint32_t> known = kind_named(names[kinds[row]]);
    if (!known)
      file.refuse("kind", fmt::format("of ray {} is '{}': {} are known", row, names[kinds[row]],
                                      fmt::join(kind_names(), ", ")));
    kinds[row] = *known;
  }
  return kinds;
}

void read_centre(const Reader& file, RayTable& table) {
  if (!file.has("centre")) return;
  table.centre = file.place("centre");
  if (!finite(table.centre)) file.refuse("centre", "is not finite");
}

void read_image(const Reader& file, RayTable& table) {
  if (!file.has("image")) return;
  const auto size = file.read_integers<uint32_t>("image", 2, 1u << 16);
  table.width = size[0], table.height = size[1];
  const uint64_t pixels = uint64_t(size[0]) * size[1];
  for (uint32_t row = 0; row < table.size(); ++row)
    if (table.pixel[row] >= pixels)
      file.refuse("pixel", fmt::format("of ray {} is {}: image has {}", row, table.pixel[row], pixels));
}

}  // namespace

std::string encode_rays(const RayTable& table) {
  Writer writer;
  writer.add("origin", table.origin);
  writer.add("direction", table.direction);
  writer.add("tmax", table.tmax);
  writer.add_bytes("kind", table.kind);
  writer.add("kinds", kind_names());
  writer.add_bytes("bounce", table.bounce);
  if (std::ranges::find(table.past_backs, 1u) != table.past_backs.end())
    writer.add_bytes("past_backs", table.past_backs);
  writer.add("light", table.light);
  writer.add("pixel", table.pixel);
  writer.add("path", table.path);
  writer.add("batch", table.batch);
  writer.add("key", table.key);
  writer.add("sorted", table.sorted);
  writer.add("hit", table.hit);
  writer.add("t", table.t);
  writer.add("transmittance", table.transmittance);
  if (table.centre != glm::dvec3(0))
    writer.add("centre", std::vector<double>{table.centre.x, table.centre.y, table.centre.z});
  if (table.width) writer.add("image", std::vector<uint32_t>{table.width, table.height});
  return writer.archive();
}

void write_rays(const std::filesystem::path& path, const RayTable& table) { write_whole(path, encode_rays(table)); }

RayTable read_rays(const std::filesystem::path& path) {
  Reader file(path);
  file.take_rows_of("origin");
  RayTable table;
  table.origin = file.vectors("origin");
  table.direction = file.vectors("direction");
  table.tmax = file.reals("tmax");
  table.kind = read_kinds(file, table.size());
  table.bounce = file.integers<uint32_t>("bounce", max_bounces, 0);
  table.past_backs = file.integers<uint32_t>("past_backs", 1, 0);
  table.light = file.integers<uint32_t>("light", any_word, 0);
  table.pixel = file.integers<uint32_t>("pixel", any_word, 0);
  table.path = file.integers<uint32_t>("path", any_word, 1);
  table.batch = file.integers<uint32_t>("batch", any_word, 0);
  if (file.has("key")) table.key = file.integers<uint64_t>("key", std::numeric_limits<uint64_t>::max(), 0);
  check_rays(file, table);
  read_centre(file, table);
  read_image(file, table);
  return table;
}

}  // namespace crsh::output
