#pragma once
// Inputs from a file, for tests (--script; the list of them is in README.md here).

#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "viewer/model.h"
#include "viewer/widgets.h"
#include "viewer/window.h"

namespace crsh::viewer {

class Script {
 public:
  /// What a step may look at and change.
  struct Stage {
    Model& model;
    Window& window;
    Widgets& widgets;
    std::function<void(const std::string&)> save, screenshot;  ///< to this path, as soon as they can
    std::function<bool()> idle;                                ///< nothing is left to save
  };

  /// Throws UserError: the file, the line, and what is wrong.
  explicit Script(const std::string& path);

  /// To be called before each frame: does what comes next, or waits. Throws UserError where a widget is not found.
  void step(Stage& stage);
  [[nodiscard]] bool done() const { return next_ == lines_.size() && steps_.empty(); }
  [[nodiscard]] const ScriptedPointer& pointer() const { return pointer_; }

 private:
  /// Returns whether it is done; if not, it is called again in the next frame.
  using Step = std::function<bool(Stage&)>;
  struct Line {
    size_t number = 0;
    std::vector<std::string> words;
    std::string rest;  ///< all after the first word
  };

  [[noreturn]] void refuse(const Line& line, const std::string& what) const;
  void check(const Line& line) const;
  void begin(const Line& line);
  void begin_pointer(const Line& line);
  void begin_window(const Line& line);
  void begin_output(const Line& line);
  void add(std::function<void(Stage&)> act);
  void add_frames(size_t count);
  void add_click(const Line& line, const std::string& name);
  void add_orbit(size_t count);
  void add_expect(const Line& line);
  void move_to(glm::vec2 place);
  void press(int button, bool down);

  std::string path_;
  std::vector<Line> lines_;
  size_t next_ = 0;
  std::deque<Step> steps_;
  std::map<std::string, uint64_t> count_;  ///< how many errors and pictures there were when a file was copied
  ScriptedPointer pointer_{.place = {-1000, -1000}};
};

}  // namespace crsh::viewer
