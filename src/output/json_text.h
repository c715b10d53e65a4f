#pragma once
// JSON as text. Bytes that are not UTF-8 (in file names) are replaced.

#include <nlohmann/json.hpp>
#include <string>

namespace crsh::output {

/// Indented, with its last newline.
[[nodiscard]] inline std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// One line, with its newline.
[[nodiscard]] inline std::string json_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace crsh::output
