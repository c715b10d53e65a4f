// crsh info: the devices, and what is in a scene.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "output/whole_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace crsh {
namespace {

using test::crsh;
const std::string cornell = CRSH_SOURCE_DIR "/scenes/cornell.glb";

TEST_CASE("info lists the devices, as text and as JSON") {
  const test::Outcome text = crsh({"info"});
  CHECK(text.status == 0);
  CHECK(text.out.starts_with("0: "));
  CHECK(text.out.find("UUID") != std::string::npos);
  const auto json = nlohmann::json::parse(crsh({"info", "--json"}).out);
  CHECK(json["schema"] == "crsh-info/1");
  for (const char* name : {"index", "name", "type", "driver", "uuid", "usable", "reason", "subgroup_size"})
    CHECK(json["devices"][0].contains(name));
}

TEST_CASE("info counts what is in a scene") {
  const test::Outcome text = crsh({"info", cornell});
  CHECK(text.status == 0);
  CHECK(text.err.empty());
  CHECK(text.out.find("triangles") != std::string::npos);
  const auto scene = nlohmann::json::parse(crsh({"info", cornell, "--json"}).out)["scene"];
  CHECK(scene["triangles"] > 100);
  CHECK(scene["bounds"]["low"].size() == 3);
  for (const char* name : {"path", "scenes", "meshes", "instances", "materials", "textures", "lights", "cameras",
                           "animations", "unsupported"})
    CHECK(scene.contains(name));
}

TEST_CASE("a scene that cannot be read is one line, exit status 1") {
  const test::TemporaryFolder folder;
  output::write_whole(folder / "empty.glb", "");
  output::write_whole(folder / "text.gltf", "hello");
  for (const std::string& path :
       {folder / "none.glb", folder / "empty.glb", folder / "text.gltf", folder.path().string()}) {
    const test::Outcome outcome = crsh({"info", path});
    CAPTURE(path);
    CHECK(outcome.status == 1);
    CHECK(outcome.out.empty());
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find(path) != std::string::npos);
  }
}

}  // namespace
}  // namespace crsh
