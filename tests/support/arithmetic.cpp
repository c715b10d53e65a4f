// The probe itself is arithmetic.comp, the only shader of the tests' own.
#include "support/arithmetic.h"

#include <bit>
#include <cmath>
#include <vector>

#include "arithmetic_probe.h"
#include "gpu/embedded.h"
#include "gpu/recorder.h"
#include "support/cases.h"
#include "support/device.h"

namespace crsh::test {
namespace {

constexpr uint32_t trials = 4096;

bool same(float a, float b) { return std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b); }

std::vector<glm::vec4> random_operands() {
  Random random(1);
  std::vector<glm::vec4> operands;
  for (uint32_t i = 0; i < trials; ++i) {
    const float x = random.uniform(0.5f, 2), y = random.uniform(0.5f, 2);
    operands.emplace_back(x, y, -x * y, random.uniform(0x1p-130f, 0x1p-127f));
  }
  return operands;
}

Arithmetic tried() {
  gpu::replace_spirv("arithmetic.comp", {std::begin(arithmetic_probe), std::end(arithmetic_probe)});
  const std::vector<glm::vec4> operands = random_operands();
  gpu::Recorder recorder(device());
  const gpu::Buffer in = gpu::upload(device(), operands, "operands");
  const gpu::Buffer out(device(), trials * sizeof(glm::vec4), "results");
  recorder.dispatch("arithmetic", trials, trials, {{"operands", in}, {"results", out}});
  const std::vector<glm::vec4> results = recorder.read<glm::vec4>(out, trials);
  Arithmetic found;
  for (uint32_t i = 0; i < trials; ++i) {
    const glm::vec4 &a = operands[i], &r = results[i];
    found.division = found.division && same(r.x, a.x / a.y);
    found.square_root = found.square_root && same(r.y, std::sqrt(a.x));
    found.separate = found.separate && r.z == a.x * a.y + a.z;  // 0
    found.subnormals = found.subnormals && same(r.w, a.x * a.w);
  }
  return found;
}

}  // namespace

std::string Arithmetic::text() const {
  std::string text = device().info().name;
  if (!division) text += ", divides inexactly";
  if (!square_root) text += ", takes roots inexactly";
  if (!separate) text += ", fuses products and sums";
  if (!subnormals) text += ", has no subnormal numbers";
  return text;
}

const Arithmetic& arithmetic() {
  static const Arithmetic found = tried();
  return found;
}

}  // namespace crsh::test
