#include "viewer/style.h"

#include <imgui.h>

#include <cmath>
#include <filesystem>

namespace crsh::viewer {
namespace {

/// Debian's usual sans serif. Where it is not installed, ImGui's own font is used.
constexpr const char* font_path = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

void add_font(float scale) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  std::error_code ignored;
  if (std::filesystem::exists(font_path, ignored) && fonts.AddFontFromFileTTF(font_path, std::round(14 * scale)))
    return;
  ImFontConfig config;
  config.SizePixels = std::round(13 * scale);
  fonts.AddFontDefault(&config);
}

}  // namespace

void set_style(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 3;
  style.WindowBorderSize = 0;
  style.WindowPadding = {8, 8};
  style.ItemSpacing = {6, 4};
  style.ScrollbarSize = 11;
  style.Colors[ImGuiCol_WindowBg] = {0.11f, 0.11f, 0.12f, 1};
  style.Colors[ImGuiCol_Header] = {0.20f, 0.24f, 0.31f, 1};
  style.Colors[ImGuiCol_PlotHistogram] = {0.24f, 0.42f, 0.66f, 1};
  style.Colors[ImGuiCol_PlotLines] = {0.75f, 0.75f, 0.55f, 1};
  style.Colors[ImGuiCol_FrameBg] = {0.18f, 0.19f, 0.22f, 1};
  style.ScaleAllSizes(scale);
  add_font(scale);
}

}  // namespace crsh::viewer
