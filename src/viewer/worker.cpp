#include "viewer/worker.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "cli/load_scene.h"
#include "cli/mend.h"
#include "crsh/error.h"
#include "frame/borrowed.h"
#include "scene/hide.h"

namespace crsh::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto shader_looks = std::chrono::milliseconds(400);

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

Worker::Worker(gpu::Device& device, std::function<void()> wake) : device_(device), wake_(std::move(wake)) {
  if (const char* folder = std::getenv("CRSH_SHADER_DIR"); folder && *folder) shaders_.emplace(folder);
  thread_ = std::thread([this] { run(); });
}

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

uint64_t Worker::want(const Wish& wish) {
  {
    const std::lock_guard lock(mutex_);
    if (wish == wanted_) return version_;
    wanted_ = wish;
    ++version_;
  }
  changed_.notify_all();
  return version_;
}

News Worker::news() const {
  const std::lock_guard lock(mutex_);
  return news_;
}

bool Worker::outdated() const { return quit_ || (version_ != taken_ && !wish_.moving); }

bool Worker::more_to_do() const {
  if (given_up_ || wish_.load == 0) return false;
  if (wish_.load != loaded_number_) return true;
  if (!loaded_ || wish_.scene != loaded_->number) return false;
  if (wish_.moving) return samples_ == 0;
  return samples_ == 0 || (wish_.other ? !right_done_ : samples_ < wish_.max_samples);
}

/// Nothing more will come of the wish. After a load another wish follows, which knows the scene: that one rests.
bool Worker::fulfilled() const {
  if (more_to_do()) return false;
  return given_up_ || !loaded_ || wish_.load == 0 || wish_.scene == loaded_->number;
}

/// Waits for something to do; returns false when there never will be.
bool Worker::take_wish() {
  std::unique_lock lock(mutex_);
  if (fulfilled() && version_ == taken_ && news_.rests_at != taken_) {
    news_.rests_at = taken_;
    lock.unlock(), wake_(), lock.lock();
  }
  const auto something = [this] { return quit_ || version_ != taken_ || more_to_do(); };
  if (shaders_) changed_.wait_for(lock, shader_looks, something);
  else changed_.wait(lock, something);
  if (version_ != taken_) {
    wish_ = wanted_;
    taken_ = version_;
    samples_ = 0;
    right_done_ = has_node_frames_ = given_up_ = false;
  }
  return !quit_;
}

void Worker::run() {
  while (take_wish()) {
    try {
      look_at_shaders();
      if (more_to_do()) fulfil();
    } catch (const Cancelled&) {
      samples_ = 0;
    } catch (const UserError& error) {
      fail(cli::line_of(error));
    } catch (const gpu::OutOfMemory& shortage) {
      fail(fmt::format("out of memory ({}): make the window or the scene smaller", shortage.name));
    } catch (const std::exception& error) {
      fail(fmt::format("internal error: {}", error.what()));
    }
  }
  renderer_.reset();
}

void Worker::fail(const std::string& message) {
  given_up_ = true;
  say_error(message);
}

void Worker::say_error(const std::string& message) {
  {
    const std::lock_guard lock(mutex_);
    news_.error = message;
    ++news_.error_number;
    news_.phase.clear();
  }
  wake_();
}

void Worker::say(const std::string& phase, double done) {
  {
    const std::lock_guard lock(mutex_);
    news_.phase = phase;
    news_.done = done;
  }
  wake_();
}

void Worker::fulfil() {
  if (wish_.load != loaded_number_) return load();
  if (!renderer_ || hidden_ != wish_.options.hidden) make_renderer();
  if (wish_.node_kind && !has_node_frames_ && !wish_.moving) return render_node_frames();
  if (samples_ == 0) render(false);
  else if (wish_.other && !right_done_) render(true);
  else refine();
  if (!wish_.moving) return;
  if (wish_.other) render(true);
  if (wish_.node_kind) render_node_frames();
}

/// Renders the frames that show how rays are sorted and bundled. It does so before the fine picture, because samples
/// cannot be added to that after another frame.
void Worker::render_node_frames() {
  const size_t lights = std::max({wish_.options.lights.size(), loaded_->scene.lights.size(), size_t(1)});
  NodeFrameIn in{.options = wish_.options,
                 .seconds = wish_.seconds,
                 .kind = *wish_.node_kind,
                 .lights = uint32_t(lights),
                 .moving = wish_.moving};
  const auto look = [&] {
    auto made = std::make_shared<NodeFrame>(render_node_frame(*renderer_, in));
    made->wish = taken_;
    made->serial = ++serial_;
    return made;
  };
  const NodeFramePtr left = look();
  NodeFramePtr right = left;
  if (wish_.other) in.options.algorithm = *wish_.other, right = look();
  has_node_frames_ = true;
  {
    const std::lock_guard lock(mutex_);
    news_.left_node_frame = left, news_.right_node_frame = right;
  }
  wake_();
}

/// CRSH_SHADER_DIR: puts shaders that a developer has edited in the place of the built-in ones.
void Worker::look_at_shaders() {
  if (!shaders_ || Clock::now() - shaders_seen_ < shader_looks) return;
  shaders_seen_ = Clock::now();
  std::vector<std::string> in_use = device_.programs_in_use();
  in_use.insert(in_use.end(), {"raster/surface.vert", "raster/surface.frag"});
  try {
    if (!shaders_->look(in_use)) return;
  } catch (const UserError& error) {
    return say_error(cli::line_of(error));
  }
  renderer_.reset();
  device_.forget_programs();
  samples_ = 0;
  right_done_ = has_node_frames_ = given_up_ = false;
}

void Worker::load() {
  loaded_number_ = wish_.load;
  say("reading " + wish_.path.filename().string(), 0);
  auto loaded = std::make_shared<LoadedScene>();
  loaded->number = wish_.load;
  loaded->scene = cli::load_scene(wish_.path, {.scene = wish_.which,
                                               .reach = cli::reach_of(wish_.allow_outside),
                                               .variant = wish_.options.variant,
                                               .lenient = wish_.lenient});
  renderer_.reset();
  loaded_ = loaded;
  {
    const std::lock_guard lock(mutex_);
    news_.loaded = loaded;
    news_.left = news_.right = nullptr;
    news_.left_node_frame = news_.right_node_frame = nullptr;
  }
  say("", 0);
}

void Worker::make_renderer() {
  say("giving it to the device", 0);
  renderer_.reset();
  hidden_ = wish_.options.hidden;
  ScenePtr scene(loaded_, &loaded_->scene);
  if (!hidden_.empty()) {
    const auto without_hidden = std::make_shared<scene::Scene>(*scene);
    scene::hide(*without_hidden, hidden_);
    scene = without_hidden;
  }
  renderer_ = std::make_unique<Renderer>(borrowed(device_), scene, wish_.options);
  renderer_->on_submit([this] {
    if (outdated()) throw Cancelled();
  });
}

void Worker::render(bool right) {
  RenderOptions options = wish_.options;
  const raster::ImageSize full{options.width, options.height};
  raster::ImageSize size = full;
  if (wish_.moving) size = pace_.size(full, wish_.budget_ms / (wish_.other ? 2 : 1));
  options.width = size.width, options.height = size.height;
  if (right) options.algorithm = *wish_.other;
  const bool first = !news().left;
  const auto start = Clock::now();
  renderer_->change(options);
  Picture picture = renderer_->render(wish_.seconds, [&](double done) {
    if (first) say("first picture", done);
  });
  const double milliseconds = milliseconds_since(start);
  if (!right) pace_.measured(size, full, milliseconds);
  if (right) right_done_ = true;
  else samples_ = 1;
  publish(right, std::move(picture), options, !wish_.moving, milliseconds);
}

void Worker::refine() {
  const auto start = Clock::now();
  RenderOptions options = renderer_->options();
  renderer_->change(options);
  Picture picture = renderer_->refine(wish_.seconds);
  options.samples = ++samples_;
  publish(false, std::move(picture), options, true, milliseconds_since(start));
}

void Worker::publish(bool right, Picture picture, RenderOptions options, bool fine, double milliseconds) {
  auto shown = std::make_shared<Shown>();
  shown->picture = std::move(picture);
  shown->options = std::move(options);
  shown->seconds = wish_.seconds;
  shown->fine = fine;
  shown->statistics = renderer_->statistics();
  shown->milliseconds = milliseconds;
  shown->scene = loaded_->number;
  shown->wish = taken_;
  shown->serial = ++serial_;
  {
    const std::lock_guard lock(mutex_);
    (right ? news_.right : news_.left) = shown;
    if (!wish_.other) news_.right = nullptr;
    news_.phase.clear();
    news_.device_bytes = device_.allocated_bytes();
  }
  wake_();
}

}  // namespace crsh::viewer
