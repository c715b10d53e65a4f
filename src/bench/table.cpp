#include "bench/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace crsh::bench {
namespace {

/// Characters, not bytes, of UTF-8: labels may hold file names.
size_t length(std::string_view text) {
  return static_cast<size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string left(const std::string& text, size_t width) {
  return text + std::string(width - std::min(width, length(text)), ' ');
}
std::string right(const std::string& text, size_t width) {
  return std::string(width - std::min(width, length(text)), ' ') + text;
}

std::vector<size_t> widths_of(const Table& table) {
  std::vector<size_t> widths;
  const auto widen = [&](const std::vector<std::string>& cells) {
    widths.resize(std::max(widths.size(), cells.size()), 0);
    for (size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], length(cells[i]));
  };
  widen(table.columns);
  for (const auto& row : table.rows)
    if (row.size() > 1) widen(row);
  // Where a heading over several columns needs more room than these, the last of them becomes wider.
  size_t first = 1;
  for (const Span& span : table.spans) {
    size_t room = 2 * (span.columns - 1);
    for (size_t i = first; i < first + span.columns; ++i) room += widths[i];
    first += span.columns;
    if (length(span.text) > room) widths[first - 1] += length(span.text) - room;
  }
  return widths;
}

void trim_right(std::string& line) { line.erase(line.find_last_not_of(' ') + 1); }

std::string line_of(const std::vector<std::string>& cells, const std::vector<size_t>& widths) {
  std::string line = left(cells.front(), cells.size() > 1 ? widths[0] : 0);
  for (size_t i = 1; i < cells.size(); ++i) line += "  " + right(cells[i], widths[i]);
  trim_right(line);
  return line + "\n";
}

std::string spans_line(const Table& table, const std::vector<size_t>& widths) {
  std::string line(widths[0], ' ');
  size_t first = 1;
  for (const Span& span : table.spans) {
    size_t room = 2 * (span.columns - 1);
    for (size_t i = first; i < first + span.columns; ++i) room += widths[i];
    line += "  " + right(span.text, room);
    first += span.columns;
  }
  return line + "\n";
}

/// A number with at least three significant digits and at least two decimals.
std::string figure(double value) {
  if (value >= 1000) return fmt::format("{:.0f}", value);
  if (value >= 1 || value == 0) return fmt::format("{:.2f}", value);
  return value >= 1e-4 ? fmt::format("{:#.3g}", value) : fmt::format("{:.2e}", value);
}

}  // namespace

std::string text_of(const Table& table) {
  const std::vector<size_t> widths = widths_of(table);
  std::string text = table.title + "\n";
  if (!table.spans.empty()) text += spans_line(table, widths);
  text += line_of(table.columns, widths);
  for (const auto& row : table.rows) text += line_of(row, widths);
  return table.note.empty() ? text : text + table.note + "\n";
}

std::string count_text(uint64_t count) {
  if (count >= 1'000'000) return fmt::format("{:.2f} M", double(count) / 1e6);
  if (count >= 10'000) return fmt::format("{:.2f} K", double(count) / 1e3);
  return fmt::format("{}", count);
}

std::string percent_text(uint64_t part, uint64_t whole) {
  if (whole == 0) return "-";
  return part == whole ? "100%" : figure(100 * double(part) / double(whole)) + "%";
}

std::string ratio_text(double value, double reference) { return reference > 0 ? figure(value / reference) + "X" : "-"; }

std::string ms_text(double milliseconds) { return fmt::format("{:.2f}", milliseconds); }

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace crsh::bench
