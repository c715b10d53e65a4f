#include "scene/gltf/shape_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "scene/gltf/checked.h"
#include "scene/gltf/fault.h"

namespace crsh::scene {

namespace {

using nlohmann::json;
constexpr double largest_index = 2147483647.0;      // tinygltf keeps them in an int
constexpr double largest_length = 1099511627776.0;  // 2^40: products with a stride still fit 64 bits
constexpr size_t max_broken = 1000;                 // what a file may have of them and still be drawn
constexpr size_t max_bytes = size_t{2} << 30u;      // of tinygltf's lists

/// Where in the file we are; written out for messages alone.
struct Where {
  const Where* outer = nullptr;
  std::string_view name = {};
  size_t index = SIZE_MAX;  // of a list's element

  [[nodiscard]] std::string written() const {
    if (outer == nullptr) return {};
    const std::string before = outer->written();
    const std::string own = index == SIZE_MAX ? std::string(name) : place(name, static_cast<int64_t>(index));
    return before.empty() ? own : before + "." + own;
  }
};

class Check {
 public:
  explicit Check(std::map<std::string, std::string>& broken) : broken_(broken) {}

  void object(json& value, const Shape& shape, const Where& where) {
    if (!value.is_object()) throw Fault(where.written() + " is not an object");
    for (auto member = value.begin(); member != value.end();) {
      const auto named = [&](const Field& field) { return is_named(field, member.key()); };
      const auto found = std::find_if(shape.fields.begin(), shape.fields.end(), named);
      if (found == shape.fields.end()) {
        member = value.erase(member);
        continue;
      }
      field(*member, *found, {&where, member.key()});
      ++member;
    }
    complete(value, shape, where);
  }

 private:
  static bool is_named(const Field& field, const std::string& key) {
    if (!field.name.ends_with('*')) return field.name == key;
    return key.starts_with(field.name.substr(0, field.name.size() - 1));
  }

  static void complete(json& value, const Shape& shape, const Where& where) {
    for (const Field& field : shape.fields) {
      if ((!field.needed && field.fill.empty()) || value.contains(field.name)) continue;
      if (field.needed) throw Fault(Where{&where, field.name}.written() + " is missing");
      value.emplace(field.name, json::parse(field.fill));
    }
  }

  void field(json& value, const Field& field, const Where& where) {
    switch (field.kind) {
      case Kind::index: return whole(value, largest_index, where);
      case Kind::length: return whole(value, largest_length, where);
      case Kind::number: return number(value, where);
      case Kind::numbers: return numbers(value, field.count, where);
      case Kind::flag: return need(value.is_boolean(), " is neither true nor false", where);
      case Kind::text: return need(value.is_string(), " is not a string", where);
      case Kind::indices: return indices(value, where);
      case Kind::texts: return texts(value, where);
      case Kind::object: return object(value, *field.shape, where);
      case Kind::list: return list(value, field, where);
    }
  }

  static void need(bool good, const char* fault, const Where& where) {
    if (!good) throw Fault(where.written() + fault);
  }

  static void whole(json& value, double largest, const Where& where) {
    const double number = value.is_number() ? value.get<double>() : -1;
    need(number >= 0 && number <= largest && std::floor(number) == number, " is not a whole number in range", where);
    value = static_cast<uint64_t>(number);
  }

  /// As a double: tinygltf cuts integers in extensions down to 32 bits.
  static void number(json& value, const Where& where) {
    const double number = value.is_number() ? value.get<double>() : NAN;
    need(std::isfinite(static_cast<float>(number)), " is not a finite number", where);
    value = number;
  }

  static void numbers(json& value, size_t count, const Where& where) {
    need(value.is_array(), " is not an array", where);
    if (count != 0 && value.size() != count)
      throw Fault(where.written() + " has " + std::to_string(value.size()) + " numbers instead of " +
                  std::to_string(count));
    for (json& element : value) number(element, where);
  }

  static void indices(json& value, const Where& where) {
    need(value.is_array(), " is not an array", where);
    for (json& element : value) whole(element, largest_index, where);
  }

  static void texts(const json& value, const Where& where) {
    need(value.is_array(), " is not an array", where);
    for (const json& element : value) need(element.is_string(), " holds something that is not a string", where);
  }

  void list(json& value, const Field& field, const Where& where) {
    need(value.is_array(), " is not an array", where);
    bytes_ += value.size() * field.shape->bytes;
    if (bytes_ > max_bytes) throw LimitFault();
    for (size_t i = 0; i < value.size(); ++i) element(value[i], field, {where.outer, where.name, i});
  }

  void element(json& value, const Field& field, const Where& where) {
    if (field.stand_in.empty()) return object(value, *field.shape, where);
    try {
      object(value, *field.shape, where);
    } catch (const Fault& fault) {
      if (broken_.size() >= max_broken) throw;
      broken_.emplace(where.written(), fault.what());
      value = json::parse(field.stand_in);
    }
  }

  std::map<std::string, std::string>& broken_;
  size_t bytes_ = 0;
};

}  // namespace

void bring_into_shape(json& root, const Shape& shape, std::map<std::string, std::string>& broken) {
  Check(broken).object(root, shape, {});
}

}  // namespace crsh::scene
