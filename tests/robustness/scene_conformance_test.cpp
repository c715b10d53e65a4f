// The loader against real files: the Khronos validator's word for 349 of them, and the scenes to measure with.
// They lie outside the project: in CRSH_SHARED_SCENES, else beside it in ../shared/scenes.

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "crsh/error.h"
#include "scene/gltf/load.h"
#include "scene/scene.h"

using namespace crsh;
namespace fs = std::filesystem;

namespace {

fs::path shared_scenes() {
  if (const char* folder = std::getenv("CRSH_SHARED_SCENES")) return folder;
#ifdef CRSH_SOURCE_DIR
  return fs::path(CRSH_SOURCE_DIR) / "../shared/scenes";
#else
  return fs::path(__FILE__).parent_path() / "../../../shared/scenes";
#endif
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  if (fs::exists(path, ignored)) return true;
  MESSAGE("skipped: ", path.string(), " is not there; CRSH_SHARED_SCENES names the folder of shared scenes");
  return false;
}

/// Valid by the validator's word, yet refused, each for a reason that its line tells.
const std::set<std::string> valid_but_refused = {
    "khronos_validator/base/data/accessor/unknown_type.gltf",    // an accessor of no type of glTF's: tinygltf refuses
    "khronos_validator/base/data/asset/min_version_valid.gltf",  // needs glTF 2.1
    "khronos_validator/base/data/root/named_objects.gltf",       // draws from a buffer without data
    "khronos_validator/base/data/root/unused_objects.gltf",      // the same
};

struct Outcome {
  bool loaded = false;
  std::string line;
};

Outcome load(const fs::path& path) {
  try {
    const scene::Scene scene = scene::load(path);
    const scene::Bounds bounds = scene.bounds(scene.pose(0, {}));
    CHECK(bounds.empty() == (scene.triangle_count() == 0));
    return {true, ""};
  } catch (const UserError& error) {
    return {false, error.what()};
  }
}

}  // namespace

TEST_CASE("files that the Khronos validator calls valid load, or say what they need; others load or end with a line") {
  const fs::path folder = shared_scenes() / "gltf";
  if (!is_there(folder / "manifest.json")) return;
  const auto manifest = nlohmann::json::parse(std::ifstream(folder / "manifest.json"));
  for (const auto& [name, word] : manifest.items()) {
    CAPTURE(name);
    const Outcome outcome = load(folder / name);
    CAPTURE(outcome.line);
    if (!outcome.loaded) CHECK(outcome.line.find('\n') == std::string::npos);
    if (word["errors"] != 0 || valid_but_refused.contains(name)) continue;
    const bool needs_extension =
        outcome.line.find("needs the extension") != std::string::npos && word.contains("required");
    CHECK((outcome.loaded || needs_extension));
  }
}

TEST_CASE("the scenes to measure with load whole") {
  struct Expected {
    const char* path;
    uint64_t triangles;
    size_t meshes;
  };
  for (const Expected& expected : {Expected{"sponza/sponza_whole.glb", 66454, 1},
                                   {"sponza/sponza_objects.glb", 66454, 34},
                                   {"sponza/sponza_textured.glb", 66454, 1},
                                   {"office/office_drafting_objects.glb", 36966, 24},
                                   {"office/office_drafting_instanced.glb", 36966, 17},
                                   {"cornell/cornell_six_mirrors_790.glb", 790, 7},
                                   {"cornell/cornell_original.glb", 36, 8},
                                   {"cornell/cornell_mirror_blocks.glb", 36, 8},
                                   {"models/bunny_69k.glb", 69451, 1},
                                   {"samples/FlightHelmet/FlightHelmet.gltf", 94722, 6}}) {
    const fs::path path = shared_scenes() / expected.path;
    if (!is_there(path)) continue;
    const scene::Scene scene = scene::load(path);
    CHECK(scene.triangle_count() == expected.triangles);
    CHECK(scene.meshes.size() == expected.meshes);
  }
}

TEST_CASE("every other shared scene loads") {
  if (!is_there(shared_scenes())) return;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(shared_scenes())) {
    const fs::path& path = entry.path();
    const bool conformance = path.string().find("/gltf/") != std::string::npos;
    if (conformance || (path.extension() != ".glb" && path.extension() != ".gltf")) continue;
    const Outcome outcome = load(path);
    CAPTURE(outcome.line);
    CHECK(outcome.loaded);
  }
}
