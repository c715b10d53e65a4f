#pragma once
// The picture, and beside it where each algorithm spends its tests.

#include <string>

#include "bench/paper_tables.h"

namespace crsh::bench {

/// An address (data:...) that holds the bytes themselves, for pages that load nothing.
[[nodiscard]] std::string data_address(const std::string& type, const std::string& bytes);

/// The picture and a heat map an algorithm, all on one logarithmic scale, with its legend. Empty without pictures.
[[nodiscard]] std::string heat_figures_html(const SceneResults& scene);

}  // namespace crsh::bench
