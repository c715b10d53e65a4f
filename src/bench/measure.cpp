#include "bench/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "bench/budget.h"
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

/// Without a budget, variants are kept at the same time where their lists take no more bytes than this: devices without
/// memory of their own may have little.
constexpr uint64_t max_resident_bytes = uint64_t(1) << 30;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Frames done of all frames to do; under a budget of time, at least the share of it that is over.
class Work {
 public:
  Work(const Progress& progress, size_t frames, double budget_seconds = 0)
      : progress_(progress), frames_(std::max<size_t>(frames, 1)), budget_(budget_seconds) {}
  void show(double share) const {
    const double over = budget_ > 0 ? std::min(seconds_since(start_) / budget_, 0.99) : 0;
    if (progress_) progress_(std::clamp((double(done_) + share) / double(frames_), over, 1.0));
  }
  void next(size_t frames = 1) { done_ += frames, show(0); }
  /// So many are left, not as many as was thought.
  void expect(size_t frames) { frames_ = std::max<size_t>(done_ + frames, 1); }
  [[nodiscard]] double seconds() const { return seconds_since(start_); }

 private:
  const Progress& progress_;
  size_t frames_, done_ = 0;
  double budget_;
  Clock::time_point start_ = Clock::now();
};

Picture frame_at(Renderer& renderer, double seconds, Work& work) {
  Picture picture = renderer.render(seconds, [&](double share) { work.show(share); });
  work.next();
  return picture;
}

/// Renders a pass. Returns what that counted, and its last picture.
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

/// Milliseconds of a pass, without what only a first one takes.
double pass_ms(const Statistics& statistics) {
  double sum = 0;
  for (const FrameTime& frame : statistics.frames) sum += frame.total_ms - frame.pipeline_ms;
  return sum;
}

/// Renders the first pass, with nothing else on the device, for its counters, its memory and its effective options.
void look(gpu::Device& device, const scene::Scene& scene, Result& result, Work& work) {
  RenderOptions options = result.variant.options;
  options.layers = {};
  device.forget_peak();
  Renderer renderer(borrowed(device), borrowed(scene), options);
  Picture picture;
  result.counters = pass_of(renderer, result.variant, work, picture);
  result.variant.options = renderer.options();
  result.first_frame = result.counters.frames.front();
  result.seconds = pass_ms(result.counters) / 1000;
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

/// Seconds of a pass of brute force on the rays of `from`, by a picture so small that it takes few tests.
double brute_force_seconds(gpu::Device& device, const scene::Scene& scene, const Result& from, Variant variant) {
  constexpr double few_tests = 2e7;
  const double tests = double(brute_force_tests(from.counters));
  const double shrink = std::sqrt(std::min(few_tests / std::max(tests, 1.0), 1.0));
  variant.options.width = std::max(uint32_t(from.variant.options.width * shrink), 1u);
  variant.options.height = std::max(uint32_t(from.variant.options.height * shrink), 1u);
  variant.seconds.resize(1);
  Result sample{.variant = std::move(variant)};
  const Progress none;
  Work silent(none, 1);
  look(device, scene, sample, silent);
  return sample.seconds * tests / std::max(double(brute_force_tests(sample.counters)), 1.0);
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
      : device_(device),
        scene_(scene),
        schedule_(schedule),
        rounds_{schedule.warmup, schedule.repeat},
        work_(progress, frames(variants, schedule), schedule.budget_seconds) {
    for (const Variant& variant : variants) results_.push_back({.variant = variant});
  }

  std::vector<Result> run() {
    for (Result& result : results_)
      if (!is_brute(result.variant)) look_and_take(result);
    for (Result& result : results_)
      if (is_brute(result.variant)) look_at_brute_force(result);
    fit_budget();
    repeat();
    return std::move(results_);
  }

 private:
  static size_t frames(const std::vector<Variant>& variants, const Schedule& schedule) {
    size_t sum = schedule.pictures ? variants.size() : 0;
    for (const Variant& variant : variants)
      sum += variant.seconds.size() * (variant.timed ? 1 + schedule.warmup + schedule.repeat : 1);
    return sum;
  }

  void look_and_take(Result& result) {
    look(device_, scene_, result, work_);
    if (schedule_.pictures && result.variant.timed) take_picture(device_, scene_, schedule_, result, work_);
  }

  void look_at_brute_force(Result& result) {
    const auto same = [&](const Result& other) {
      return !is_brute(other.variant) && other.variant.rays == result.variant.rays;
    };
    const auto found = std::ranges::find_if(results_, same);
    const Result from = found != results_.end() ? *found : count_rays(device_, scene_, result.variant, work_);
    if (costs_too_much(from, result)) return count_brute_force(from, result);
    look_and_take(result);
  }

  /// Under a budget, brute force may take a quarter of what is left of it, all of it where nothing else is measured.
  [[nodiscard]] bool costs_too_much(const Result& from, const Result& brute) {
    const uint64_t pictures = schedule_.pictures ? 1 : 0;
    if (schedule_.budget_seconds <= 0)
      return brute_force_tests(from.counters) > max_brute_force_tests / (1 + rounds_.sum() + pictures);
    const double seconds = brute_force_seconds(device_, scene_, from, brute.variant), left = seconds_left();
    const double others = seconds_a_round();
    const Rounds rounds = rounds_that_fit(rounds_, left, others > 0 ? others : seconds);
    const double share = others > 0 ? 0.25 : 1;
    return seconds * double(1 + rounds.sum() + pictures) > share * left;
  }

  [[nodiscard]] double seconds_left() const { return schedule_.budget_seconds - work_.seconds(); }

  /// As long as the first passes took, of those that are repeated; twice that where each needs a renderer of its own.
  [[nodiscard]] double seconds_a_round() const {
    double sum = 0;
    for (const Result& result : results_) sum += is_repeated(result) ? result.seconds : 0;
    return fit_together() ? sum : 2 * sum;
  }

  void fit_budget() {
    const double round = seconds_a_round();
    if (schedule_.budget_seconds <= 0 || round <= 0) return;
    const Rounds asked = rounds_;
    rounds_ = rounds_that_fit(asked, seconds_left(), round);
    size_t frames = 0;
    for (const Result& result : results_)
      frames += result.variant.timed ? result.variant.seconds.size() * rounds_.sum() : 0;
    work_.expect(frames);
    if (rounds_ == asked || !schedule_.say) return;
    schedule_.say(fmt::format("{} timed {} of each in place of {}, {} for warming up: more would not fit the budget",
                              rounds_.repeat, rounds_.repeat == 1 ? "pass" : "passes", asked.repeat, rounds_.warmup));
  }

  /// Renders in rounds, A, B, C, A, B, C, ...: a round is one pass of each variant.
  void repeat() {
    const auto rounds = static_cast<uint32_t>(rounds_.sum());
    const bool resident = rounds && fit_together();
    std::vector<std::unique_ptr<Renderer>> renderers(results_.size());
    for (size_t i = 0; resident && i < results_.size(); ++i)
      if (is_repeated(results_[i])) renderers[i] = renderer_of(results_[i]);
    uint32_t place = 0;
    for (uint32_t round = 0; round < rounds; ++round)
      for (size_t i = 0; i < results_.size(); ++i)
        if (!is_repeated(results_[i])) work_.next(results_[i].variant.timed ? results_[i].variant.seconds.size() : 0);
        else if (resident) time_again(*renderers[i], results_[i], round >= rounds_.warmup, place);
        else time_anew(results_[i], round >= rounds_.warmup, place);
  }

  /// It is traced, and not only for its counters.
  static bool is_repeated(const Result& result) { return result.counted_from.empty() && result.variant.timed; }

  /// Whether the lists of all variants fit on the device at the same time, judged by what each took in its first pass.
  [[nodiscard]] bool fit_together() const {
    const uint64_t budget = device_.request().memory_budget;
    uint64_t sum = 0;
    for (const Result& result : results_) sum += is_repeated(result) ? result.counters.device_peak_bytes : 0;
    return sum <= (budget ? budget : max_resident_bytes);
  }

  std::unique_ptr<Renderer> renderer_of(const Result& result) {
    RenderOptions options = result.variant.options;
    options.layers = {};
    return std::make_unique<Renderer>(borrowed(device_), borrowed(scene_), options);
  }

  /// Renders a first frame, in which lists grow and hierarchies are built, and which is not timed.
  void begin(Renderer& renderer, const Result& result) {
    (void)renderer.render(result.variant.seconds.front(), [&](double) { work_.show(0); });
  }

  void time_anew(Result& result, bool counted, uint32_t& place) {
    const auto renderer = renderer_of(result);
    begin(*renderer, result);
    time(*renderer, result, counted, place);
  }

  /// Times a pass of a renderer that is kept. Where objects move, their hierarchy depends on the frames before; so each
  /// pass begins with a new one.
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
  Rounds rounds_;
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
