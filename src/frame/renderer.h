#pragma once
// A scene on a device, rendered frame by frame: the library behind the command line and the viewer.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "crsh/built.h"
#include "crsh/options.h"
#include "crsh/picture.h"
#include "crsh/ray_table.h"
#include "crsh/statistics.h"
#include "gpu/device.h"
#include "scene/scene.h"

namespace crsh {

/// Holds the scene's buffers and pipelines between frames.
class Renderer {
 public:
  /// Called with 0..1 while a frame is under way; may throw to cancel.
  using Progress = std::function<void(double)>;

  /// Uploads the scene. Throws UserError: unknown camera, too little --max-memory (naming the minimum), ...
  Renderer(gpu::Device& device, const scene::Scene& scene, const RenderOptions& options);
  ~Renderer();

  /// Renders the scene at `seconds`: the beauty and the layers that the options ask for. `dump`, if any, becomes the
  /// table of its rays.
  [[nodiscard]] Picture render(double seconds, const Progress& progress = {}, RayTable* dump = nullptr);
  /// Traces these rays through the scene at `seconds` as if they were a frame's; none is of a bounce above --bounces.
  /// `dump`, if any, becomes the same table, row by row, with what has become of the rays here.
  void replay(const RayTable& rays, double seconds, RayTable* dump = nullptr);

  /// Adds one sample to the picture that render() made last, of the same `seconds`: what render() would make of one
  /// more --samples, bit for bit. Not after a render() or refine() that threw.
  [[nodiscard]] Picture refine(double seconds, const Progress& progress = {});
  /// Other options for the same scene, as if it were a new Renderer, but for --max-memory; statistics begin anew.
  /// Throws UserError, and then the old options stay.
  void change(const RenderOptions& options);
  /// The next frame builds the object hierarchy, as if it were the first: later boxes depend on the frames before.
  void forget_objects();
  /// Called before the device is given work; may throw to cancel render() and refine(), after which render() is right
  /// again.
  void on_submit(std::function<void()> call);

  /// Every render() from here on fills `nodes` with those over all its rays; null: none does.
  void watch_nodes(std::vector<RayNode>* nodes);
  /// Boxes of the object hierarchy as the last frame left it, down to this depth; none where the algorithm has none.
  [[nodiscard]] std::vector<ObjectBox> object_boxes(uint32_t depth);

  /// Counters and times of all frames so far.
  [[nodiscard]] const Statistics& statistics() const;
  /// Every effective option, the image's final size included.
  [[nodiscard]] const RenderOptions& options() const;
  /// Lines for stderr: the default light or the resolved --light as pasteable options, and such.
  [[nodiscard]] const std::vector<std::string>& notes() const;

  struct State;  ///< frame/state.h

 private:
  std::unique_ptr<State> state_;
};

}  // namespace crsh
