#pragma once
// ImGui's widgets under names by which a script finds them.

#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace crsh::viewer {

/// Widgets with their labels to the left, in a column. Each returns whether its value has changed.
class Widgets {
 public:
  /// Forgets the widgets of the frame before.
  void begin_frame();
  /// Remembers under this name, which must be unique, where the widget made last is.
  void note(const std::string& name);
  /// The middle of a widget, if it was in view in the frame drawn last.
  [[nodiscard]] std::optional<glm::vec2> find(const std::string& name) const;
  /// Makes the next frame scroll to a widget.
  void scroll_to(const std::string& name) { wanted_ = name; }

  bool header(const std::string& name, const char* label, bool open);
  bool choice(const std::string& name, const char* label, const std::string& now, std::span<const std::string> words,
              std::string& chosen);
  bool check(const std::string& name, const char* label, bool& value);
  bool whole(const std::string& name, const char* label, int& value, int low, int high);
  bool real(const std::string& name, const char* label, float& value, float low, float high, const char* format);
  bool button(const std::string& name, const char* label);
  void hint(const std::string& text);

 private:
  void label(const char* text);

  std::map<std::string, glm::vec2> now_;
  std::string wanted_;
};

}  // namespace crsh::viewer
