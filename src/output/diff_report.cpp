// What a comparison looks like: a line, JSON, a picture.

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "output/diff.h"
#include "output/json_text.h"
#include "output/png.h"

namespace crsh::output {
namespace {

using Json = nlohmann::ordered_json;

std::string worst_of(const Worst& worst) {
  return fmt::format("worst at pixel {},{} channel {}: {:.9g} against {:.9g} (difference {:.4g})", worst.x, worst.y,
                     worst.channel, worst.a, worst.b, worst.difference);
}

double percent_failing(const Comparison& comparison) {
  return 100.0 * double(comparison.failing) / (double(comparison.width) * double(comparison.height));
}

/// JSON has no infinity and no not-a-number: they become strings.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(fmt::format("{}", value)); }

Json worst_json(const std::optional<Worst>& worst) {
  if (!worst) return nullptr;
  return {{"x", worst->x},         {"y", worst->y},         {"channel", worst->channel},
          {"a", number(worst->a)}, {"b", number(worst->b)}, {"difference", number(worst->difference)}};
}

Json tolerance_json(const Tolerance& tolerance) {
  if (tolerance.exact) return "exact";
  return {{"fail", tolerance.fail}, {"fail_percent", tolerance.fail_percent}, {"hard_fail", tolerance.hard_fail}};
}

}  // namespace

std::string verdict(const Comparison& comparison, const Tolerance& tolerance) {
  if (!comparison.mismatch.empty()) return comparison.mismatch;
  if (!comparison.worst) return "equal";
  const std::string worst = worst_of(*comparison.worst);
  if (comparison.same) return "equal within the tolerance: " + worst;
  return fmt::format("different: {} of {} pixels ({:.3g}%){}, {}", comparison.failing,
                     uint64_t(comparison.width) * comparison.height, percent_failing(comparison),
                     tolerance.exact ? "" : fmt::format(" over {}", tolerance.fail), worst);
}

std::string diff_json(const Comparison& comparison, const Tolerance& tolerance, const std::string& a,
                      const std::string& b) {
  const bool compared = comparison.mismatch.empty();
  Json json = {{"schema", "crsh-diff/1"},
               {"a", a},
               {"b", b},
               {"same", comparison.same},
               {"mismatch", compared ? Json(nullptr) : Json(comparison.mismatch)},
               {"tolerance", tolerance_json(tolerance)}};
  if (compared) {
    json["width"] = comparison.width;
    json["height"] = comparison.height;
    json["channels"] = comparison.channels;
    json["failing_pixels"] = comparison.failing;
    json["failing_percent"] = percent_failing(comparison);
    json["mean_difference"] = comparison.mean;
    json["worst"] = worst_json(comparison.worst);
  }
  return json_text(json);
}

std::string difference_png(const Comparison& comparison) {
  const double worst = comparison.worst ? comparison.worst->difference : 0;
  std::vector<uint8_t> pixels;
  pixels.reserve(comparison.differences.size());
  for (const float apart : comparison.differences)
    pixels.push_back(std::isinf(apart) ? 255 : apart > 0 && worst > 0 ? srgb_byte(apart / worst) : 0);
  return encode_grey_png(pixels, comparison.width, comparison.height);
}

}  // namespace crsh::output
