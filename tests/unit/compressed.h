#pragma once
// Geometry compressed by the packaged libraries, for files made in the tests.

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <cstdint>
#include <string>
#include <vector>

#include "scene_file.h"

namespace crsh::test {

/// Triangles by Draco, three floats a corner, not quantised. The attribute's number is 0. `method`: sequential or
/// edgebreaker.
inline std::string draco_bytes(const std::vector<float>& corners, int method) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(corners.size() / 9));
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (size_t f = 0; f < corners.size() / 9; ++f)
    builder.SetAttributeValuesForFace(positions, draco::FaceIndex(static_cast<uint32_t>(f)), &corners[9 * f],
                                      &corners[9 * f + 3], &corners[9 * f + 6]);
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer out;
  encoder.EncodeMeshToBuffer(*builder.Finalize(), &out);
  return {out.data(), out.size()};
}

/// Two triangles, compressed by Draco: accessors 0 and 1 are positions and indices without data.
inline GltfText draco_square(int method) {
  GltfText file;
  file.view(draco_bytes({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, method));
  file.accessor("VEC3", 5126, 4, "");
  file.accessor("SCALAR", 5123, 6, "");
  file.primitives =
      R"({"attributes":{"POSITION":0},"indices":1,"extensions":{"KHR_draco_mesh_compression":{"bufferView":0,
"attributes":{"POSITION":0}}}})";
  return file;
}

/// Appends compressed bytes, and a view of what they are once decompressed: `count` elements of `stride` bytes.
/// `members`: the extension's mode and filter.
inline size_t compressed_view(GltfText& file, const std::string& bytes, size_t stride, size_t count,
                              const std::string& members, const std::string& extension = "EXT_meshopt_compression") {
  while (file.buffer.size() % 4 != 0) file.buffer += '\0';
  const std::string size = std::to_string(stride * count), place = std::to_string(file.buffer.size());
  file.buffer += bytes;
  file.views.push_back(R"({"buffer":1,"byteLength":)" + size + R"(,"byteStride":)" + std::to_string(stride) +
                       R"(,"extensions":{")" + extension + R"(":{"buffer":0,"byteOffset":)" + place +
                       R"(,"byteLength":)" + std::to_string(bytes.size()) + R"(,"byteStride":)" +
                       std::to_string(stride) + R"(,"count":)" + std::to_string(count) + "," + members + "}}}");
  return file.views.size() - 1;
}

inline std::string meshopt_vertices(const void* vertices, size_t count, size_t stride) {
  std::string out(meshopt_encodeVertexBufferBound(count, stride), '\0');
  out.resize(
      meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(), vertices, count, stride));
  return out;
}

inline std::string meshopt_triangles(const std::vector<uint32_t>& indices) {
  std::string out(meshopt_encodeIndexBufferBound(indices.size(), 64), '\0');
  out.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(), indices.data(),
                                       indices.size()));
  return out;
}

/// The unit square, compressed by meshoptimizer: positions and indices, whose views name a buffer that is not there.
inline GltfText meshopt_square() {
  GltfText file;
  const std::vector<uint32_t> indices = {0, 1, 2, 2, 1, 3};
  compressed_view(file, meshopt_vertices(unit_square.data(), 4, 12), 12, 4, R"("mode":"ATTRIBUTES")");
  compressed_view(file, meshopt_triangles(indices), 4, 6, R"("mode":"TRIANGLES")");
  file.accessor("VEC3", 5126, 4, R"(,"bufferView":0)");
  file.accessor("SCALAR", 5125, 6, R"(,"bufferView":1)");
  file.primitives = R"({"attributes":{"POSITION":0},"indices":1})";
  file.more_buffers = R"(,{"byteLength":72,"extensions":{"EXT_meshopt_compression":{"fallback":true}}})";
  return file;
}

}  // namespace crsh::test
