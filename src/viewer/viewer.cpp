#include "viewer/viewer.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "cli/mend.h"
#include "crsh/error.h"
#include "output/whole_file.h"
#include "viewer/overlays/overlays.h"
#include "viewer/saving.h"

namespace crsh::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int usual_width = 1280, usual_height = 720;

std::filesystem::file_time_type time_of(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::last_write_time(path, ignored);
}

void write(std::unique_ptr<gpu::Texture>& texture, gpu::Device& device, const Pixels& pixels) {
  if (!texture || texture->width() != pixels.width || texture->height() != pixels.height)
    texture = std::make_unique<gpu::Texture>(device, pixels.width, pixels.height);
  texture->write(pixels.rgba);
}

gpu::Area whole(const gpu::Texture& texture) { return {0, 0, int32_t(texture.width()), int32_t(texture.height())}; }

}  // namespace

Viewer::Viewer(gpu::Device& device, const Arguments& arguments)
    : device_(device),
      model_(arguments),
      window_(device, "crsh-view", usual_width, usual_height),
      worker_(device, WindowSystem::wake) {
  if (!arguments.script.empty()) script_.emplace(arguments.script);
  if (!model_.path.empty()) file_time_ = time_of(model_.path);
  last_frame_ = last_look_ = Clock::now();
}

Viewer::~Viewer() { window_.settle(); }

void Viewer::run() {
  while (!window_.closing() && !finished_) {
    window_.wait(patience());
    frame();
  }
}

/// For how many seconds to wait for an event.
double Viewer::patience() const {
  if (script_ && !script_->done()) return 0.002;
  if (model_.moving() || !model_.messages.empty()) return 0.02;
  return finishing() ? 0.01 : 0.25;
}

void Viewer::take_news() {
  const News news = worker_.news();
  if (news.loaded && news.loaded != model_.loaded) {
    model_.take(news.loaded);
    window_.set_title(model_.scene()->path.filename().string() + " - crsh-view");
  }
  model_.take_pictures(news);
  if (news.error_number == shown_error_) return;
  shown_error_ = news.error_number;
  model_.say(news.error, true);
  fmt::print(stderr, "crsh-view: {}\n", news.error);
}

void Viewer::play() {
  const auto now = Clock::now();
  const double passed = std::chrono::duration<double>(now - last_frame_).count();
  last_frame_ = now;
  if (!model_.playing || model_.animations().empty()) return;
  const double duration = std::max(double(model_.duration()), 1e-3);
  model_.seconds = double(float(std::fmod(model_.seconds + std::min(passed, 0.5), duration)));
}

/// --watch: looks at the file's time twice a second, and loads it anew where it has changed.
void Viewer::watch() {
  if (!model_.arguments.watch || model_.path.empty() || Clock::now() - last_look_ < std::chrono::milliseconds(500))
    return;
  last_look_ = Clock::now();
  const auto time = time_of(model_.path);
  if (time != file_time_ && time != std::filesystem::file_time_type::min()) model_.open(model_.path);
  file_time_ = time;
}

void Viewer::frame() {
  play();
  watch();
  for (const std::string& path : window_.take_drops()) {
    model_.open(path);
    file_time_ = time_of(path);
  }
  take_news();
  fit_window();
  if (script_ && !script_->done()) {
    Script::Stage stage{model_,
                        window_,
                        widgets_,
                        [this](const std::string& path) { saves_.push_back(path); },
                        [this](const std::string& path) { screenshots_.push_back(path); },
                        [this] { return saves_.empty() && screenshots_.empty(); }};
    script_->step(stage);
  }
  draw();
  save_what_is_ready();
  count_frame();
}

/// --size: makes the window so large that the picture gets that size. It waits for the scene, which decides on the
/// panels.
void Viewer::fit_window() {
  const RenderOptions& asked = model_.arguments.render.options;
  if (fitted_ || !model_.loaded) return;
  fitted_ = true;
  if (!asked.width) return;
  const glm::vec2 size = glm::vec2(asked.width, asked.height) / window_.pixel_scale();
  glm::vec2 window = size;
  for (int i = 0; i < 4; ++i) {  // wider windows have more panels
    const Layout layout = layout_of(model_, window, ImGui::GetIO().Fonts->Fonts[0]->FontSize);
    window = size + window - (layout.high() - layout.low());
  }
  window_.set_size(int(std::lround(window.x)), int(std::lround(window.y)));
}

void Viewer::draw() {
  window_.begin_frame(script_ ? &script_->pointer() : nullptr);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const Layout layout = layout_of(model_, {size.x, size.y}, ImGui::GetFontSize());
  const glm::vec2 pixels = glm::round((layout.high() - layout.low()) * window_.pixel_scale());
  if (!window_.minimised()) model_.area = {uint32_t(std::max(pixels.x, 1.0f)), uint32_t(std::max(pixels.y, 1.0f))};
  act(input_.handle(model_, window_, layout));
  widgets_.begin_frame();
  draw_panels(model_, widgets_, layout);
  update_textures();
  draw_overlays(model_, layout, heat_);
  const Wish wish = model_.wish();
  model_.wish_moves = wish.moving;
  model_.wish_number = worker_.want(wish);
  gpu::Screenshot screenshot;
  const bool wanted = !screenshots_.empty();
  if (!window_.end_frame(textures(layout), wanted ? &screenshot : nullptr) || !wanted) return;
  save_screenshot(screenshot, screenshots_.front());
  screenshots_.pop_front();
}

/// Puts a side's picture into its texture. The order of rays is a coarser picture of its own.
void Viewer::paint(std::unique_ptr<gpu::Texture>& texture, const Side& side) {
  if (side.show == Show::order && !side.node_frame) return;
  const Picture& picture = side.show == Show::order ? side.node_frame->order : side.shown->picture;
  write(texture, device_, in_colours(picture, side.show, painted_.exposure, heat_));
}

void Viewer::update_textures() {
  if (!model_.left.shown) return;
  const bool right = model_.split && model_.right.shown;
  const auto serial = [](const auto& pointer) { return pointer ? pointer->serial : 0; };
  const Painted now{.left = model_.left.shown->serial,
                    .right = right ? model_.right.shown->serial : 0,
                    .left_node_frame = serial(model_.left.node_frame),
                    .right_node_frame = serial(model_.right.node_frame),
                    .left_show = model_.left.show,
                    .right_show = model_.right.show,
                    .exposure = model_.exposure(),
                    .split = model_.split};
  if (now == painted_) return;
  painted_ = now;
  window_.settle();
  heat_ = std::max(heat_end(model_.left.shown->picture, model_.left.show),
                   right ? heat_end(model_.right.shown->picture, model_.right.show) : 0);
  paint(left_, model_.left);
  if (right) paint(right_, model_.right);
}

/// What is shown where: the picture fills its place, and a second one the part to the right of the line.
std::vector<gpu::ShownTexture> Viewer::textures(const Layout& layout) const {
  if (!left_) return {};
  const glm::vec2 scale = window_.pixel_scale();
  const glm::ivec2 low = glm::ivec2(glm::round(layout.low() * scale)), window = window_.pixels();
  const glm::ivec2 high = glm::min(low + glm::ivec2(model_.area.width, model_.area.height), window);
  const auto part = [&](const gpu::Texture& texture, double from, double to) {
    gpu::Area source = whole(texture), target{low.x, low.y, high.x, high.y};
    source.left = int32_t(std::lround(from * texture.width())),
    source.right = int32_t(std::lround(to * texture.width()));
    target.left = low.x + int32_t(std::lround(from * (high.x - low.x)));
    target.right = low.x + int32_t(std::lround(to * (high.x - low.x)));
    return gpu::ShownTexture{&texture, source, target};
  };
  if (!model_.split || !right_ || !model_.right.shown) return {part(*left_, 0, 1)};
  return {part(*left_, 0, model_.split_place), part(*right_, model_.split_place, 1)};
}

void Viewer::act(const std::vector<Action>& actions) {
  for (const Action action : actions) {
    if (!model_.left.shown) continue;
    if (action == Action::save_png) saves_.push_back(free_name(model_, ".png"));
    if (action == Action::save_exr) saves_.push_back(free_name(model_, ".exr"));
    if (action != Action::copy_command) continue;
    window_.copy(copied_command(model_));
    model_.say("copied: " + copied_command(model_));
  }
}

void Viewer::save_what_is_ready() {
  const auto is_exr = [](const std::string& path) { return path.ends_with(".exr"); };
  model_.exr_wanted = std::ranges::any_of(saves_, is_exr);
  while (!saves_.empty() && can_save(model_, saves_.front())) {
    try {
      save_picture(model_, saves_.front());
      model_.say("saved: " + saves_.front());
    } catch (const UserError& error) {
      if (model_.arguments.after) throw;
      model_.say(cli::line_of(error), true);
    }
    saves_.pop_front();
  }
}

/// Whether frames count for --after: only when the script has ended.
bool Viewer::finishing() const { return model_.arguments.after && (!script_ || script_->done()); }

void Viewer::count_frame() {
  if (!finishing()) return;
  if (model_.rests() && !model_.left.shown)
    throw UserError(model_.news.error.empty() ? "there is no scene to show" : model_.news.error);
  if (!model_.fine()) return;
  if (fine_frames_ < *model_.arguments.after) {
    static uint64_t last = 0;
    if (model_.left.shown->serial == last && !model_.rests()) return;  // the same picture again
    last = model_.left.shown->serial;
    if (++fine_frames_ < *model_.arguments.after) return;
  }
  finish();
}

/// Saves and prints what the command line asks for at the end, all of the same picture.
void Viewer::finish() {
  const Arguments& a = model_.arguments;
  if (!a.save.empty()) {
    if (!can_save(model_, a.save)) {
      model_.exr_wanted = true;
      return;
    }
    save_picture(model_, a.save);
  }
  if (a.print_command) output::write_stdout(copied_command(model_) + "\n");
  if (!a.screenshot.empty()) {
    screenshots_.push_back(a.screenshot);
    while (!screenshots_.empty()) draw();
  }
  finished_ = true;
}

}  // namespace crsh::viewer
