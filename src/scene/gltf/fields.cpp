#include "scene/gltf/fields.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/gltf/fault.h"

namespace crsh::scene {

namespace {

using nlohmann::json;
constexpr double largest_whole = 1099511627776.0;  // 2^40: products with a stride still fit 64 bits

uint64_t as_whole(const json& value, const std::string& name) {
  const double number = value.is_number() ? value.get<double>() : -1;
  if (!(number >= 0 && number <= largest_whole && std::floor(number) == number))
    throw Fault(name + " is not a whole number in range");
  return static_cast<uint64_t>(number);
}

float as_number(const json& value, const std::string& name) {
  const float number = value.is_number() ? static_cast<float>(value.get<double>()) : NAN;
  if (!std::isfinite(number)) throw Fault(name + " is not a finite number");
  return number;
}

template <class T>
T needed(std::optional<T> value, const std::string& name) {
  if (!value) throw Fault(name + " is missing");
  return *value;
}

}  // namespace

Fields::Fields(const json& object, std::string where) : object_(object), where_(std::move(where)) {
  if (!object.is_object()) throw Fault((where_.empty() ? "the JSON" : where_) + " is not an object");
}

std::string Fields::name_of(const char* key) const { return where_.empty() ? key : where_ + "." + key; }

const json* Fields::find(const char* key) const {
  const auto found = object_.get().find(key);
  return found == object_.get().end() ? nullptr : &*found;
}

const json* Fields::array(const char* key) const {
  const json* value = find(key);
  if (value != nullptr && !value->is_array()) throw Fault(name_of(key) + " is not an array");
  return value;
}

std::optional<uint64_t> Fields::whole(const char* key) const {
  const json* value = find(key);
  return value ? std::optional(as_whole(*value, name_of(key))) : std::nullopt;
}

uint64_t Fields::needed_whole(const char* key) const { return needed(whole(key), name_of(key)); }

std::optional<float> Fields::number(const char* key) const {
  const json* value = find(key);
  return value ? std::optional(as_number(*value, name_of(key))) : std::nullopt;
}

float Fields::needed_number(const char* key) const { return needed(number(key), name_of(key)); }

bool Fields::fill(const char* key, float* out, size_t count) const {
  const json* list = array(key);
  if (list == nullptr) return false;
  if (list->size() != count)
    throw Fault(name_of(key) + " has " + std::to_string(list->size()) + " numbers instead of " + std::to_string(count));
  for (size_t i = 0; i < count; ++i) out[i] = as_number((*list)[i], name_of(key));
  return true;
}

bool Fields::flag(const char* key, bool otherwise) const {
  const json* value = find(key);
  if (value == nullptr) return otherwise;
  if (!value->is_boolean()) throw Fault(name_of(key) + " is neither true nor false");
  return value->get<bool>();
}

const std::string& Fields::text(const char* key) const {
  static const std::string empty;
  const json* value = find(key);
  if (value == nullptr) return empty;
  if (!value->is_string()) throw Fault(name_of(key) + " is not a string");
  return value->get_ref<const std::string&>();
}

std::vector<std::string> Fields::texts(const char* key) const {
  std::vector<std::string> out;
  if (const json* list = array(key))
    for (const json& value : *list) {
      if (!value.is_string()) throw Fault(name_of(key) + " holds something that is not a string");
      out.push_back(value.get<std::string>());
    }
  return out;
}

std::vector<uint64_t> Fields::wholes(const char* key) const {
  std::vector<uint64_t> out;
  if (const json* list = array(key))
    for (const json& value : *list) out.push_back(as_whole(value, name_of(key)));
  return out;
}

std::optional<Fields> Fields::object(const char* key) const {
  const json* value = find(key);
  return value ? std::optional(Fields(*value, name_of(key))) : std::nullopt;
}

std::optional<Fields> Fields::extension(const char* name) const {
  const std::optional<Fields> all = object("extensions");
  return all ? all->object(name) : std::nullopt;
}

size_t Fields::size(const char* key) const {
  const json* list = array(key);
  return list ? list->size() : 0;
}

Fields Fields::element(const char* key, uint64_t index) const {
  const std::string name = name_of(key) + "[" + std::to_string(index) + "]";
  if (index >= size(key)) throw Fault(name + " is referred to but is not in the file");
  return {(*array(key))[index], name};
}

}  // namespace crsh::scene
