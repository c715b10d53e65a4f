#pragma once
// Rows of option tables for the usual kinds of variables. Each is bound to `variable`, which must outlive it.

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "cli/values.h"

namespace crsh::cli {

inline bool is_true(const std::string& text) { return parse_choice(text, {"false", "true"}) == 1; }

inline Option flag(std::string names, std::string help, bool& variable) {
  return {.names = std::move(names),
          .value = {},
          .help = std::move(help),
          .set = [&variable](const std::string& text) { variable = is_true(text); },
          .get = [&variable] { return variable; }};
}

inline Option allow_outside_row(bool& variable) {
  return flag("--allow-outside", "Read files that the scene names even where they lie outside its folder.", variable);
}

inline Option lenient_row(bool& variable) {
  return flag("--lenient", "Draw a scene without the extensions that it requires and that are not done here.",
              variable);
}

/// Text that may be anything; null when empty.
inline Option text(std::string names, std::string value, std::string help, std::string& variable) {
  return {
      .names = std::move(names),
      .value = std::move(value),
      .help = std::move(help),
      .set = [&variable](const std::string& given) { variable = given; },
      .get = [&variable] { return variable.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(variable); }};
}

template <class Integer>
Option integer(std::string names, std::string value, std::string help, Integer& variable, uint64_t low, uint64_t high) {
  return {.names = std::move(names),
          .value = std::move(value),
          .help = std::move(help),
          .set = [&variable, low,
                  high](const std::string& given) { variable = static_cast<Integer>(parse_integer(given, low, high)); },
          .get = [&variable] { return variable; }};
}

inline Option real(std::string names, std::string value, std::string help, float& variable, float low, float high) {
  return {.names = std::move(names),
          .value = std::move(value),
          .help = std::move(help),
          .set = [&variable, low, high](const std::string& given) { variable = parse_real(given, low, high); },
          .get = [&variable] { return json_of(variable); }};
}

/// `words` by the enumeration's (or bool's) value; `value` shows them in the help.
template <class Enum>
Option choice(std::string names, std::string value, std::string help, Enum& variable, std::vector<std::string> words) {
  return {
      .names = std::move(names),
      .value = std::move(value),
      .help = std::move(help),
      .set = [&variable, words](const std::string& given) { variable = static_cast<Enum>(parse_choice(given, words)); },
      .get = [&variable, words] { return words[static_cast<size_t>(variable)]; },
      .words = words};
}

inline Option on_off(std::string names, std::string help, bool& variable) {
  return choice(std::move(names), "on|off", std::move(help), variable, {"off", "on"});
}

/// The same row with more said of it.
[[nodiscard]] inline Option changes_pixels(Option option) { return option.pixels = true, option; }
[[nodiscard]] inline Option with_default(std::string shown, Option option) {
  return option.initial = std::move(shown), option;
}
[[nodiscard]] inline Option with_words(std::vector<std::string> words, Option option) {
  return option.words = std::move(words), option;
}
[[nodiscard]] inline Option not_effective(Option option) { return option.get = nullptr, option; }
[[nodiscard]] inline Option hidden(Option option) { return option.hidden = true, option; }

}  // namespace crsh::cli
