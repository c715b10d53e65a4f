#include "output/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "output/json_text.h"

namespace crsh::output {
namespace {

constexpr int bar_width = 30;
constexpr auto interval = std::chrono::milliseconds(100);

void write_to_stderr(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

std::string duration_text(double seconds) {
  const auto whole = static_cast<uint64_t>(std::llround(std::clamp(seconds, 0.0, 1e12)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

Progress::Progress(Mode mode, uint32_t frames, Write write)
    : mode_(mode), frames_(std::max(frames, 1u)), write_(write ? std::move(write) : Write(write_to_stderr)) {}

void Progress::update(uint32_t number, uint32_t index, double share) {
  const auto now = Clock::now();
  const double done = std::clamp((index + share) / frames_, 0.0, 1.0);
  if (mode_ == Mode::none || (now - shown_ < interval && done < 1)) return;
  shown_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = done > 0 ? elapsed * (1 - done) / done : -1;
  if (mode_ == Mode::bar) show_bar(done, left);
  else show_json(number, done, left);
}

void Progress::show_bar(double done, double seconds_left) {
  const int filled = static_cast<int>(done * bar_width);
  const std::string left = seconds_left < 0 ? "" : duration_text(seconds_left) + " left";
  write_(fmt::format("\r\x1b[K[{:#<{}}{:.<{}}] {:3.0f}% {}", "", filled, "", bar_width - filled, done * 100, left));
  bar_is_up_ = true;
}

void Progress::show_json(uint32_t number, double done, double seconds_left) {
  write_(json_line({{"event", "progress"},
                    {"frame", number},
                    {"frames", frames_},
                    {"done", done},
                    {"eta_s", seconds_left < 0 ? nlohmann::ordered_json(nullptr)
                                               : nlohmann::ordered_json(std::round(seconds_left * 10) / 10)}}));
}

void Progress::written(const std::string& path) {
  if (mode_ == Mode::json) write_(json_line({{"event", "written"}, {"path", path}}));
}

void Progress::clear() {
  if (std::exchange(bar_is_up_, false)) write_("\r\x1b[K");
}

}  // namespace crsh::output
