#include "scene/gltf/draco.h"

#include <draco/compression/config/compression_shared.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <algorithm>
#include <cstring>
#include <memory>
#include <type_traits>

#include "scene/gltf/accessor.h"
#include "scene/gltf/extension.h"

namespace crsh::scene {

namespace {

constexpr const char* name = "KHR_draco_mesh_compression";

// Regular meshes compress to next to nothing: small files get so much for nothing, larger ones in proportion.
constexpr uint64_t free_elements = uint64_t{1} << 18u, elements_a_byte = 64;
constexpr uint64_t free_bytes = uint64_t{1} << 26u, bytes_a_byte = 1024;

constexpr uint16_t version(uint16_t major, uint16_t minor) { return static_cast<uint16_t>(major << 8u | minor); }

bool read_count(draco::DecoderBuffer& buffer, bool packed, uint32_t& count) {
  return packed ? draco::DecodeVarint(&count, &buffer) : buffer.Decode(&count);
}

/// Draco's decoder, stopped before it takes more memory than its data can be worth.
template <class Decoder>
class Bounded : public Decoder {
 public:
  explicit Bounded(uint64_t compressed) : compressed_(compressed) {}

 protected:
  bool DecodeConnectivity() override { return counts_fit() && Decoder::DecodeConnectivity(); }
  bool DecodeAllAttributes() override { return attributes_fit() && Decoder::DecodeAllAttributes(); }

 private:
  /// Reads ahead: two counts stand where the connectivity begins.
  bool counts_fit() {
    constexpr bool edgebreaker = std::is_same_v<Decoder, draco::MeshEdgebreakerDecoder>;
    draco::DecoderBuffer ahead = *this->buffer();
    const uint16_t bitstream = this->bitstream_version();
    const bool packed = bitstream >= (edgebreaker ? version(2, 0) : version(2, 2));
    uint32_t first = 0, second = 0, new_vertices = 0;
    if (edgebreaker && bitstream < version(2, 2) && !read_count(ahead, bitstream >= version(2, 0), new_vertices))
      return false;
    if (!read_count(ahead, packed, first) || !read_count(ahead, packed, second)) return false;
    return std::max(first, second) <= free_elements + elements_a_byte * compressed_;
  }

  bool attributes_fit() {
    const uint64_t points = std::max<uint64_t>(this->point_cloud()->num_points(), 3 * this->mesh()->num_faces());
    uint64_t bytes = 0;
    for (int32_t i = 0; i < this->point_cloud()->num_attributes(); ++i)
      bytes += points * static_cast<uint64_t>(std::max<int64_t>(this->point_cloud()->attribute(i)->byte_stride(), 0));
    return bytes <= free_bytes + bytes_a_byte * compressed_;
  }

  uint64_t compressed_;
};

template <class Decoder>
bool decode_with(draco::DecoderBuffer& buffer, size_t compressed, draco::Mesh& mesh) {
  Bounded<Decoder> decoder(compressed);
  return decoder.Decode(draco::DecoderOptions(), &buffer, &mesh).ok();
}

bool decode(std::span<const uint8_t> data, draco::Mesh& mesh) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(data.data()), data.size());
  draco::DecoderBuffer head = buffer;
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&head, &header).ok() || header.encoder_type != draco::TRIANGULAR_MESH)
    return false;
  if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING)
    return decode_with<draco::MeshSequentialDecoder>(buffer, data.size(), mesh);
  return header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING &&
         decode_with<draco::MeshEdgebreakerDecoder>(buffer, data.size(), mesh);
}

/// Converts all points' values to components of type T.
template <class T>
bool convert(const draco::PointAttribute& from, uint32_t points, uint32_t components, Bytes& out) {
  out.resize(size_t{points} * components * sizeof(T));
  for (uint32_t i = 0; i < points; ++i) {
    const draco::AttributeValueIndex value = from.mapped_index(draco::PointIndex(i));
    T converted[16] = {};
    if (value.value() >= from.size() || !from.ConvertValue<T>(value, static_cast<int8_t>(components), converted))
      return false;
    std::memcpy(out.data() + size_t{i} * components * sizeof(T), converted, components * sizeof(T));
  }
  return true;
}

bool convert(const draco::PointAttribute& from, uint32_t points, ElementType type, Bytes& out) {
  switch (type.component) {
    case Component::i8: return convert<int8_t>(from, points, type.components, out);
    case Component::u8: return convert<uint8_t>(from, points, type.components, out);
    case Component::i16: return convert<int16_t>(from, points, type.components, out);
    case Component::u16: return convert<uint16_t>(from, points, type.components, out);
    case Component::u32: return convert<uint32_t>(from, points, type.components, out);
    case Component::f32: break;
  }
  return convert<float>(from, points, type.components, out);
}

Decoded indices_of(const draco::Mesh& mesh) {
  Decoded out;
  out.count = 3 * uint64_t{mesh.num_faces()};
  out.type = {1, Component::u32};
  out.bytes.resize(out.count * sizeof(uint32_t));
  for (uint32_t f = 0; f < mesh.num_faces(); ++f)
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t point = mesh.face(draco::FaceIndex(f))[c].value();
      std::memcpy(out.bytes.data() + (size_t{f} * 3 + c) * sizeof point, &point, sizeof point);
    }
  return out;
}

/// The accessors of the primitive that the extension names, each with Draco's number of its attribute.
std::map<int64_t, int> compressed_accessors(const tinygltf::Primitive& primitive, const Extension& extension) {
  std::map<int64_t, int> out;
  const std::optional<Extension> attributes = extension.object("attributes");
  for (const auto& [attribute, accessor] : primitive.attributes)
    if (const int id = attributes ? attributes->index(attribute) : -1; id >= 0) out.emplace(accessor, id);
  return out;
}

void keep_attribute(Document& document, int64_t accessor, const draco::Mesh& mesh, int id, const std::string& where) {
  Decoded out;
  out.count = mesh.num_points();
  out.type = element_type(document, accessor);
  const draco::PointAttribute* from = mesh.GetAttributeByUniqueId(static_cast<uint32_t>(id));
  if (from == nullptr || !convert(*from, mesh.num_points(), out.type, out.bytes))
    throw Fault(where + " lacks the attribute " + std::to_string(id) + ", or holds it in another form");
  document.keep(accessor, std::move(out));
}

}  // namespace

void decompress_draco(Document& document, const tinygltf::Primitive& primitive, const std::string& where) {
  const std::optional<Extension> extension = Extension::of(primitive.extensions, name, where);
  if (!extension) return;
  const std::map<int64_t, int> accessors = compressed_accessors(primitive, *extension);
  const auto is_there = [&document](const auto& one) { return document.decoded(one.first) != nullptr; };
  const bool has_indices = primitive.indices < 0 || document.decoded(primitive.indices) != nullptr;
  if (has_indices && std::all_of(accessors.begin(), accessors.end(), is_there)) return;
  const std::span<const uint8_t> data = document.view(extension->index("bufferView"));
  draco::Mesh mesh;
  if (!decode(data, mesh)) throw Fault(where + " cannot be decompressed: its Draco data is broken, or claims too much");
  document.spend(uint64_t{mesh.num_points()} * accessors.size() + 3 * uint64_t{mesh.num_faces()});
  for (const auto& [accessor, id] : accessors) keep_attribute(document, accessor, mesh, id, where);
  if (primitive.indices >= 0) document.keep(primitive.indices, indices_of(mesh));
}

}  // namespace crsh::scene
