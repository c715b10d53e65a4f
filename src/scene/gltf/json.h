#pragma once
// A glTF file's JSON: its parsing, and what its head says.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>

namespace crsh::scene {

/// Parses the text. A Fault where it is no JSON object, nests deeper than 64 levels or has more than 16 million values:
/// these are counted before anything is built of them.
[[nodiscard]] nlohmann::json parse_json(std::span<const uint8_t> text);

/// A Fault where the file is of another glTF than 2.0.
void check_version(const nlohmann::json& root);

}  // namespace crsh::scene
