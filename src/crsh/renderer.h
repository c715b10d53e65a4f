#pragma once
// The library: reads a scene, and renders it frame by frame on a device. What is behind it, Vulkan included, is in
// frame/.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "crsh/built.h"
#include "crsh/device.h"
#include "crsh/options.h"
#include "crsh/picture.h"
#include "crsh/ray_table.h"
#include "crsh/statistics.h"

namespace crsh {

namespace scene {
struct Scene;
}

/// A scene in memory. Nobody changes it any more, so that threads may share it.
using ScenePtr = std::shared_ptr<const scene::Scene>;

/// What of a file becomes the scene.
struct ReadOptions {
  std::string scene;                ///< which of the file's, by index or name; empty: its default
  std::string variant;              ///< of its materials, by index or name; empty: the usual ones
  std::vector<std::string> hidden;  ///< objects that are left out, by index or name
  bool allow_outside = false;       ///< files that the scene names may lie outside its own folder
  bool lenient = false;             ///< draw it without the extensions that it requires and that are not done here
};

/// Reads .gltf or .glb. Throws UserError: the file, what is wrong with it, what helps.
[[nodiscard]] ScenePtr read_scene(const std::filesystem::path& path, const ReadOptions& options = {});
/// What the file asks for and is not done, a short clause each.
[[nodiscard]] const std::vector<std::string>& unsupported_in(const ScenePtr& scene);

/// A scene on a device. It keeps both, and holds the scene's buffers and the pipelines between frames. Whatever is
/// thrown derives from std::exception; what the user can mend is a UserError.
class Renderer {
 public:
  /// Called with 0..1 while a frame is under way; may throw to cancel.
  using Progress = std::function<void(double)>;

  /// Uploads the scene. Throws UserError: unknown camera, too little memory (naming the minimum), ... Of the options,
  /// `scene`, `variant` and `hidden` are read_scene's business.
  Renderer(DevicePtr device, ScenePtr scene, const RenderOptions& options);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Renders the scene at `seconds` of its animation: the beauty and the layers that the options ask for. `dump`, if
  /// any, becomes the table of its rays.
  [[nodiscard]] Picture render(double seconds = 0, const Progress& progress = {}, RayTable* dump = nullptr);
  /// Traces these rays through the scene at `seconds` as if they were a frame's; none is of a bounce above
  /// RenderOptions::bounces. `dump`, if any, becomes the same table, row by row, with what has become of the rays here.
  void replay(const RayTable& rays, double seconds, RayTable* dump = nullptr);

  /// Adds one sample to the picture that render() made last, of the same `seconds`: what render() would make of one
  /// sample more, bit for bit. Not after a render() or refine() that threw.
  [[nodiscard]] Picture refine(double seconds, const Progress& progress = {});
  /// Other options for the same scene, as if it were a new Renderer; statistics begin anew. Throws UserError, and then
  /// the old options stay.
  void change(const RenderOptions& options);
  /// Makes the next frame build the object hierarchy anew, as the first one does. Else its boxes would depend on the
  /// frames before.
  void forget_objects();
  /// `call` is called before the device is given work. It may throw, which cancels render() or refine(); after that
  /// render() may be called again, but not refine().
  void on_submit(std::function<void()> call);

  /// From here on every render() fills `nodes` with the nodes over all its rays; null: no longer.
  void watch_nodes(std::vector<RayNode>* nodes);
  /// Boxes of the object hierarchy as the last frame left it, down to this depth; none where the algorithm has none.
  [[nodiscard]] std::vector<ObjectBox> object_boxes(uint32_t depth);

  /// Counters and times of all frames so far.
  [[nodiscard]] const Statistics& statistics() const;
  /// Every effective option, the image's final size included.
  [[nodiscard]] const RenderOptions& options() const;
  /// The eye and target that were chosen here, as options that ask for the same view, to the last bit; none where the
  /// options or the scene's camera say them.
  [[nodiscard]] const std::optional<ViewOption>& chosen_view() const;
  /// Lights that were chosen here, as options that ask for the same: those of RenderOptions::lights without intensity,
  /// or, without any there and in the scene, the one beside the eye.
  [[nodiscard]] const std::vector<LightOption>& chosen_lights() const;
  /// Where rays, nodes and boxes are measured from, in the file's coordinates: not zero where the scene lies so far
  /// from the file's own origin that floats could not tell its places apart.
  [[nodiscard]] glm::dvec3 centre() const;
  /// What else was settled here and changes the picture, a line each: textures made smaller, animations chosen.
  [[nodiscard]] const std::vector<std::string>& notes() const;

  struct State;  ///< frame/state.h

 private:
  std::unique_ptr<State> state_;
};

}  // namespace crsh
