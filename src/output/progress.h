#pragma once
// How far a render is, on standard error: a bar on a terminal, or a JSON object a line.

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace crsh::output {

class Progress {
 public:
  enum class Mode { none, bar, json };
  using Write = std::function<void(const std::string&)>;

  /// `write` gets the text (standard error by default).
  Progress(Mode mode, uint32_t frames, Write write = {});
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Frame number `number`, the `index`th of all, is `share` (0..1) done. Shown ten times a second at most.
  void update(uint32_t number, uint32_t index, double share);
  /// A file is in its place.
  void written(const std::string& path);
  /// Takes the bar off the screen, before other lines and at the end.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  void show_bar(double done, double seconds_left);
  void show_json(uint32_t number, double done, double seconds_left);

  Mode mode_;
  uint32_t frames_;
  Write write_;
  Clock::time_point start_ = Clock::now(), shown_{};
  bool bar_is_up_ = false;
};

/// "4 s", "3 min 20 s", "2 h 5 min".
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace crsh::output
