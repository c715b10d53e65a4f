#include "scene/gltf/meshopt.h"

#include <meshoptimizer.h>

#include <cstring>
#include <limits>

#include "scene/gltf/fault.h"

namespace crsh::scene {

namespace {

// No codec packs more densely: of 256 elements alike, a byte of each takes at least 2 bits.
constexpr uint64_t densest = 1024;
constexpr uint64_t widest = 256;  // bytes of a vertex

bool is_index_size(uint64_t stride) { return stride == 2 || stride == 4; }

bool fits_mode(const CompressedView& view) {
  if (view.mode == "ATTRIBUTES") return view.stride > 0 && view.stride <= widest && view.stride % 4 == 0;
  if (view.mode == "TRIANGLES") return is_index_size(view.stride) && view.count % 3 == 0;
  return view.mode == "INDICES" && is_index_size(view.stride);
}

bool fits_filter(const CompressedView& view) {
  if (view.filter.empty() || view.filter == "NONE") return true;
  if (view.mode != "ATTRIBUTES") return false;
  if (view.filter == "OCTAHEDRAL" || view.filter == "COLOR") return view.stride == 4 || view.stride == 8;
  if (view.filter == "QUATERNION") return view.stride == 8;
  return view.filter == "EXPONENTIAL";
}

bool decode(const CompressedView& view, std::span<const uint8_t> data, Bytes& out) {
  if (view.mode == "ATTRIBUTES")
    return meshopt_decodeVertexBuffer(out.data(), view.count, view.stride, data.data(), data.size()) == 0;
  if (view.mode == "TRIANGLES")
    return meshopt_decodeIndexBuffer(out.data(), view.count, view.stride, data.data(), data.size()) == 0;
  return meshopt_decodeIndexSequence(out.data(), view.count, view.stride, data.data(), data.size()) == 0;
}

/// The first byte's lower half, by which all of its codecs begin.
uint32_t codec_version(std::span<const uint8_t> data) { return data.empty() ? 0 : data[0] & 0x0Fu; }

template <class Unsigned>
Unsigned rounded(int value, float scale) {
  return static_cast<Unsigned>(static_cast<int>(static_cast<float>(value) * scale + 0.5f));
}

/// KHR_meshopt_compression's filter COLOR: YCoCg, where alpha's highest bit tells how many bits all of them have.
template <class Unsigned, class Signed>
void undo_colour(Bytes& bytes) {
  for (size_t at = 0; at + 4 * sizeof(Unsigned) <= bytes.size(); at += 4 * sizeof(Unsigned)) {
    Unsigned c[4];
    std::memcpy(c, bytes.data() + at, sizeof c);
    unsigned bits = c[3];
    for (const unsigned shift : {1u, 2u, 4u, 8u}) bits |= bits >> shift;
    const int y = c[0], co = static_cast<Signed>(c[1]), cg = static_cast<Signed>(c[2]);
    const unsigned alpha = ((c[3] << 1u) & bits) | (c[3] & 1u);
    const float scale =
        bits == 0 ? 0 : static_cast<float>(std::numeric_limits<Unsigned>::max()) / static_cast<float>(bits);
    c[0] = rounded<Unsigned>(y + co - cg, scale);
    c[1] = rounded<Unsigned>(y + cg, scale);
    c[2] = rounded<Unsigned>(y - co - cg, scale);
    c[3] = rounded<Unsigned>(static_cast<int>(alpha), scale);
    std::memcpy(bytes.data() + at, c, sizeof c);
  }
}

void undo_filter(const CompressedView& view, Bytes& bytes) {
  if (view.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes.data(), view.count, view.stride);
  if (view.filter == "QUATERNION") meshopt_decodeFilterQuat(bytes.data(), view.count, view.stride);
  if (view.filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), view.count, view.stride);
  if (view.filter == "COLOR")
    view.stride == 4 ? undo_colour<uint8_t, int8_t>(bytes) : undo_colour<uint16_t, int16_t>(bytes);
}

}  // namespace

uint64_t checked_size(const CompressedView& view, const std::string& where) {
  if (!fits_mode(view))
    throw Fault(where + " has a count or byteStride that its mode " + in_quotes(view.mode, 20) + " cannot have");
  if (!fits_filter(view)) throw Fault(where + " has a filter " + in_quotes(view.filter, 20) + " that does not fit");
  if (view.count > view.length * densest / view.stride)
    throw Fault(where + " has more elements than its compressed bytes can hold");
  return view.count * view.stride;
}

Bytes decompressed(const CompressedView& view, std::span<const uint8_t> data, const std::string& where) {
  constexpr uint32_t usual_version = 1;  // what every release decodes, 0 alone for vertices
  Bytes out(view.count * view.stride);
  if (!decode(view, data, out)) {
    if (codec_version(data) >= usual_version)
      throw Fault(where + " is compressed by version " + std::to_string(codec_version(data)) +
                      " of meshoptimizer's codec, which the library here does not decode",
                  "export the scene again, or install a newer libmeshoptimizer");
    throw Fault(where + " cannot be decompressed");
  }
  undo_filter(view, out);
  return out;
}

}  // namespace crsh::scene
