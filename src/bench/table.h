#pragma once
// Tables as text for terminals; the report shows the same ones (html.h).

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace crsh::bench {

/// A heading over several columns.
struct Span {
  std::string text;
  size_t columns = 1;
};

/// The first column names the rows; the others are figures.
struct Table {
  std::string title, note;           ///< the note may be empty
  std::vector<Span> spans;           ///< over the columns but the first; empty: none
  std::vector<std::string> columns;  ///< headings, the first one's too
  /// A row of one cell is a heading of those below it.
  std::vector<std::vector<std::string>> rows;
};

/// The table as text for a terminal, with figures flush right.
[[nodiscard]] std::string text_of(const Table& table);

/// A count as the paper prints it: "9133.13 M", "251.55 K", "790".
[[nodiscard]] std::string count_text(uint64_t count);
/// "100%", "5.14%", "0.0375%"; "-" of nothing.
[[nodiscard]] std::string percent_text(uint64_t part, uint64_t whole);
/// "2.18X", "0.0375X"; "-" of nothing.
[[nodiscard]] std::string ratio_text(double value, double reference);
/// Milliseconds with two decimals; "-" where there are none.
[[nodiscard]] std::string ms_text(double milliseconds);

/// The middle value, or the mean of the two in the middle; 0 where there are none.
[[nodiscard]] double median(std::vector<double> values);

[[nodiscard]] std::string upper(std::string_view text);

}  // namespace crsh::bench
