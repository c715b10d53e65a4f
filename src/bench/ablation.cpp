#include "bench/ablation.h"

#include <fmt/format.h>

namespace crsh::bench {

Table ablation_table(const std::vector<SceneResults>& scenes, const RayFilter& filter) {
  const std::vector<Result>& variants = scenes.front().results;
  Table table{.title = fmt::format("{}, each option by itself as in the paper or off", variants.front().variant.label),
              .columns = {"OPTION"}};
  for (const SceneResults& scene : scenes) {
    table.spans.push_back({upper(scene.name), 3});
    table.columns.insert(table.columns.end(), {"ALL TESTS", "RELATIVE %", "TIMES"});
  }
  for (size_t i = 0; i < variants.size(); ++i) {
    std::vector<std::string> row = {variants[i].variant.label};
    for (const SceneResults& scene : scenes) {
      const Sums sums = sums_of(scene.results[i], filter);
      row.push_back(count_text(sums.total));
      row.push_back(percent_text(sums.total, sums.brute_force));
      row.push_back(ratio_text(double(sums.total), double(sums_of(scene.results.front(), filter).total)));
    }
    table.rows.push_back(std::move(row));
  }
  table.note = "Everything is counted, in per cent of brute force. TIMES: of the first row's tests.";
  return table;
}

}  // namespace crsh::bench
