#include "bench/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "bench/counters.h"
#include "crsh/error.h"
#include "crsh/renderer.h"
#include "frame/borrowed.h"
#include "output/exposure.h"
#include "output/heat_map.h"
#include "output/png.h"
#include "trace/tracers.h"

namespace crsh::bench {
namespace {

/// Devices without memory of their own may have little: variants whose lists sum up to more are not kept at once.
constexpr uint64_t most_resident_bytes = uint64_t(1) << 30;

/// Frames done of all frames to do.
class Work {
 public:
  Work(const Progress& progress, size_t frames) : progress_(progress), frames_(std::max<size_t>(frames, 1)) {}
  void show(double share) const { progress_ ? progress_((double(done_) + share) / double(frames_)) : void(); }
  void next(size_t frames = 1) { done_ += frames, show(0); }

 private:
  const Progress& progress_;
  size_t frames_, done_ = 0;
};

Picture frame_at(Renderer& renderer, double seconds, Work& work) {
  Picture picture = renderer.render(seconds, [&](double share) { work.show(share); });
  work.next();
  return picture;
}

/// Renders a pass and returns what it alone counted, and its last picture.
Statistics pass_of(Renderer& renderer, const Variant& variant, Work& work, Picture& picture) {
  const Statistics before = renderer.statistics();
  for (const double seconds : variant.seconds) picture = frame_at(renderer, seconds, work);
  return difference(renderer.statistics(), before);
}

void take_picture(gpu::Device& device, const scene::Scene& scene, const Schedule& schedule, Result& result,
                  Work& work) {
  RenderOptions options = result.variant.options;
  options.layers = LayerSet::filled_by(LayerFill::tests);
  Renderer renderer(borrowed(device), borrowed(scene), options);
  const Picture picture = frame_at(renderer, result.variant.seconds.front(), work);
  const Layer& beauty = *picture.find("");
  const double stops = schedule.exposure ? double(*schedule.exposure) : output::automatic_exposure(beauty);
  result.picture_png = output::encode_png(beauty, picture.width, picture.height, stops);
  result.heat = output::tests_of(picture);
}

/// The first pass, alone on the device: its counters and its memory, and what was effective.
void look(gpu::Device& device, const scene::Scene& scene, Result& result, Work& work) {
  RenderOptions options = result.variant.options;
  options.layers = {};
  device.forget_peak();
  Renderer renderer(borrowed(device), borrowed(scene), options);
  Picture picture;
  result.counters = pass_of(renderer, result.variant, work, picture);
  result.variant.options = renderer.options();
  result.first_frame = result.counters.frames.front();
  result.counters.frames.clear();
  result.counters.device_peak_bytes = device.peak_bytes();
  result.world_to_camera = picture.world_to_camera;
  result.world_to_ndc = picture.world_to_ndc;
  result.width = picture.width;
  result.height = picture.height;
}

/// A quick way to learn how many rays a brute force variant has: the default preset, which needs the fewest tests.
Result count_rays(gpu::Device& device, const scene::Scene& scene, Variant variant, Work& work) {
  variant.options.algorithm = preset(default_preset);
  Result result{.variant = std::move(variant)};
  look(device, scene, result, work);
  return result;
}

/// The rays of `from`, each against every triangle.
void count_brute_force(const Result& from, Result& result) {
  const RenderOptions options = result.variant.options;
  const Variant variant = std::move(result.variant);
  result = from;
  result.variant = variant;
  result.variant.options = from.variant.options;
  result.variant.options.algorithm = options.algorithm;
  result.counted_from = from.variant.options.algorithm.preset;
  result.counters = as_brute_force(from.counters);
  result.heat.clear();
}

class Measurement {
 public:
  Measurement(gpu::Device& device, const scene::Scene& scene, const std::vector<Variant>& variants,
              const Schedule& schedule, const Progress& progress)
      : device_(device), scene_(scene), schedule_(schedule), work_(progress, frames(variants, schedule)) {
    for (const Variant& variant : variants) results_.push_back({.variant = variant});
  }

  std::vector<Result> run() {
    for (Result& result : results_)
      if (!is_brute(result.variant)) look_and_take(result);
    for (Result& result : results_)
      if (is_brute(result.variant)) look_at_brute_force(result);
    repeat();
    return std::move(results_);
  }

 private:
  static size_t frames(const std::vector<Variant>& variants, const Schedule& schedule) {
    size_t sum = schedule.pictures ? variants.size() : 0;
    for (const Variant& variant : variants) sum += variant.seconds.size() * (1 + schedule.warmup + schedule.repeat);
    return sum;
  }

  void look_and_take(Result& result) {
    look(device_, scene_, result, work_);
    if (schedule_.pictures) take_picture(device_, scene_, schedule_, result, work_);
  }

  void look_at_brute_force(Result& result) {
    const auto same = [&](const Result& other) {
      return !is_brute(other.variant) && other.variant.rays == result.variant.rays;
    };
    const auto found = std::ranges::find_if(results_, same);
    const Result from = found != results_.end() ? *found : count_rays(device_, scene_, result.variant, work_);
    const uint64_t passes = 1 + schedule_.warmup + schedule_.repeat + (schedule_.pictures ? 1 : 0);
    if (brute_force_tests(from.counters) > most_brute_force_tests / passes) return count_brute_force(from, result);
    look_and_take(result);
  }

  /// A, B, C, A, B, C, ...: a round is a pass of each.
  void repeat() {
    const uint32_t rounds = schedule_.warmup + schedule_.repeat;
    const bool resident = rounds && fit_together();
    std::vector<std::unique_ptr<Renderer>> renderers(results_.size());
    for (size_t i = 0; resident && i < results_.size(); ++i)
      if (is_traced(results_[i])) renderers[i] = renderer_of(results_[i]);
    uint32_t place = 0;
    for (uint32_t round = 0; round < rounds; ++round)
      for (size_t i = 0; i < results_.size(); ++i)
        if (!is_traced(results_[i])) work_.next(results_[i].variant.seconds.size());
        else if (resident) time_again(*renderers[i], results_[i], round >= schedule_.warmup, place);
        else time_alone(results_[i], round >= schedule_.warmup, place);
  }

  static bool is_traced(const Result& result) { return result.counted_from.empty(); }

  /// Whether the device holds the lists of all variants at once, by what each took alone.
  [[nodiscard]] bool fit_together() const {
    const uint64_t budget = device_.request().memory_budget;
    uint64_t sum = 0;
    for (const Result& result : results_) sum += result.counters.device_peak_bytes;
    return sum <= (budget ? budget : most_resident_bytes);
  }

  std::unique_ptr<Renderer> renderer_of(const Result& result) {
    RenderOptions options = result.variant.options;
    options.layers = {};
    return std::make_unique<Renderer>(borrowed(device_), borrowed(scene_), options);
  }

  /// Lists grow and hierarchies are built in a first frame, which is left out.
  void begin(Renderer& renderer, const Result& result) {
    (void)renderer.render(result.variant.seconds.front(), [&](double) { work_.show(0); });
  }

  void time_alone(Result& result, bool counted, uint32_t& place) {
    const auto renderer = renderer_of(result);
    begin(*renderer, result);
    time(*renderer, result, counted, place);
  }

  /// Where objects move, their hierarchy depends on the frames before: each pass begins with one that is new.
  void time_again(Renderer& renderer, Result& result, bool counted, uint32_t& place) {
    if (result.variant.seconds.size() > 1) {
      renderer.forget_objects();
      begin(renderer, result);
    }
    time(renderer, result, counted, place);
  }

  void time(Renderer& renderer, Result& result, bool counted, uint32_t& place) {
    Picture picture;
    const Statistics pass = pass_of(renderer, result.variant, work_, picture);
    if (const std::string what = first_difference(pass, result.counters); !what.empty())
      throw std::logic_error(
          fmt::format("{}: two passes over one scene counted differently: {}", result.variant.label, what));
    if (!counted) return;
    for (const FrameTime& frame : pass.frames) {
      result.counters.frames.push_back(frame);
      result.places.push_back(place++);
    }
  }

  gpu::Device& device_;
  const scene::Scene& scene_;
  const Schedule& schedule_;
  Work work_;
  std::vector<Result> results_;
};

}  // namespace

bool is_brute(const Variant& variant) { return variant.options.algorithm.tracer == "brute"; }

bool has_object_hierarchy(const Variant& variant) {
  return trace::tracer_of(variant.options.algorithm).needs.object_hierarchy;
}

std::vector<Result> measure(gpu::Device& device, const scene::Scene& scene, const std::vector<Variant>& variants,
                            const Schedule& schedule, const Progress& progress) {
  return Measurement(device, scene, variants, schedule, progress).run();
}

}  // namespace crsh::bench
