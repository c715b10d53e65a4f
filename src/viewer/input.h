#pragma once
// What the pointer and the keys do to the view.

#include <glm/glm.hpp>
#include <vector>

#include "viewer/model.h"
#include "viewer/panels/panels.h"
#include "viewer/window.h"

namespace crsh::viewer {

/// What a key asks for besides changes of the view.
enum class Action { save_png, save_exr, copy_command };

class Input {
 public:
  /// Handles the input of ImGui's current frame. Returns what keys asked for besides changes of the view.
  std::vector<Action> handle(Model& model, Window& window, const Layout& layout);

 private:
  enum class Drag { none, orbit, pan, split };

  void handle_pointer(Model& model, const Window& window, const Layout& layout);
  void begin_drag(const Model& model, const Window& window, const Layout& layout);
  void drag(Model& model, const Layout& layout) const;
  static void handle_key(Model& model, const KeyPress& press, std::vector<Action>& actions);

  Drag drag_ = Drag::none;
};

}  // namespace crsh::viewer
