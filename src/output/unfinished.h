#pragma once
// Names of temporary files, kept so that a signal handler can remove the files. Used only by whole_file.cpp.

#include <cstddef>
#include <filesystem>

namespace crsh::output::unfinished {

inline constexpr size_t slot_count = 16;

/// A free slot with a fresh file name in `folder`. Throws UserError where all are taken or the name is too long.
[[nodiscard]] size_t claim(const std::filesystem::path& folder);
[[nodiscard]] const char* name(size_t slot);
/// Forgets a slot's file, which has been removed or renamed to its place.
void release(size_t slot);

/// SIGTERM, SIGINT, SIGHUP, SIGPIPE: remove the files of all slots, then end the program as usual.
void remove_on_signals();

}  // namespace crsh::output::unfinished
