#pragma once
// Files that appear whole or not at all, and what is checked of their place before any work is done for them.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace crsh::output {

/// Written beside its place and renamed by commit(); without it, or on a signal (see
/// remove_unfinished_files_on_signals), nothing stays. Devices and pipes are written directly.
class WholeFile {
 public:
  /// Throws UserError where the file cannot be made.
  explicit WholeFile(const std::filesystem::path& path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Throws UserError, on a full disk for example.
  void write(std::string_view bytes);
  /// Puts the file in its place, safely on disk.
  void commit();

 private:
  [[noreturn]] void fail();
  void close();

  std::filesystem::path path_;    ///< as the user wrote it
  std::filesystem::path target_;  ///< links resolved
  size_t slot_;                   ///< where the temporary file's name is kept for signals; slot_count: it has none
  int file_ = -1;
};

/// WholeFile in one step.
void write_whole(const std::filesystem::path& path, std::string_view bytes);

/// All of standard output's data goes through here: a failing write throws UserError.
void write_stdout(std::string_view bytes);

/// The bytes of a file. Throws UserError for folders and for what is missing or unreadable.
[[nodiscard]] std::string read_whole(const std::filesystem::path& path);

/// Throws UserError where a file could not be written to `path` now: its folder is missing, it is a folder, ...
void check_writable(const std::filesystem::path& path);

/// SIGTERM, SIGINT, SIGHUP and SIGPIPE remove unfinished files first, then end the program as they always do.
void remove_unfinished_files_on_signals();

}  // namespace crsh::output
