#include "viewer/widgets.h"

#include <imgui.h>

#include "crsh/assertion.h"

namespace crsh::viewer {
namespace {

float label_width() { return ImGui::GetFontSize() * 7.4f; }

}  // namespace

void Widgets::begin_frame() { now_.clear(); }

void Widgets::note(const std::string& name) {
  if (name == wanted_) {
    ImGui::SetScrollHereY(0.5f);
    wanted_.clear();
  }
  if (!ImGui::IsItemVisible()) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const bool unique = now_.emplace(name, glm::vec2((low.x + high.x) / 2, (low.y + high.y) / 2)).second;
  CRSH_ASSERT(unique, "two widgets are called " + name);
}

std::optional<glm::vec2> Widgets::find(const std::string& name) const {
  const auto found = now_.find(name);
  return found == now_.end() ? std::nullopt : std::optional(found->second);
}

void Widgets::label(const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(label_width());
  ImGui::SetNextItemWidth(-1);
}

void Widgets::hint(const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool Widgets::header(const std::string& name, const char* text, bool open) {
  ImGui::SetNextItemOpen(open, ImGuiCond_Once);
  const bool is_open = ImGui::CollapsingHeader(text);
  note(name);
  return is_open;
}

bool Widgets::choice(const std::string& name, const char* text, const std::string& now,
                     std::span<const std::string> words, std::string& chosen) {
  label(text);
  const bool open = ImGui::BeginCombo(("##" + name).c_str(), now.c_str(), ImGuiComboFlags_HeightLarge);
  note(name);
  if (!open) return false;
  bool changed = false;
  for (const std::string& word : words) {
    if (ImGui::Selectable(word.c_str(), word == now)) chosen = word, changed = true;
    note(name + "=" + word);
  }
  ImGui::EndCombo();
  return changed;
}

bool Widgets::check(const std::string& name, const char* text, bool& value) {
  const bool changed = ImGui::Checkbox((std::string(text) + "##" + name).c_str(), &value);
  note(name);
  return changed;
}

bool Widgets::whole(const std::string& name, const char* text, int& value, int low, int high) {
  label(text);
  const bool changed = ImGui::SliderInt(("##" + name).c_str(), &value, low, high, "%d", ImGuiSliderFlags_AlwaysClamp);
  note(name);
  return changed;
}

bool Widgets::real(const std::string& name, const char* text, float& value, float low, float high, const char* format) {
  label(text);
  const bool changed =
      ImGui::SliderFloat(("##" + name).c_str(), &value, low, high, format, ImGuiSliderFlags_AlwaysClamp);
  note(name);
  return changed;
}

bool Widgets::button(const std::string& name, const char* text) {
  const bool pressed = ImGui::Button((std::string(text) + "##" + name).c_str());
  note(name);
  return pressed;
}

}  // namespace crsh::viewer
