#include "scene/gltf/fault.h"

#include <algorithm>

namespace crsh::scene {

namespace {
// A hostile file could otherwise fill the terminal, with a note for each of its images.
constexpr size_t max_notes = 64;

bool starts_a_character(char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }
}  // namespace

std::string printable(std::string_view text, size_t limit) {
  size_t end = std::min(text.size(), limit);
  while (end < text.size() && end > 0 && !starts_a_character(text[end])) --end;
  std::string out(text.substr(0, end));
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20u || c == 0x7F) c = ' ';
  return end < text.size() ? out + "..." : out;
}

std::string in_quotes(std::string_view text, size_t limit) {
  std::string out = "'";
  out += printable(text, limit);
  out += '\'';
  return out;
}

void Notes::add(std::string_view clause) {
  const std::string line = printable(clause, 200);
  if (list_.size() > max_notes || std::find(list_.begin(), list_.end(), line) != list_.end()) return;
  list_.push_back(list_.size() < max_notes ? line : "more of that kind");
}

void Notes::leave_out(const std::string& where, const Fault& fault) {
  if (!first_fault_) first_fault_ = fault;
  std::string_view reason = fault.what();
  if (reason.starts_with(where)) reason.remove_prefix(std::min(where.size() + 1, reason.size()));
  add(where + " (" + std::string(reason) + ")");
}

}  // namespace crsh::scene
