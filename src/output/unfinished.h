#pragma once
// Names of temporary files, kept where a signal handler can remove the files. For whole_file.cpp only.

#include <cstddef>
#include <filesystem>

namespace crsh::output::unfinished {

inline constexpr size_t slot_count = 16;

/// A free slot with a fresh file name in `folder`. Throws UserError where all are taken or the name is too long.
[[nodiscard]] size_t claim(const std::filesystem::path& folder);
[[nodiscard]] const char* name(size_t slot);
/// The slot's file is gone or in its place.
void release(size_t slot);

/// SIGTERM, SIGINT, SIGHUP, SIGPIPE: remove the files of all slots, then take the signal's ordinary course.
void remove_on_signals();

}  // namespace crsh::output::unfinished
