#pragma once
// Runs crsh-view with a script, on the display that tools/lib/window-manager makes.

#include <string>
#include <vector>

#include "support/program.h"
#include "support/temporary_folder.h"

namespace crsh::test {

inline const std::string cornell = CRSH_SOURCE_DIR "/scenes/cornell.glb";
inline const std::string moving = CRSH_SOURCE_DIR "/scenes/moving.glb";

/// Quick: one bounce, one sample.
inline const std::vector<std::string> quick = {"--bounces", "1", "--samples", "1", "--quiet"};

/// crsh-view of this build: `scene` with `options`, doing the lines of `script`. With validation where the tests have
/// it.
[[nodiscard]] Outcome view(const std::string& scene, const std::string& script,
                           std::vector<std::string> options = quick);

/// Runs a command line as crsh-view prints it, with `file` in place of picture.png.
[[nodiscard]] Outcome render_copied(const std::string& line, const std::string& file);

/// Lines of `text` that begin with `start`.
[[nodiscard]] std::vector<std::string> lines_with(const std::string& text, const std::string& start);

}  // namespace crsh::test
