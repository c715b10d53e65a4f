// Ray files: what their kinds are called.

#include <doctest/doctest.h>

#include "crsh/error.h"
#include "crsh/kinds.h"
#include "output/npy.h"
#include "output/ray_file.h"
#include "output/whole_file.h"
#include "output/zip_archive.h"
#include "support/temporary_folder.h"

namespace crsh {
namespace {

using doctest::Contains;
using Files = std::vector<std::pair<std::string, std::string>>;

/// A ray of each kind.
RayTable one_of_each() {
  RayTable table;
  resize(table, kind_count);
  for (uint32_t kind = 0; kind < kind_count; ++kind) {
    table.direction[kind] = {0, 0, 1};
    table.kind[kind] = kind;
    table.path[kind] = 1;
  }
  return table;
}

/// The table's arrays, with this one in place of `kinds`; nothing: without it.
Files arrays_of(const test::TemporaryFolder& folder, const std::optional<output::NpyArray>& kinds) {
  output::write_rays(folder / "rays.npz", one_of_each());
  const std::string archive = output::read_whole(folder / "rays.npz");
  const output::ZipReader reader(archive, "rays.npz");
  Files files;
  for (const char* name : {"origin.npy", "direction.npy", "tmax.npy", "kind.npy"})
    files.emplace_back(name, reader.read(name));
  if (kinds) files.emplace_back("kinds.npy", output::encode_npy(*kinds));
  return files;
}

RayTable read_with(const std::optional<output::NpyArray>& kinds) {
  const test::TemporaryFolder folder;
  output::write_whole(folder / "own.npz", output::encode_zip(arrays_of(folder, kinds)));
  return output::read_rays(folder / "own.npz");
}

/// Words of ten letters, a byte each.
output::NpyArray words(const std::vector<std::string>& list) {
  output::NpyArray array{{'S', 10}, {list.size()}, false, {}};
  for (std::string word : list) word.resize(10), array.values += word;
  return array;
}

std::vector<std::string> names_of_all() {
  std::vector<std::string> names;
  for (const RayKind& kind : ray_kinds) names.emplace_back(kind.name);
  return names;
}

TEST_CASE("a ray file names its kinds, and is read as what was written") {
  const test::TemporaryFolder folder;
  output::write_rays(folder / "rays.npz", one_of_each());
  CHECK(output::read_rays(folder / "rays.npz").kind == one_of_each().kind);
}

TEST_CASE("kinds are read by name, whatever their numbers were") {
  std::vector<std::string> names = names_of_all();
  std::reverse(names.begin(), names.end());
  const RayTable read = read_with(words(names));
  for (uint32_t row = 0; row < kind_count; ++row) CHECK(read.kind[row] == kind_count - 1 - row);
}

TEST_CASE("a file without names is one of shadow, reflection and refraction rays") {
  if (kind_count != 3) return;  // it has a ray of each kind
  CHECK(read_with({}).kind ==
        std::vector<uint32_t>{shared::kind_shadow, shared::kind_reflection, shared::kind_refraction});
}

TEST_CASE("a kind that nobody knows is refused in one line, unless no ray is of it") {
  std::vector<std::string> names = names_of_all();
  names.push_back("glossy");
  CHECK_NOTHROW((void)read_with(words(names)));
  names[1] = "rusty\nred";
  CHECK_THROWS_WITH_AS((void)read_with(words(names)),
                       Contains("own.npz: kind of ray 1 is 'rusty?red': shadow, reflection, refraction"), UserError);
  CHECK_THROWS_WITH_AS((void)read_with(words({"shadow"})), Contains("kind of ray 1 is 1: 0 to 0 is allowed"),
                       UserError);
}

}  // namespace
}  // namespace crsh
