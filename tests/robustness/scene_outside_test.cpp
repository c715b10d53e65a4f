// A scene's URIs stay inside its folder; pipes and devices are never opened.

#include <doctest/doctest.h>
#include <sys/stat.h>

#include "complaint.h"

using namespace crsh;
using test::complaint;
using test::Folder;
using test::GltfText;
using test::one_triangle;
using test::says;
namespace fs = std::filesystem;

namespace {

/// A folder with one beside it, both with the triangle's data.
struct Neighbours {
  Folder folder;
  GltfText file = one_triangle();
  Neighbours() {
    fs::create_directories(folder.path("scene/below"));
    folder.write("outside.bin", file.buffer);
    folder.write("scene/inside.bin", file.buffer);
  }
  /// Where the scene that refers to `uri` lies.
  [[nodiscard]] fs::path naming(const std::string& uri) const {
    return folder.write("scene/s.gltf", file.text(R"(,"uri":")" + uri + "\""));
  }
};

}  // namespace

TEST_CASE("paths and links that lead out of the scene's folder are refused by name, and read where that is allowed") {
  const Neighbours there;
  fs::create_symlink("../outside.bin", there.folder.path("scene/link.bin"));
  fs::create_directory_symlink("..", there.folder.path("scene/up"));
  const std::string absolute = there.folder.path("outside.bin").string();
  for (const std::string& uri :
       {std::string("../outside.bin"), std::string("%2e%2e/outside.bin"), std::string("%2E%2e%2Foutside.bin"),
        std::string("below/../../outside.bin"), std::string("./below/.././../outside.bin"), absolute,
        std::string("link.bin"), std::string("up/outside.bin"), std::string("up/scene/../outside.bin")}) {
    CAPTURE(uri);
    const fs::path path = there.naming(uri);
    const std::string line = complaint(path);
    says(line, ", which it refers to: lies outside the scene's folder; ");
    says(line, "allow it explicitly");
    CHECK_THROWS_AS((void)scene::load(path), scene::OutsideError);
    CHECK(scene::load(path, "", scene::Reach::anywhere).triangle_count() == 1);
  }
}

TEST_CASE("what lies outside is not told from what is not there") {
  const Neighbours there;
  for (const char* uri : {"../none.bin", "/none/none.bin", "none/../../none.bin", "..", "/"})
    says(complaint(there.naming(uri)), "lies outside the scene's folder");
}

TEST_CASE("paths and links that stay inside are read") {
  const Neighbours there;
  fs::create_symlink("inside.bin", there.folder.path("scene/link.bin"));
  fs::create_directory_symlink(".", there.folder.path("scene/self"));
  for (const char* uri : {"inside.bin", "./inside.bin", "below/../inside.bin", "link.bin", "self/self/inside.bin"})
    CHECK(complaint(there.naming(uri)).empty());
  fs::create_directory_symlink("scene", there.folder.path("linked"));
  CHECK(complaint(there.folder.path("linked/s.gltf")).empty());
  fs::create_directories(there.folder.path("scene2"));
  there.folder.write("scene2/inside.bin", there.file.buffer);
  says(complaint(there.naming("../scene2/inside.bin")), "lies outside the scene's folder");
}

TEST_CASE("a scene named without a folder finds its files in the working directory") {
  const Neighbours there;
  (void)there.naming("inside.bin");
  const fs::path before = fs::current_path();
  fs::current_path(there.folder.path("scene"));
  CHECK(scene::load("s.gltf").triangle_count() == 1);
  fs::current_path(before);
}

TEST_CASE("pipes, devices, folders, circles of links and names with a zero byte are no files") {
  const Neighbours there;
  REQUIRE(mkfifo(there.folder.path("scene/pipe").c_str(), 0600) == 0);
  fs::create_symlink("circle", there.folder.path("scene/circle"));
  fs::create_symlink("/dev/zero", there.folder.path("scene/zero"));
  says(complaint(there.naming("pipe")), "'pipe', which it refers to: cannot be read as a file");
  says(complaint(there.naming("below")), "is a directory");
  says(complaint(there.naming("circle")), "'circle', which it refers to: cannot be found");
  says(complaint(there.naming("inside.bin%00")), "which it refers to: cannot be found");
  says(complaint(there.naming("zero")), "lies outside the scene's folder");
  for (const char* uri : {"/dev/zero", "/dev/stdin", "/proc/self/environ", "/proc/self/mem"})
    says(complaint(there.naming(uri)), "lies outside the scene's folder");
}

TEST_CASE("devices are no files either where all may be read") {
  const Neighbours there;
  CHECK_THROWS_WITH_AS((void)scene::load(there.naming("/dev/zero"), "", scene::Reach::anywhere),
                       doctest::Contains("cannot be read as a file"), UserError);
}

TEST_CASE("a picture outside the scene's folder is left out, with a note that names it") {
  const Neighbours there;
  GltfText file = one_triangle();
  file.primitives = R"({"attributes":{"POSITION":0},"material":0})";
  file.more =
      R"(,"materials":[{"emissiveTexture":{"index":0}}],"textures":[{"source":0}],"images":[{"uri":"../x.png"}])";
  const scene::Scene scene = scene::load(there.folder.write("scene/p.gltf", file.gltf()));
  CHECK(scene.images.empty());
  says(scene.unsupported.at(0), "'../x.png', which it refers to: lies outside the scene's folder: drawn without it");
}
