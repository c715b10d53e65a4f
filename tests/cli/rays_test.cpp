// --dump-rays and --replay-rays, end to end, with NumPy at the other end.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "output/whole_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace crsh {
namespace {

const std::string glass = CRSH_SOURCE_DIR "/scenes/glass.glb";
const std::string python = "/usr/bin/python3";  // Debian's, which its NumPy belongs to

bool has_numpy() { return test::run_program(python, {"-c", "import numpy"}).status == 0; }

/// Runs a few lines with `z`, the arrays of rays.npz, in the folder; what they put into `z` is saved to own.npz.
void in_numpy(const test::TemporaryFolder& folder, const std::string& lines, const std::string& save = "savez") {
  const test::Outcome outcome =
      test::run_program(python, {"-c", "import numpy as np\nz = dict(np.load('" + folder / "rays.npz" + "'))\n" +
                                           lines + "\nnp." + save + "('" + folder / "own.npz" + "', **z)"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
}

test::Outcome dump(const test::TemporaryFolder& folder) {
  return test::crsh({"render", glass, "-q", "--size", "16x12", "--bounces", "1", "--dump-rays", folder / "rays.npz",
                     "--stats", folder / "stats.json"});
}

test::Outcome replay(const std::string& file, std::vector<std::string> options) {
  options.insert(options.begin(), {"render", glass, "-q", "--bounces", "1", "--replay-rays", file});
  return test::crsh(options);
}

nlohmann::json rays_in(const std::string& json) { return nlohmann::json::parse(json)["rays"]; }

TEST_CASE("rays that are dumped and replayed have the render's statistics, and are dumped as the same bytes") {
  const test::TemporaryFolder folder;
  REQUIRE(dump(folder).status == 0);
  const test::Outcome again = replay(folder / "rays.npz", {"--stats", "-", "--dump-rays", folder / "again.npz"});
  REQUIRE(again.status == 0);
  CHECK(rays_in(again.out) == rays_in(output::read_whole(folder / "stats.json")));
  CHECK(nlohmann::json::parse(again.out)["camera"].is_null());
  CHECK(output::read_whole(folder / "again.npz") == output::read_whole(folder / "rays.npz"));
  CHECK(folder.size() == 3);
}

TEST_CASE("NumPy reads a dump, and a key of one's own, worked out there, sorts the rays without changing a hit") {
  if (!has_numpy()) {
    MESSAGE("skipped: NumPy is not here (the Debian package python3-numpy)");
    return;
  }
  const test::TemporaryFolder folder;
  REQUIRE(dump(folder).status == 0);
  // 64 bits, of another integer type, columns first, from float64: all that NumPy may write.
  in_numpy(folder,
           "cells = ((z['direction'] + 1) * 511).astype(np.int64)\n"
           "z['key'] = cells[:, 0] << 40 | cells[:, 1] << 20 | cells[:, 2]\n"
           "z['origin'] = np.asfortranarray(z['origin'].astype(np.float64))\n",
           "savez_compressed");
  const test::Outcome own =
      replay(folder / "own.npz", {"--key", "file", "--stats", folder / "own.json", "--dump-rays", folder / "rays.npz"});
  CAPTURE(own.err);
  REQUIRE(own.status == 0);
  const auto before = rays_in(output::read_whole(folder / "stats.json")),
             after = rays_in(output::read_whole(folder / "own.json"));
  for (size_t row = 0; row < before.size(); ++row) CHECK(before[row]["hits_digest"] == after[row]["hits_digest"]);
  CHECK(before != after);  // the nodes are others
  in_numpy(folder,
           "order = np.argsort(z['sorted'])\n"
           "place = list(zip(*(z[c][order].tolist() for c in ('batch', 'kind', 'light', 'key'))))\n"
           "assert place == sorted(place)\n");
}

TEST_CASE("files that hold no rays are refused in one line") {
  if (!has_numpy()) {
    MESSAGE("skipped: NumPy is not here (the Debian package python3-numpy)");
    return;
  }
  const test::TemporaryFolder folder;
  REQUIRE(dump(folder).status == 0);
  const auto check_refused = [&](const std::string& lines, const std::string& message) {
    in_numpy(folder, lines);
    const test::Outcome outcome = replay(folder / "own.npz", {"--key", "file", "--stats", "-"});
    CAPTURE(outcome.err);
    CHECK(outcome.status == 1);
    CHECK(outcome.out.empty());
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find(message) != std::string::npos);
  };
  check_refused("z['origin'][3, 1] = np.nan", "origin of ray 3 is not a number");
  check_refused("z['origin'][3, 1] = np.inf", "origin of ray 3 is not finite");
  check_refused("z['direction'] *= 2", "a length of 1 is needed");
  check_refused("z['tmax'] = z['tmax'][:5]", "tmax is float32 (5,)");
  check_refused("z['origin'] = z['origin'].astype(np.float16)", "origin is float16");
  check_refused("z['kind'] = z['kind'] + 7", "0 to 2 is allowed");
  check_refused("z['kind'] = z['kind'].astype(str)", "whole numbers");
  check_refused("z['kind'] = z['kind'].astype(complex)", "little-endian numbers are needed");
  check_refused("z['kinds'] = np.array(['shadow', 'reflection', 'glossy'])",
                "is 'glossy': shadow, reflection, refraction");
  check_refused("z['kinds'] = np.arange(3)", "words (n,) are needed");
  check_refused("z['kinds'] = np.array([], dtype=str)", "a name for each number");
  check_refused("z['pixel'][0] = 16 * 12", "pixel of ray 0 is 192: image has 192");
  check_refused("del z['tmax']", "has no array 'tmax'");
  check_refused("del z['key']", "has no array 'key'");
}

TEST_CASE("a file that is cut short, changed or no archive at all is refused in one line") {
  const test::TemporaryFolder folder;
  REQUIRE(dump(folder).status == 0);
  const std::string whole = output::read_whole(folder / "rays.npz");
  std::string changed = whole;
  changed[changed.size() / 8] ^= 0x55;
  for (const std::string& bytes :
       {whole.substr(0, whole.size() / 2), changed, std::string("no archive"), std::string()}) {
    output::write_whole(folder / "own.npz", bytes);
    const test::Outcome outcome = replay(folder / "own.npz", {"--stats", "-"});
    CAPTURE(outcome.err);
    CHECK(outcome.status == 1);
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find("own.npz: ") != std::string::npos);
  }
}

TEST_CASE("rays and pictures that do not go together are wrong usage") {
  const auto check_misuse = [](std::vector<std::string> options, const std::string& message) {
    options.insert(options.begin(), {"render", "a.glb"});
    const test::Outcome outcome = test::crsh(options);
    CAPTURE(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(message) != std::string::npos);
  };
  check_misuse({"--replay-rays", "a.npz", "-o", "a.png"}, "--replay-rays makes no picture");
  check_misuse({"--replay-rays", "a.npz"}, "give --stats FILE or --dump-rays FILE");
  check_misuse({"--key", "file", "-o", "a.png"}, "those of --replay-rays, which is missing");
  check_misuse({"--dump-rays", "a.txt"}, ".npz is written");
  check_misuse({"--dump-rays", "a.npz", "--frames", "0..3"}, "for one picture");
}

}  // namespace
}  // namespace crsh
