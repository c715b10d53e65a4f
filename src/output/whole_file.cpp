#include "output/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "crsh/error.h"
#include "output/unfinished.h"

namespace crsh::output {
namespace {

namespace fs = std::filesystem;

std::string_view mend(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT: return "free some space or choose another path";
    case ENAMETOOLONG: return "choose a shorter name";
    default: return "choose another path";
  }
}

[[noreturn]] void fail_to_write(const fs::path& path, int error) {
  throw UserError(fmt::format("{}: cannot be written ({}): {}", path.string(), std::strerror(error), mend(error)));
}

/// Where `path` leads when it is a link, also to a file that is not there yet.
fs::path resolved(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_symlink(path, ignored)) return path;
  const fs::path target = fs::weakly_canonical(path, ignored);
  return ignored ? path : target;
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// Whether it is a device, pipe or socket, which is written directly and not replaced by a new file.
bool is_special(const fs::path& path) {
  std::error_code ignored;
  return fs::is_other(path, ignored);
}

/// Returns false with errno set where not all could be written.
bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return true;
}

void check_place(const fs::path& path) {
  const fs::path folder = folder_of(resolved(path));
  struct stat status = {};
  if (::stat(path.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) throw UserError(fmt::format("{}: is a folder: name a file in it", path.string()));
    if (::access(path.c_str(), W_OK) != 0) fail_to_write(path, errno);
  } else if (errno != ENOENT) {
    fail_to_write(path, errno);
  } else if (::stat(folder.c_str(), &status) != 0) {
    throw UserError(fmt::format("{}: the folder {} does not exist: create it or choose another path", path.string(),
                                folder.string()));
  }
}

/// Gives the new file the permissions of the one that it replaces.
void copy_mode(const fs::path& from, int to) {
  struct stat status = {};
  if (::stat(from.c_str(), &status) == 0) [[maybe_unused]]
    const int ignored = ::fchmod(to, status.st_mode & 07777);
}

}  // namespace

WholeFile::WholeFile(const fs::path& path) : path_(path), target_(resolved(path)), slot_(unfinished::slot_count) {
  check_place(path);
  if (is_special(target_)) {
    file_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    slot_ = unfinished::claim(folder_of(target_));
    file_ = ::open(unfinished::name(slot_), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666);
  }
  if (file_ < 0) fail();
  if (slot_ < unfinished::slot_count) copy_mode(target_, file_);
}

WholeFile::~WholeFile() { close(); }

void WholeFile::write(std::string_view bytes) {
  if (!write_all(file_, bytes)) fail();
}

void WholeFile::commit() {
  if (slot_ < unfinished::slot_count) {
    if (::fsync(file_) != 0 || ::rename(unfinished::name(slot_), target_.c_str()) != 0) fail();
    unfinished::release(std::exchange(slot_, unfinished::slot_count));
  }
  if (::close(std::exchange(file_, -1)) != 0) fail();
}

/// Throws for errno. It also cleans up, because no destructor runs where the constructor throws.
void WholeFile::fail() {
  const int error = errno;
  close();
  fail_to_write(path_, error);
}

void WholeFile::close() {
  if (file_ >= 0) ::close(std::exchange(file_, -1));
  if (slot_ == unfinished::slot_count) return;
  ::unlink(unfinished::name(slot_));
  unfinished::release(std::exchange(slot_, unfinished::slot_count));
}

void write_whole(const fs::path& path, std::string_view bytes) {
  WholeFile file(path);
  file.write(bytes);
  file.commit();
}

void write_stdout(std::string_view bytes) {
  if (!write_all(STDOUT_FILENO, bytes))
    throw UserError(fmt::format("standard output: cannot be written ({})", std::strerror(errno)));
}

std::string read_whole(const fs::path& path) {
  const auto refuse = [&](std::string_view reason) { throw UserError(fmt::format("{}: {}", path.string(), reason)); };
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) refuse("is a folder, not a file");
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) refuse(fmt::format("cannot be read ({})", std::strerror(errno)));
  std::string bytes;
  std::array<char, 1 << 16> part;
  ssize_t length;
  while ((length = ::read(file, part.data(), part.size())) > 0) bytes.append(part.data(), static_cast<size_t>(length));
  const int error = errno;
  ::close(file);
  if (length < 0) refuse(fmt::format("cannot be read ({})", std::strerror(error)));
  return bytes;
}

void check_writable(const fs::path& path) {
  check_place(path);
  if (!is_special(resolved(path))) WholeFile file(path);  // not of a pipe, as opening it would wait for a reader
}

void remove_unfinished_files_on_signals() { unfinished::remove_on_signals(); }

}  // namespace crsh::output
