// --hide: what a word means.

#include <doctest/doctest.h>

#include "crsh/error.h"
#include "scene/hide.h"

namespace crsh::scene {
namespace {

/// Two instances below "group", one beside it, which is called as an index is.
Scene three() {
  Scene scene;
  scene.nodes = {{.name = "group"}, {.name = "a", .parent = 0}, {.name = "b", .parent = 0}, {.name = "1"}};
  scene.instances = {{.mesh = 0, .node = 1}, {.mesh = 0, .node = 2}, {.mesh = 0, .node = 3}};
  return scene;
}

TEST_CASE("--hide means an index, else a name with all that is below it") {
  using Hidden = std::vector<bool>;
  const auto hidden = [](std::vector<std::string> words) { return hidden_instances(three(), words); };
  CHECK(hidden({}) == Hidden{false, false, false});
  CHECK(hidden({"a"}) == Hidden{true, false, false});
  CHECK(hidden({"group"}) == Hidden{true, true, false});
  CHECK(hidden({"1"}) == Hidden{false, true, false});
  CHECK(hidden({"b", "2"}) == Hidden{false, true, true});
  CHECK_THROWS_AS((void)hidden({"c"}), UserError);
  CHECK_THROWS_AS((void)hidden({"3"}), UserError);
}

TEST_CASE("what is hidden is no longer there") {
  Scene scene = three();
  hide(scene, std::vector<std::string>{"group"});
  REQUIRE(scene.instances.size() == 1);
  CHECK(scene.instances[0].node == 3);
}

}  // namespace
}  // namespace crsh::scene
