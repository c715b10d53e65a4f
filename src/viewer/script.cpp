#include "viewer/script.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

#include "crsh/error.h"
#include "output/whole_file.h"
#include "viewer/saving.h"

namespace crsh::viewer {
namespace {

/// How many words each command needs at least.
const std::map<std::string, size_t> commands = {
    {"drag", 5},   {"wheel", 3},         {"double", 2},       {"move", 2},    {"key", 1},        {"click", 1},
    {"choose", 1}, {"resize", 2},        {"minimise", 0},     {"restore", 0}, {"drop", 1},       {"wait", 0},
    {"rest", 0},   {"frames", 1},        {"orbit", 1},        {"save", 1},    {"screenshot", 1}, {"copy", 2},
    {"expect", 1}, {"print-command", 0}, {"print-memory", 0}, {"hold", 2}};

constexpr int settling = 2;  // frames until an input shows

const std::map<std::string, int> keys = {{"Enter", GLFW_KEY_ENTER}, {"Tab", GLFW_KEY_TAB}, {"Space", GLFW_KEY_SPACE},
                                         {"F5", GLFW_KEY_F5},       {"F12", GLFW_KEY_F12}, {"Escape", GLFW_KEY_ESCAPE}};

std::optional<KeyPress> key_of(std::string name) {
  KeyPress press;
  if (name.starts_with("shift+")) press.shift = true, name = name.substr(6);
  if (const auto found = keys.find(name); found != keys.end()) press.key = found->second;
  else if (name.size() == 1 && (std::isupper(name[0]) || std::isdigit(name[0]))) press.key = name[0];
  else return {};
  return press;
}

float number(const std::string& word) { return std::strtof(word.c_str(), nullptr); }

/// How much memory of this process is resident, bytes.
uint64_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  uint64_t all = 0, resident = 0;
  file >> all >> resident;
  return resident * uint64_t(::sysconf(_SC_PAGESIZE));
}

}  // namespace

Script::Script(const std::string& path) : path_(path) {
  std::istringstream text(output::read_whole(path));
  std::string line;
  for (size_t count = 1; std::getline(text, line); ++count) {
    Line parsed{.number = count};
    std::istringstream words(line);
    for (std::string word; words >> word;) parsed.words.push_back(word);
    if (parsed.words.empty() || parsed.words[0][0] == '#') continue;
    const size_t first = line.find(parsed.words[0]) + parsed.words[0].size();
    const size_t rest = line.find_first_not_of(' ', first);
    parsed.rest = rest == std::string::npos ? "" : line.substr(rest);
    check(parsed);
    lines_.push_back(std::move(parsed));
  }
}

void Script::refuse(const Line& line, const std::string& what) const {
  throw UserError(fmt::format("{}:{}: {}", path_, line.number, what));
}

void Script::check(const Line& line) const {
  const auto found = commands.find(line.words[0]);
  if (found == commands.end()) refuse(line, line.words[0] + ": no such command");
  if (line.words.size() <= found->second) refuse(line, fmt::format("{} takes {} words", found->first, found->second));
  if (line.words[0] == "key" && !key_of(line.words[1])) refuse(line, line.words[1] + ": no such key");
}

void Script::add(std::function<void(Stage&)> act) {
  steps_.push_back([act = std::move(act)](Stage& stage) { return act(stage), true; });
}

void Script::add_frames(size_t count) {
  for (size_t i = 0; i < count; ++i) add([](Stage&) {});
}

void Script::move_to(glm::vec2 place) {
  add([this, place](Stage&) { pointer_.place = place; });
}

void Script::press(int button, bool down) {
  add([this, button, down](Stage&) { pointer_.down[button] = down; });
}

/// Adds a click on a widget, which is first scrolled to where it is not in view.
void Script::add_click(const Line& line, const std::string& name) {
  auto tries = std::make_shared<int>(0);
  steps_.push_back([this, line, name, tries](Stage& stage) {
    const auto place = stage.widgets.find(name);
    if (!place && ++*tries > 60) refuse(line, "no widget is called \"" + name + "\" (or it is not open)");
    if (!place) return stage.widgets.scroll_to(name), false;
    pointer_.place = *place;
    return true;
  });
  add_frames(1);
  press(0, true);
  press(0, false);
  add_frames(settling);
}

/// Adds so many small turns of the camera, with a wait for the picture after each.
void Script::add_orbit(size_t count) {
  for (size_t i = 0; i < count; ++i) {
    auto last = std::make_shared<uint64_t>(0);
    steps_.push_back([last](Stage& stage) {
      const uint64_t serial = stage.model.left.shown ? stage.model.left.shown->serial : 0;
      if (*last) return serial != *last;
      *last = std::max<uint64_t>(serial, 1);
      stage.model.begin_own_view();
      stage.model.camera.orbit({0.01f, 0});
      stage.model.view_moved();
      return false;
    });
  }
}

void Script::begin_pointer(const Line& line) {
  const auto& w = line.words;
  const auto at = [&](size_t first) { return glm::vec2(number(w[first]), number(w[first + 1])); };
  if (w[0] == "drag") {
    const int button = w[1] == "middle" ? 2 : 0;
    const bool shift = w.size() > 6 && w[6] == "shift";
    add([this, shift](Stage&) { pointer_.shift = shift; });
    move_to(at(2)), add_frames(1), press(button, true);
    for (int i = 1; i <= 5; ++i) move_to(glm::mix(at(2), at(4), float(i) / 5));
    press(button, false);
    add([this](Stage&) { pointer_.shift = false; });
  } else if (w[0] == "wheel") {
    move_to(at(1)), add_frames(1);
    add([this, by = number(w[3])](Stage&) { pointer_.wheel = by; });
    add([this](Stage&) { pointer_.wheel = 0; });
  } else if (w[0] == "double") {
    move_to(at(1)), add_frames(1);
    for (const bool down : {true, false, true, false}) press(0, down);
  } else {
    move_to(at(1));
  }
  add_frames(settling);
}

void Script::begin_window(const Line& line) {
  const auto& w = line.words;
  if (w[0] == "resize") {
    add([width = int(number(w[1])), height = int(number(w[2]))](Stage& stage) {
      stage.window.set_size(width, height);
    });
    add_frames(4 * settling);
  } else if (w[0] == "minimise") {
    add([](Stage& stage) { stage.window.minimise(); });
    steps_.push_back([](Stage& stage) { return stage.window.minimised(); });
    add_frames(settling);
  } else {
    add([](Stage& stage) { stage.window.restore(); });
    steps_.push_back([](Stage& stage) { return !stage.window.minimised(); });
    add_frames(4 * settling);
  }
}

void Script::begin_output(const Line& line) {
  if (line.words[0] == "save") add([path = line.rest](Stage& stage) { stage.save(path); });
  else if (line.words[0] == "screenshot") add([path = line.rest](Stage& stage) { stage.screenshot(path); });
  else if (line.words[0] == "print-command") {
    steps_.push_back([](Stage& stage) { return stage.model.fine(); });
    add([](Stage& stage) { output::write_stdout(copied_command(stage.model) + "\n"); });
  } else {
    add([](Stage& stage) {
      output::write_stdout(fmt::format("memory: device {} host {}\n", stage.model.news.device_bytes, resident_bytes()));
    });
  }
  steps_.push_back([](Stage& stage) { return stage.idle(); });
}

/// Adds a wait for the next picture or line of error.
void Script::add_expect(const Line& line) {
  const bool error = line.words[1] == "error";
  const auto count = [error](const Stage& stage) {
    const uint64_t serial = stage.model.left.shown ? stage.model.left.shown->serial : 0;
    return error ? stage.model.news.error_number : serial;
  };
  struct Wait {
    std::optional<uint64_t> before;
    std::chrono::steady_clock::time_point until;
  };
  auto wait = std::make_shared<Wait>();
  steps_.push_back([this, line, count, wait](Stage& stage) {
    const auto now = std::chrono::steady_clock::now();
    if (!wait->before) wait->before = count_[line.words[1]], wait->until = now + std::chrono::seconds(60);
    if (now > wait->until) refuse(line, "it did not come");
    return count(stage) > *wait->before;
  });
}

void Script::begin(const Line& line) {
  const std::string& command = line.words[0];
  if (command == "drag" || command == "wheel" || command == "double" || command == "move") return begin_pointer(line);
  if (command == "resize" || command == "minimise" || command == "restore") return begin_window(line);
  if (command == "save" || command == "screenshot" || command.starts_with("print-")) return begin_output(line);
  if (command == "click") return add_click(line, line.rest);
  if (command == "expect") return add_expect(line);
  if (command == "copy")
    add([this, words = line.words](Stage& stage) {
      count_ = {{"error", stage.model.news.error_number},
                {"picture", stage.model.left.shown ? stage.model.left.shown->serial : 0}};
      output::write_whole(words[2], output::read_whole(words[1]));
    });
  if (command == "orbit") return add_orbit(size_t(number(line.words[1])));
  if (command == "frames") return add_frames(size_t(number(line.words[1])));
  if (command == "choose") {
    add_click(line, line.rest.substr(0, line.rest.find('=')));
    return add_click(line, line.rest);
  }
  if (command == "key") add([press = *key_of(line.words[1])](Stage& stage) { stage.window.press(press); });
  if (command == "hold") {
    const int key = line.words[1][0];
    add([key](Stage& stage) { stage.window.hold(key); });
    add_frames(size_t(number(line.words[2])));
    add([](Stage& stage) { stage.window.hold(0); });
  }
  if (command == "drop") add([path = line.rest](Stage& stage) { stage.window.drop(path); });
  add_frames(settling);
  if (command == "wait") steps_.push_back([](Stage& stage) { return stage.model.fine() || stage.model.rests(); });
  if (command == "rest") steps_.push_back([](Stage& stage) { return stage.model.rests(); });
}

void Script::step(Stage& stage) {
  while (steps_.empty() && next_ < lines_.size()) begin(lines_[next_++]);
  if (!steps_.empty() && steps_.front()(stage)) steps_.pop_front();
}

}  // namespace crsh::viewer
