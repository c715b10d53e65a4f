#pragma once
// What the program says on standard error: plain lines, or with --progress json an object a line.

#include <string>
#include <vector>

#include "cli/render_options.h"
#include "crsh/error.h"
#include "output/progress.h"

namespace crsh::cli {

/// A note, unless --quiet. As JSON: {"event":"note","text":...}.
void say(const RenderCommand& command, const std::string& text);

/// The last line of a command that failed. As JSON: {"event":"error","text":...,"status":...}.
void say_error(const std::string& text, Exit status, bool as_json);

/// Whether these words of a command line ask for JSON: also where others of them are wrong.
[[nodiscard]] bool asks_for_json(const std::vector<std::string>& words);

/// How progress is shown: a bar only on a terminal.
[[nodiscard]] output::Progress::Mode progress_mode(const RenderCommand& command);

}  // namespace crsh::cli
