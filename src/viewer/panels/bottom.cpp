// Below the picture: the time bar and a line of state; above it: messages, progress, the help on keys.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "viewer/panels/panels.h"

namespace crsh::viewer {
namespace {

constexpr ImGuiWindowFlags plain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                   ImGuiWindowFlags_NoFocusOnAppearing;

struct KeyRow {
  const char *keys, *what;
};
constexpr KeyRow key_rows[] = {
    {"left drag", "orbit"},
    {"middle drag, Shift+left drag", "pan"},
    {"wheel", "zoom to the cursor"},
    {"W A S D Q E", "fly (Shift: faster)"},
    {"double click", "turn around what is there"},
    {"Enter", "see the whole scene"},
    {"1  3  7", "from the front, right, top"},
    {"5", "perspective or orthographic"},
    {"Tab", "the file's next camera"},
    {"Space", "play or stop the animation"},
    {"F12, Shift+F12", "save a PNG, an EXR with layers"},
    {"C", "copy the crsh render command of this view"},
    {"F5", "load the scene again"},
    {"N", "show or hide the panels"},
    {"H", "show or hide these keys"},
};

std::string state_text(const Model& model) {
  if (!model.scene() || !model.left.shown)
    return model.path.empty() ? "Drop a glTF scene (.glb, .gltf) here" : model.path;
  const Shown& shown = *model.left.shown;
  const std::string samples = shown.fine ? fmt::format("sample {} of {}", shown.options.samples,
                                                       model.two_pictures() ? 1 : model.arguments.max_samples)
                                         : std::string("moving");
  return fmt::format("{}   |   {} triangles   |   {}x{}   |   {}   |   {:.0f} ms   |   H: all keys",
                     model.scene()->path.filename().string(), shown.statistics.triangles, shown.picture.width,
                     shown.picture.height, samples, shown.milliseconds);
}

void draw_time_bar(Model& model, Widgets& widgets) {
  const float duration = std::max(model.duration(), 1e-3f);
  if (widgets.button("play", model.playing ? "Stop" : "Play")) model.playing = !model.playing;
  ImGui::SameLine();
  float seconds = float(model.seconds);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderFloat("##time", &seconds, 0, duration, "%.2f s")) {
    model.seconds = std::max(seconds, 0.0f);
    model.playing = false;
    model.view_moved();
  }
  widgets.note("time");
}

void draw_progress(const Model& model, const Layout& layout) {
  if (model.news.phase.empty()) return;
  const glm::vec2 middle = (layout.low() + layout.high()) * 0.5f;
  ImGui::SetNextWindowPos({middle.x, middle.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowBgAlpha(0.85f);
  if (ImGui::Begin("progress", nullptr, plain | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs)) {
    ImGui::TextUnformatted(model.news.phase.c_str());
    // Reading and uploading do not tell how far they are: their bar moves to and fro.
    const float share =
        model.news.done > 0 ? float(model.news.done) : float(ImGui::GetTime() - std::floor(ImGui::GetTime()));
    ImGui::ProgressBar(share, {ImGui::GetFontSize() * 16, 0}, model.news.done > 0 ? nullptr : "");
  }
  ImGui::End();
}

}  // namespace

void draw_bottom(Model& model, Widgets& widgets, const Layout& layout) {
  ImGui::SetNextWindowPos({0, layout.window.y - layout.bottom});
  ImGui::SetNextWindowSize({layout.window.x, layout.bottom});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8, 4});
  if (ImGui::Begin("state", nullptr, plain)) {
    if (!model.animations().empty()) draw_time_bar(model, widgets);
    ImGui::TextUnformatted(state_text(model).c_str());
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

void draw_messages(Model& model, const Layout& layout) {
  draw_progress(model, layout);
  const auto now = std::chrono::steady_clock::now();
  std::erase_if(model.messages, [&](const Message& message) { return message.until < now; });
  if (model.messages.empty()) return;
  const float width = layout.high().x - layout.low().x;
  const float labels = model.split ? 2.6f * ImGui::GetFontSize() : 0;  // of the two sides
  ImGui::SetNextWindowPos({layout.low().x + 8, layout.high().y - 8 - labels}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {std::max(width - 16, 1.0f), 10000});
  ImGui::SetNextWindowBgAlpha(0.85f);
  if (ImGui::Begin("messages", nullptr, plain | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs)) {
    ImGui::PushTextWrapPos(std::max(width - 40, 40.0f));
    for (const Message& message : model.messages) {
      const ImVec4 colour = message.error ? ImVec4(1, 0.55f, 0.45f, 1) : ImVec4(0.9f, 0.9f, 0.9f, 1);
      ImGui::PushStyleColor(ImGuiCol_Text, colour);
      ImGui::TextUnformatted(message.text.c_str());
      ImGui::PopStyleColor();
    }
    ImGui::PopTextWrapPos();
  }
  ImGui::End();
}

void draw_keys_help(Model& model, const Layout& layout) {
  if (!model.keys_help) return;
  const glm::vec2 middle = (layout.low() + layout.high()) * 0.5f;
  ImGui::SetNextWindowPos({middle.x, middle.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowBgAlpha(0.92f);
  if (ImGui::Begin("keys", nullptr, plain | ImGuiWindowFlags_AlwaysAutoResize)) {
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
      for (const KeyRow& row : key_rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.keys);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.what);
      }
      ImGui::EndTable();
    }
  }
  ImGui::End();
}

}  // namespace crsh::viewer
