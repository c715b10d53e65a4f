// crsh info: the devices, and what is in a scene.

#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "output/whole_file.h"
#include "support/outside_scene.h"
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
  for (const char* part : {"UUID", "ray queries", "maximal reconvergence"})
    CHECK(text.out.find(part) != std::string::npos);
  const auto json = nlohmann::json::parse(crsh({"info", "--json"}).out);
  CHECK(json["schema"] == "crsh-info/1");
  for (const char* name : {"index", "name", "type", "driver", "uuid", "usable", "reason", "subgroup_size",
                           "ray_queries", "maximal_reconvergence", "special_values"})
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
                           "animations", "unsupported", "approximated"})
    CHECK(scene.contains(name));
}

TEST_CASE(
    "info says what is drawn in another way than it is meant: rough metal as a dimmed mirror, rough glass clear") {
  const test::TemporaryFolder folder;
  const std::string path = folder / "materials.gltf";
  const auto approximated = [&](const std::string& material) {
    output::write_whole(path, R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],"materials":[)" +
                                  material +
                                  R"(,{"pbrMetallicRoughness":{"roughnessFactor":0.5}}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,2,0.5]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,
"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAA/AAAAAAAAAEAAAAAA"}]})");
    const auto json = nlohmann::json::parse(crsh({"info", path, "--json"}).out)["scene"];
    CHECK(json["unsupported"].empty());
    return json["approximated"].get<std::vector<std::string>>();
  };
  const std::string reflection =
      "rough reflection, drawn as a sharp mirror dimmed by (1 - roughness)^2 (1 of 1 materials)";
  using Clauses = std::vector<std::string>;
  CHECK(approximated(R"({"pbrMetallicRoughness":{"metallicFactor":1,"roughnessFactor":0.4}})") == Clauses{reflection});
  CHECK(approximated(R"({"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.4}})") == Clauses{reflection});
  CHECK(approximated(R"({"pbrMetallicRoughness":{"metallicFactor":1,"roughnessFactor":0}})").empty());
  CHECK(approximated(R"({"pbrMetallicRoughness":{"metallicFactor":0}})").empty());
  const std::string glass = R"({"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.2},
"extensions":{"KHR_materials_transmission":{"transmissionFactor":1}}})";
  CHECK(approximated(glass) == Clauses{reflection, "rough glass, drawn clear (1 of 1 materials)"});
  const test::Outcome text = crsh({"info", path});
  CHECK(text.out.find("\nnot supported  nothing\napproximated   rough reflection") != std::string::npos);
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

/// Every command that reads the scene refuses it in one line, with the reason and the option that mends it at the end.
void check_refused(const test::TemporaryFolder& folder, const std::string& scene, const char* reason,
                   const char* mend) {
  for (const std::vector<std::string>& line :
       {std::vector<std::string>{"info", scene}, {"render", scene, "-o", folder / "x.png"}, {"bench", scene}}) {
    const test::Outcome outcome = crsh(line);
    CAPTURE(outcome.err);
    CHECK(outcome.status == 1);
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find(reason) != std::string::npos);
    CHECK(outcome.err.ends_with(mend));
  }
}

TEST_CASE("a scene's files outside its folder are refused, with the option that reads them") {
  const test::TemporaryFolder folder;
  const std::string scene = test::outside_scene(folder);
  check_refused(folder, scene, "'../three.bin', which it refers to: lies outside the scene's folder",
                "(--allow-outside)\n");
  CHECK(nlohmann::json::parse(crsh({"info", scene, "--json", "--allow-outside"}).out)["scene"]["triangles"] == 1);
  CHECK(crsh({"render", scene, "--allow-outside", "--size", "8x8", "-o", folder / "x.png"}).status == 0);
  CHECK(crsh({"bench", scene + " --allow-outside", "--algorithms", "brute", "--size", "8x8", "--repeat", "1"}).status ==
        0);
}

TEST_CASE("a scene that requires what is not done is refused by all its names, with the option that draws it") {
  const test::TemporaryFolder folder;
  const std::string scene = folder / "needs.gltf";
  std::ofstream(scene) << R"({"asset":{"version":"2.0"},"extensionsRequired":["EXT_none","CESIUM_RTC"]})";
  check_refused(folder, scene, "CESIUM_RTC and EXT_none", "(--lenient)\n");
  CHECK(nlohmann::json::parse(crsh({"info", scene, "--json", "--lenient"}).out)["scene"]["unsupported"].size() == 2);
}

}  // namespace
}  // namespace crsh
