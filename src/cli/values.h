#pragma once
// Values of options, read strictly. Each function throws UserError (wrong usage) that says what is allowed.

#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "crsh/options.h"

namespace crsh::cli {

/// Throws the error of a wrong value: `allowed` completes "OPTION VALUE: ".
[[noreturn]] void refuse(const std::string& allowed);

/// A whole number from `low` to `high`: digits only.
[[nodiscard]] uint64_t parse_integer(const std::string& text, uint64_t low, uint64_t high);
/// A finite decimal number, nothing before or after it.
[[nodiscard]] float parse_real(const std::string& text);
[[nodiscard]] float parse_real(const std::string& text, float low, float high);
/// A vector: "x,y,z". A place may need more digits than floats have.
[[nodiscard]] glm::vec3 parse_vector(const std::string& text);
[[nodiscard]] glm::dvec3 parse_place(const std::string& text);
/// A switch: "on" or "off".
[[nodiscard]] bool parse_switch(const std::string& text);
/// The index of `text` in `allowed`.
[[nodiscard]] size_t parse_choice(const std::string& text, const std::vector<std::string>& allowed);

/// The parts between separators; there is at least one, and it may be empty.
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);

/// The shortest decimal number that is this float, so that 0.1 stays 0.1.
[[nodiscard]] nlohmann::ordered_json json_of(float value);
[[nodiscard]] std::string text_of(const glm::vec3& vector);
[[nodiscard]] std::string text_of(const glm::dvec3& place);
[[nodiscard]] std::string text_of(const LightOption& light);
/// A value as it could be given on the command line: without quotes, lists with spaces between, objects as KEY=VALUE
/// with commas between.
[[nodiscard]] std::string text_of(const nlohmann::ordered_json& value);

}  // namespace crsh::cli
