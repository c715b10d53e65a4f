// Files that appear whole or not at all, and the paths of outputs.

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "crsh/error.h"
#include "output/path_pattern.h"
#include "output/whole_file.h"
#include "support/temporary_folder.h"

namespace crsh::output {
namespace {

namespace fs = std::filesystem;
using doctest::Contains;

TEST_CASE("a file appears at commit and not before") {
  const test::TemporaryFolder folder;
  {
    WholeFile file(folder / "picture");
    file.write("all ");
    file.write("of it");
    CHECK_FALSE(fs::exists(folder / "picture"));
    file.commit();
  }
  CHECK(read_whole(folder / "picture") == "all of it");
  CHECK(folder.size() == 1);
}

TEST_CASE("without commit nothing stays, and what was there before is as it was") {
  const test::TemporaryFolder folder;
  write_whole(folder / "picture", "old");
  WholeFile(folder / "picture").write("new");
  CHECK(read_whole(folder / "picture") == "old");
  CHECK(folder.size() == 1);
}

TEST_CASE("an existing file keeps its permissions, a link stays a link") {
  const test::TemporaryFolder folder;
  write_whole(folder / "target", "old");
  ::chmod((folder / "target").c_str(), 0600);
  fs::create_symlink("target", folder / "link");
  write_whole(folder / "link", "new");
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(read_whole(folder / "target") == "new");
  CHECK(fs::status(folder / "target").permissions() == fs::perms(0600));
}

/// A child that has written half of a file and waits; `signal` ends it.
int status_after(int signal, const test::TemporaryFolder& folder) {
  int ready[2];
  REQUIRE(::pipe(ready) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    remove_unfinished_files_on_signals();
    WholeFile file(folder / "picture");
    file.write("half");
    if (::write(ready[1], "!", 1) == 1) ::pause();
    ::_exit(0);
  }
  char answer;
  REQUIRE(::read(ready[0], &answer, 1) == 1);
  CHECK(folder.size() == 1);  // the unfinished file
  ::kill(child, signal);
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(ready[0]);
  ::close(ready[1]);
  return status;
}

TEST_CASE("a program that is stopped by a signal leaves no file, and its end shows the signal") {
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGPIPE}) {
    const test::TemporaryFolder folder;
    const int status = status_after(signal, folder);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK(folder.size() == 0);
  }
}

TEST_CASE("a full disk is an error, and no file") {
  const test::TemporaryFolder folder;
  fs::create_symlink("/dev/full", folder / "full.png");
  CHECK_THROWS_WITH_AS(write_whole(folder / "full.png", "bytes"),
                       Contains("full.png: cannot be written (No space left"), UserError);
}

TEST_CASE("a file that grows beyond what it may is an error, and no file") {
  const test::TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_whole(folder / "picture", std::string(5000, 'x'));
    } catch (const UserError&) {
      ::_exit(folder.size() == 0 ? 42 : 43);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WEXITSTATUS(status) == 42);
}

TEST_CASE("a place that cannot be written to is known before, with the reason, and stays empty") {
  const test::TemporaryFolder folder;
  CHECK_THROWS_WITH_AS(check_writable(folder / "no/picture.png"), Contains("no does not exist: create it"), UserError);
  CHECK_THROWS_WITH_AS(check_writable(folder.path()), Contains("is a folder: name a file in it"), UserError);
  write_whole(folder / "file", "");
  CHECK_THROWS_WITH_AS(check_writable(folder / "file/picture.png"), Contains("Not a directory"), UserError);
  CHECK_THROWS_WITH_AS(check_writable(folder / (std::string(300, 'x') + ".png")), Contains("File name too long"),
                       UserError);
  CHECK_THROWS_WITH_AS(check_writable("/proc/crsh.png"), Contains("/proc/crsh.png: cannot be written"), UserError);
  CHECK_NOTHROW(check_writable(folder / "picture.png"));
  CHECK_NOTHROW(check_writable("/dev/null"));
  CHECK(folder.size() == 1);
}

TEST_CASE("a file without permission to write is refused") {
  if (::geteuid() == 0) return;  // root may write everywhere
  const test::TemporaryFolder folder;
  write_whole(folder / "file", "");
  ::chmod((folder / "file").c_str(), 0400);
  CHECK_THROWS_WITH_AS(check_writable(folder / "file"), Contains("Permission denied"), UserError);
}

TEST_CASE("{frame} is the frame's number in four digits, {frame:N} in N, in more where it needs more") {
  CHECK(PathPattern("a-{frame}.png").at(7) == "a-0007.png");
  CHECK(PathPattern("a-{frame}.png").at(123456) == "a-123456.png");
  CHECK(PathPattern("{frame:1}/{frame:6}.EXR").at(42) == "42/000042.EXR");
  CHECK(PathPattern("{braces}.png").at(1) == "{braces}.png");
  CHECK(PathPattern("a{frame}.png").has_frame());
  CHECK_FALSE(PathPattern("a.png").has_frame());
  for (const char* wrong :
       {"{frame:0}.png", "{frame:x}.png", "{frame:}.png", "{frame.png", "{frames}.png", "{frame:12}.png"})
    CHECK_THROWS_AS(PathPattern{wrong}, UserError);
}

TEST_CASE("the end of a path is its format") {
  CHECK(PathPattern("a.exr").format() == Format::exr);
  CHECK(PathPattern("a.PNG").format() == Format::png);
  CHECK(PathPattern("-").to_stdout());
  for (const char* wrong : {"", "a", "a.jpg", "exr", ".png/", "a.png.bak"})
    CHECK_THROWS_AS(PathPattern{wrong}, UserError);
}

}  // namespace
}  // namespace crsh::output
