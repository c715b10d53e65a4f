// Shaders that a developer edits while the viewer runs.

#include <doctest/doctest.h>
#include <stdlib.h>
#include <unistd.h>

#include <filesystem>

#include "output/whole_file.h"
#include "viewer/view.h"

namespace crsh {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// A copy of shaders/ for one test, named to crsh-view by the environment.
struct Checkout {
  TemporaryFolder folder;
  fs::path root = folder.path() / "shaders";
  const std::string shader = (root / "shading" / "film_sum.comp").string();

  Checkout() {
    fs::copy(CRSH_SOURCE_DIR "/shaders", root, fs::copy_options::recursive);
    for (const auto& entry : fs::recursive_directory_iterator(root))
      fs::last_write_time(entry, fs::file_time_type::clock::now() - std::chrono::hours(100000));
    ::setenv("CRSH_SHADER_DIR", root.c_str(), 1);
  }
  ~Checkout() { ::unsetenv("CRSH_SHADER_DIR"); }

  std::string file(const std::string& name, const std::string& text) const {
    output::write_whole(folder / name, text);
    return folder / name;
  }
};

TEST_CASE("an edited shader is used at once; one that is wrong says why, and the old one stays") {
  const Checkout checkout;
  const std::string good = output::read_whole(checkout.shader);
  // All that is added to the film, twice.
  const std::string twice = replaced(good, "+=", "+= 2.0 *");
  // One binding more than the program gives it.
  const std::string more =
      replaced(good, "void main() {",
               "layout(binding = 3) buffer More { uint more[]; };\nvoid main() {\n  if (more[0] == 7u) return;");
  const auto a = checkout.folder / "a.png", b = checkout.folder / "b.png", c = checkout.folder / "c.png",
             d = checkout.folder / "d.png";
  // Spaces in the folder's name would be taken for words: files are copied by way of a link without.
  const fs::path link = fs::temp_directory_path() / ("crsh-shaders-" + std::to_string(::getpid()));
  fs::create_directory_symlink(checkout.folder.path(), link);
  const auto at = [&](const std::string& path) { return (link / fs::relative(path, checkout.folder.path())).string(); };
  const std::string target = at(checkout.shader);
  const std::string script = "resize 240 160\nwait\nsave " + a + "\ncopy " + at(checkout.file("twice", twice)) + " " +
                             target + "\nexpect picture\nwait\nsave " + b + "\ncopy " +
                             at(checkout.file("broken", good + "\nnonsense\n")) + " " + target +
                             "\nexpect error\nwait\nsave " + c + "\ncopy " + at(checkout.file("bindings", more)) + " " +
                             target + "\nexpect error\nwait\nsave " + d + "\n";
  const test::Outcome outcome = test::view(test::cornell, script);
  fs::remove(link);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.error_lines() == 2);
  CHECK(outcome.err.find("film_sum.comp: ERROR") != std::string::npos);
  CHECK(outcome.err.find("bindings") != std::string::npos);
  CHECK(output::read_whole(a) != output::read_whole(b));
  CHECK(output::read_whole(b) == output::read_whole(c));
  CHECK(output::read_whole(b) == output::read_whole(d));
}

}  // namespace
}  // namespace crsh
