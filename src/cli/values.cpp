#include "cli/values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "crsh/error.h"

namespace crsh::cli {
namespace {

/// `text` as a number, if all of it is one.
template <class T>
std::optional<T> whole_number(const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return {};
  return value;
}

/// A number that is finite as a float, too.
template <class T = float>
std::optional<T> finite(const std::string& text) {
  const auto value = whole_number<T>(text);
  return value && std::isfinite(static_cast<float>(*value)) ? value : std::nullopt;
}

template <class T>
glm::vec<3, T> parse_three(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  glm::vec<3, T> vector(0);
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto value = parts.size() == 3 ? finite<T>(parts[axis]) : std::nullopt;
    if (!value) refuse("three finite numbers with commas between are allowed, as in 0,1.5,-2");
    vector[static_cast<int>(axis)] = *value;
  }
  return vector;
}

}  // namespace

void refuse(const std::string& allowed) { throw UserError(allowed, Exit::usage); }

uint64_t parse_integer(const std::string& text, uint64_t low, uint64_t high) {
  const auto value = whole_number<uint64_t>(text);
  if (!value || *value < low || *value > high)
    refuse(fmt::format("a whole number from {} to {} is allowed", low, high));
  return *value;
}

float parse_real(const std::string& text) {
  const auto value = finite(text);
  if (!value) refuse("a finite number is allowed");
  return *value;
}

float parse_real(const std::string& text, float low, float high) {
  const auto value = finite(text);
  if (!value || *value < low || *value > high) refuse(fmt::format("a number from {} to {} is allowed", low, high));
  return *value;
}

glm::vec3 parse_vector(const std::string& text) { return parse_three<float>(text); }

glm::dvec3 parse_place(const std::string& text) { return parse_three<double>(text); }

bool parse_switch(const std::string& text) { return parse_choice(text, {"off", "on"}) == 1; }

size_t parse_choice(const std::string& text, const std::vector<std::string>& allowed) {
  const auto found = std::ranges::find(allowed, text);
  if (found == allowed.end()) refuse(fmt::format("allowed is {}", fmt::join(allowed, ", ")));
  return static_cast<size_t>(found - allowed.begin());
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  size_t begin = 0;
  for (size_t end; (end = text.find(separator, begin)) != std::string::npos; begin = end + 1)
    parts.push_back(text.substr(begin, end - begin));
  parts.push_back(text.substr(begin));
  return parts;
}

nlohmann::ordered_json json_of(float value) { return *whole_number<double>(fmt::format("{}", value)); }

std::string text_of(const glm::vec3& vector) { return fmt::format("{},{},{}", vector.x, vector.y, vector.z); }

std::string text_of(const glm::dvec3& place) { return fmt::format("{},{},{}", place.x, place.y, place.z); }

std::string text_of(const LightOption& light) {
  const std::string place = text_of(light.position);
  return light.candela ? fmt::format("{},{}{}", place, *light.candela, light.past_backs ? ",past-backs" : "") : place;
}

std::string text_of(const nlohmann::ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  if (!value.is_structured()) return value.dump();
  std::vector<std::string> parts;
  for (const auto& [key, part] : value.items())
    parts.push_back(value.is_object() ? fmt::format("{}={}", key, text_of(part)) : text_of(part));
  return fmt::format("{}", fmt::join(parts, value.is_object() ? "," : " "));
}

}  // namespace crsh::cli
