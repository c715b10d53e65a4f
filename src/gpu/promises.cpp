#include "gpu/promises.h"

#include <spirv/unified1/spirv.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <string_view>

namespace crsh::gpu {
namespace {

constexpr size_t header_words = 5;
// Newer than Debian 12's headers.
constexpr uint32_t maximally_reconverges = 6023;  // an execution mode
constexpr std::string_view reconvergence_spirv = "SPV_KHR_maximal_reconvergence";
constexpr uint32_t reconvergence_headers = VK_MAKE_API_VERSION(0, 1, 3, 280);  // of a layer that surely knows it

SpvOp op_of(uint32_t word) { return static_cast<SpvOp>(word & SpvOpCodeMask); }

void append(std::vector<uint32_t>& out, SpvOp op, std::initializer_list<uint32_t> operands) {
  out.push_back(uint32_t(operands.size() + 1) << SpvWordCountShift | op);
  out.insert(out.end(), operands);
}

void append_extension(std::vector<uint32_t>& out, std::string_view name) {
  const size_t words = name.size() / 4 + 1;
  out.push_back(uint32_t(words + 1) << SpvWordCountShift | SpvOpExtension);
  out.resize(out.size() + words, 0);
  std::memcpy(out.data() + out.size() - words, name.data(), name.size());
}

/// Where the parts of a module are that modes are added to, in words.
struct Parts {
  size_t capabilities_end = header_words, entry_points_end = header_words;
  uint32_t entry_point = 0;  ///< its function
  bool lanes_speak = false;
};

Parts parts_of(std::span<const uint32_t> spirv) {
  Parts parts;
  for (size_t at = header_words; at < spirv.size() && op_of(spirv[at]) != SpvOpFunction;) {
    const SpvOp op = op_of(spirv[at]);
    const size_t next = at + std::max(spirv[at] >> SpvWordCountShift, 1u);
    if (op == SpvOpCapability) {
      const uint32_t capability = spirv[at + 1];
      parts.lanes_speak |= capability > SpvCapabilityGroupNonUniform && capability <= SpvCapabilityGroupNonUniformQuad;
      parts.capabilities_end = next;
    }
    if (op == SpvOpEntryPoint) parts.entry_point = spirv[at + 2], parts.entry_points_end = next;
    at = next;
  }
  return parts;
}

}  // namespace

Promises promises_of(const DeviceInfo& info, uint32_t layer_version) {
  const bool known = layer_version == 0 || layer_version >= reconvergence_headers;
  return {.special_values = info.special_values, .reconverges = info.reconvergence && known};
}

std::vector<uint32_t> with_promises(std::span<const uint32_t> spirv, const Promises& promises) {
  const Parts parts = parts_of(spirv);
  const bool reconverges = promises.reconverges && parts.lanes_speak;
  std::vector<uint32_t> out(spirv.begin(), spirv.begin() + std::ptrdiff_t(parts.capabilities_end));
  if (promises.special_values) append(out, SpvOpCapability, {SpvCapabilitySignedZeroInfNanPreserve});
  if (reconverges) append_extension(out, reconvergence_spirv);
  out.insert(out.end(), spirv.begin() + std::ptrdiff_t(parts.capabilities_end),
             spirv.begin() + std::ptrdiff_t(parts.entry_points_end));
  const uint32_t bits = 32;
  if (promises.special_values)
    append(out, SpvOpExecutionMode, {parts.entry_point, SpvExecutionModeSignedZeroInfNanPreserve, bits});
  if (reconverges) append(out, SpvOpExecutionMode, {parts.entry_point, maximally_reconverges});
  out.insert(out.end(), spirv.begin() + std::ptrdiff_t(parts.entry_points_end), spirv.end());
  return out;
}

}  // namespace crsh::gpu
