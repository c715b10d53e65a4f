#pragma once
// The report: one page of HTML that holds all it needs and loads nothing.

#include <string>
#include <vector>

#include "bench/data.h"
#include "bench/table.h"

namespace crsh::bench {

/// A chart with its heading and the table of its figures.
struct ChartSection {
  std::string title, svg;
  Table table;
};

struct Report {
  const Description& description;
  const std::vector<SceneResults>& scenes;  ///< with pictures
  const RayFilter& filter;
  std::vector<Table> ablations;
  std::vector<ChartSection> sweeps;
  std::vector<Table> others;  ///< after the paper's three
};

[[nodiscard]] std::string report_html(const Report& report);

/// Who needs the fewest tests and the least time, a sentence a scene.
[[nodiscard]] std::string verdict(const SceneResults& scene, const RayFilter& filter);

}  // namespace crsh::bench
