#include "output/diff.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "crsh/error.h"

namespace crsh::output {
namespace {

/// Whether the channel has numbers of things, which are the same or not: written as float or as uint.
bool has_ids(const Channel& channel) { return channel.sample == Sample::id || channel.name.ends_with(".id"); }

/// Of the same type, or both of whole numbers.
bool comparable_bits(const Channel& a, const Channel& b) { return a.sample == b.sample || (has_ids(a) && has_ids(b)); }

double difference(const Channel& a, const Channel& b, size_t pixel, Format format) {
  const double x = a.value(pixel), y = b.value(pixel);
  if (x == y || (std::isnan(x) && std::isnan(y))) return 0;
  if (has_ids(a) || has_ids(b)) return 1;
  const double apart = std::abs(x - y);
  if (!std::isfinite(apart)) return std::numeric_limits<double>::infinity();
  return format == Format::png ? apart : apart / std::max({std::abs(x), std::abs(y), 0.01});
}

bool asked_for(const std::vector<std::string>& layers, const std::string& channel) {
  return std::ranges::any_of(layers, [&](const auto& layer) { return layer == "all" || in_layer(channel, layer); });
}

std::vector<std::string> names_of(const Image& image, const std::vector<std::string>& layers) {
  std::vector<std::string> names;
  for (const Channel& channel : image.channels)
    if (asked_for(layers, channel.name)) names.push_back(channel.name);
  return names;
}

/// Throws for a layer that neither image has.
void check_layers(const Image& a, const Image& b, const std::vector<std::string>& layers) {
  std::set<std::string> known = {"all"};
  for (const Image* image : {&a, &b})
    for (const Channel& channel : image->channels) known.insert(layer_of(channel.name));
  for (const std::string& layer : layers)
    if (names_of(a, {layer}).empty() && names_of(b, {layer}).empty())
      throw UserError(fmt::format("layer {} is in neither image: choose of {}", layer, fmt::join(known, ", ")),
                      Exit::usage);
}

/// Why the pixels cannot be compared; empty where they can.
std::string find_mismatch(const Image& a, const Image& b, const std::vector<std::string>& layers, bool exact) {
  if (a.width != b.width || a.height != b.height)
    return fmt::format("sizes differ: {}x{} against {}x{}", a.width, a.height, b.width, b.height);
  if (a.left != b.left || a.top != b.top)
    return fmt::format("data windows differ: they begin at {},{} against {},{}", a.left, a.top, b.left, b.top);
  const auto names_a = names_of(a, layers), names_b = names_of(b, layers);
  if (names_a != names_b)
    return fmt::format("channels differ: {} against {}", fmt::join(names_a, " "), fmt::join(names_b, " "));
  for (const std::string& name : names_a)
    if (exact && !comparable_bits(*a.find(name), *b.find(name)))
      return fmt::format("channels differ: {} has another type", name);
  return {};
}

/// Adds up the differences of one channel after the other.
struct Tally {
  const Image& a;
  const Image& b;
  const Tolerance& tolerance;
  Comparison& result;
  std::vector<bool> failing;
  double sum = 0;
  uint64_t finite = 0;

  void add(const std::string& name) {
    const Channel &x = *a.find(name), &y = *b.find(name);
    for (size_t pixel = 0; pixel < x.bits.size(); ++pixel) {
      const bool same_numbers = x.sample != y.sample && has_ids(x) && has_ids(y) && x.value(pixel) == y.value(pixel);
      if (same_numbers || (x.sample == y.sample && x.bits[pixel] == y.bits[pixel])) {
        ++finite;
        continue;
      }
      add(name, pixel, {x.value(pixel), y.value(pixel), difference(x, y, pixel, a.format)});
    }
  }

 private:
  struct Values {
    double a, b, difference;
  };
  void add(const std::string& name, size_t pixel, const Values& values) {
    const double apart = values.difference;
    if (std::isfinite(apart)) sum += apart, ++finite;
    if (tolerance.exact || apart > tolerance.fail) failing[pixel] = true;
    result.differences[pixel] = std::max(result.differences[pixel], static_cast<float>(apart));
    if ((tolerance.exact || apart > 0) && (!result.worst || apart > result.worst->difference))
      result.worst = Worst{uint32_t(pixel % a.width), uint32_t(pixel / a.width), name, values.a, values.b, apart};
  }
};

bool passes(const Comparison& comparison, const Tolerance& tolerance) {
  if (tolerance.exact) return comparison.failing == 0;
  const double allowed = tolerance.fail_percent / 100 * double(comparison.width) * double(comparison.height);
  return double(comparison.failing) <= allowed &&
         (!comparison.worst || comparison.worst->difference <= tolerance.hard_fail);
}

}  // namespace

Comparison compare(const Image& a, const Image& b, const std::vector<std::string>& layers, const Tolerance& tolerance) {
  if (a.format != b.format)
    throw UserError("one image is PNG, the other OpenEXR: compare two of one format", Exit::usage);
  check_layers(a, b, layers);
  Comparison result;
  result.width = a.width;
  result.height = a.height;
  result.mismatch = find_mismatch(a, b, layers, tolerance.exact);
  if (!result.mismatch.empty()) return result;
  result.channels = names_of(a, layers);
  const size_t pixels = size_t(a.width) * a.height;
  result.differences.resize(pixels);
  Tally tally{a, b, tolerance, result, std::vector<bool>(pixels)};
  for (const std::string& name : result.channels) tally.add(name);
  result.failing = static_cast<uint64_t>(std::ranges::count(tally.failing, true));
  result.mean = tally.finite ? tally.sum / double(tally.finite) : 0;
  result.same = passes(result, tolerance);
  return result;
}

}  // namespace crsh::output
