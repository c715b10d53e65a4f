#include "crsh/ray_table.h"

#include <utility>

namespace crsh {

void resize(RayTable& table, size_t rows) {
  for_columns(table, [&](auto& column) { column.resize(rows); });
}

RayTable rows_of(const RayTable& table, std::span<const uint32_t> numbers) {
  RayTable chosen = table;
  for_columns(chosen, [&](auto& column) {
    if (column.empty()) return;
    const auto values = std::exchange(column, {});
    column.reserve(numbers.size());
    for (const uint32_t row : numbers) column.push_back(values[row]);
  });
  return chosen;
}

}  // namespace crsh
