#pragma once
// Files that appear whole or not at all, and the check, before a long run, that they can be written.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace crsh::output {

/// A file that is written beside its place and renamed by commit(). Without commit(), or after a signal (see
/// remove_unfinished_files_on_signals), nothing of it stays. Devices and pipes are written directly.
class WholeFile {
 public:
  /// Throws UserError where the file cannot be made.
  explicit WholeFile(const std::filesystem::path& path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Throws UserError where it cannot be written, on a full disk for example.
  void write(std::string_view bytes);
  /// Makes sure that all is on the disk, and renames the file to its place.
  void commit();

 private:
  [[noreturn]] void fail();
  void close();

  std::filesystem::path path_;    ///< as the user wrote it
  std::filesystem::path target_;  ///< links resolved
  size_t slot_;                   ///< where the temporary file's name is kept for signals; slot_count: it has none
  int file_ = -1;
};

/// Writes a whole file in one step.
void write_whole(const std::filesystem::path& path, std::string_view bytes);

/// Writes to standard output; all data goes through here. Throws UserError where that fails.
void write_stdout(std::string_view bytes);

/// The bytes of a file. Throws UserError for folders and for what is missing or unreadable.
[[nodiscard]] std::string read_whole(const std::filesystem::path& path);

/// Throws UserError where no file can be written to `path`, for example because its folder is missing or it is a
/// folder.
void check_writable(const std::filesystem::path& path);

/// SIGTERM, SIGINT, SIGHUP and SIGPIPE remove unfinished files first, then end the program as they always do.
void remove_unfinished_files_on_signals();

}  // namespace crsh::output
