#include "scene/gltf/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "scene/bounding.h"
#include "scene/gltf/accessor.h"
#include "scene/gltf/checked.h"
#include "scene/gltf/deformers.h"
#include "scene/gltf/draco.h"
#include "scene/gltf/variants.h"

namespace crsh::scene {

namespace {

constexpr uint32_t unused = DeformReader::unused_vertex;
constexpr uint64_t triangle_cost = 16;  // in units of Document::spend: 67 million triangles, some 7 GiB, are too many
constexpr float farthest = 1e15f;       // metres; squares and products stay within float

/// Places in a Layout.
enum Attribute : size_t { position, normal, tangent, colour, first_uv, attribute_count = first_uv + uv_sets };

/// The accessors of a primitive's attributes. Primitives with the same share vertices.
using Layout = std::array<std::optional<int>, attribute_count>;

std::string name_of(size_t attribute, const std::array<uint32_t, uv_sets>& texcoords) {
  constexpr std::array names = {"POSITION", "NORMAL", "TANGENT", "COLOR_0"};
  return attribute < first_uv ? names[attribute] : "TEXCOORD_" + std::to_string(texcoords[attribute - first_uv]);
}

glm::vec4 clamped(glm::vec4 colour) {
  for (int c = 0; c < 4; ++c) colour[c] = colour[c] >= 0 ? std::min(colour[c], 1.0f) : 0.0f;  // also NaN becomes 0
  return colour;
}

glm::vec3 unit_or_zero(const glm::vec3& v) {
  const double length = glm::length(glm::dvec3(v));
  return std::isfinite(length) && length > 0 ? glm::vec3(glm::dvec3(v) / length) : glm::vec3(0);
}

glm::vec2 finite_or_zero(const glm::vec4& v) {
  return {std::isfinite(v.x) ? v.x : 0.0f, std::isfinite(v.y) ? v.y : 0.0f};
}

/// The vertices of one layout, copied to the mesh when a triangle first uses them.
class Vertices {
 public:
  Vertices(Document& document, const Layout& layout) {
    for (size_t a = 0; a < layout.size(); ++a)
      if (layout[a]) sources_[a].emplace(document, *layout[a]);
    check();
    document.spend(count());
    kept_.assign(count(), unused);
  }

  [[nodiscard]] uint64_t count() const { return sources_[0]->count(); }
  /// For each vertex of the file its place in the mesh, or unused.
  [[nodiscard]] const std::vector<uint32_t>& kept() const { return kept_; }

  /// Why nothing can be drawn with vertex i of the file; null: it can.
  [[nodiscard]] const char* fault_of(uint64_t i) const {
    if (i >= count()) return "has an index past the end of its vertices";
    if (kept_[i] != unused) return nullptr;
    const glm::vec3 position(sources_[0]->at(i));
    const bool finite =
        std::abs(position.x) <= farthest && std::abs(position.y) <= farthest && std::abs(position.z) <= farthest;
    return finite ? nullptr : "has a position that is not finite";
  }

  /// The mesh's vertex for vertex i of the file, which has no fault.
  uint32_t vertex(Mesh& mesh, uint64_t i) {
    if (kept_[i] == unused) kept_[i] = append(mesh, i);
    return kept_[i];
  }

 private:
  void check() const {
    for (size_t a = 0; a < sources_.size(); ++a) {
      if (!sources_[a]) continue;
      if (a == position || a == normal) sources_[a]->need_components({3});
      if (a == tangent) sources_[a]->need_components({4});
      if (a == colour) sources_[a]->need_components({3, 4});
      if (a >= first_uv) sources_[a]->need_components({2});
      if (sources_[a]->count() != count())
        throw Fault(sources_[a]->where() + " has not as many elements as the positions");
    }
  }

  uint32_t append(Mesh& mesh, uint64_t i) const {
    mesh.positions.push_back(glm::vec3(sources_[position]->at(i)));
    mesh.normals.push_back(unit_or_zero(glm::vec3(optional(normal, i))));
    mesh.colours.push_back(colour_at(i));
    append_sparse(mesh.tangents, sources_[tangent].has_value(), mesh, [&] { return tangent_at(i); });
    for (size_t set = 0; set < uv_sets; ++set)
      append_sparse(mesh.uv[set], sources_[first_uv + set].has_value(), mesh,
                    [&] { return finite_or_zero(optional(first_uv + set, i)); });
    return static_cast<uint32_t>(mesh.positions.size() - 1);
  }

  /// Appends to an attribute that stays empty until a primitive has it; the vertices before then have zeros.
  template <class T, class Read>
  static void append_sparse(std::vector<T>& values, bool has, const Mesh& mesh, const Read& read) {
    if (!has && values.empty()) return;
    values.resize(mesh.positions.size() - 1, T(0));
    values.push_back(has ? read() : T(0));
  }

  [[nodiscard]] glm::vec4 optional(size_t attribute, uint64_t i) const {
    return sources_[attribute] ? sources_[attribute]->at(i) : glm::vec4(0);
  }

  [[nodiscard]] glm::vec4 tangent_at(uint64_t i) const {
    const glm::vec4 value = sources_[tangent]->at(i);
    return {unit_or_zero(glm::vec3(value)), value.w < 0 ? -1.0f : 1.0f};
  }

  [[nodiscard]] PackedColour colour_at(uint64_t i) const {
    if (!sources_[colour]) return white;
    glm::vec4 value = sources_[colour]->at(i);
    if (sources_[colour]->components() == 3) value.a = 1;
    return packed_colour(clamped(value));
  }

  std::array<std::optional<Accessor>, attribute_count> sources_;
  std::vector<uint32_t> kept_;
};

/// The corners of triangle t of a list, strip or fan (glTF 2.0, section 3.7.2.1).
std::array<uint64_t, 3> corners(int mode, uint64_t t) {
  if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) return {t, t + 1 + t % 2, t + 2 - t % 2};
  if (mode == TINYGLTF_MODE_TRIANGLE_FAN) return {t + 1, t + 2, 0};
  return {3 * t, 3 * t + 1, 3 * t + 2};
}

/// Corners of a primitive, one behind the other.
struct Run {
  uint64_t first = 0, count = 0;
};

/// What lies between primitive restart values: the largest that the indices' type holds, where no vertex has it. glTF
/// forbids them; other programs draw such files as graphics devices do.
std::vector<Run> runs_of(const Accessor& indices, uint64_t vertices) {
  const uint64_t restart = indices.component() == Component::u8    ? 0xFFu
                           : indices.component() == Component::u16 ? 0xFFFFu
                                                                   : 0xFFFFFFFFu;
  if (vertices > restart) return {{0, indices.count()}};
  std::vector<Run> out;
  uint64_t first = 0;
  for (uint64_t i = 0; i <= indices.count(); ++i) {
    if (i < indices.count() && indices.integer_at(i) != restart) continue;
    if (i - first >= 3) out.push_back({first, i - first});
    first = i + 1;
  }
  return out;
}

class MeshReader {
 public:
  MeshReader(Document& document, Notes& notes, uint32_t default_material, const MeshOptions& options)
      : document_(document), notes_(notes), default_material_(default_material), options_(options) {}

  void add(const tinygltf::Primitive& primitive, const std::string& where) {
    document_.check(where);
    note_what_is_left_out(primitive);
    if (primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) throw Fault(where + ".mode is none of glTF's");
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES) return notes_.add("points and lines");
    const Layout layout = layout_of(primitive);
    if (!layout[0]) return notes_.add("primitives without positions");
    decompress_draco(document_, primitive, where);
    const Block block{layout, deform_layout(primitive)};
    auto found = blocks_.find(block);
    if (found == blocks_.end()) found = blocks_.try_emplace(block, document_, layout).first;
    const uint32_t material = material_of(primitive, where);
    append_triangles(primitive, where, found->second);
    mesh.materials.resize(mesh.triangles.size(), material);
  }

  /// Reads what deforms the mesh, once all its vertices are known. `where`: of its primitives.
  void add_deformers(const std::vector<double>& weights, const std::string& where) {
    DeformReader reader(document_, notes_);
    for (const auto& [block, vertices] : blocks_) reader.add(block.second, vertices.kept(), where);
    reader.finish(weights, mesh);
  }

  Mesh mesh;

 private:
  using Block = std::pair<Layout, DeformLayout>;

  [[nodiscard]] Layout layout_of(const tinygltf::Primitive& primitive) const {
    Layout layout;
    for (size_t a = 0; a < layout.size(); ++a)
      if (const auto found = primitive.attributes.find(name_of(a, options_.texcoords));
          found != primitive.attributes.end())
        layout[a] = found->second;
    return layout;
  }

  void note_what_is_left_out(const tinygltf::Primitive& primitive) {
    if (primitive.attributes.contains("COLOR_1")) notes_.add("vertex colours past COLOR_0");
  }

  uint32_t material_of(const tinygltf::Primitive& primitive, const std::string& where) const {
    const int material = material_in(options_.variant, primitive, where);
    if (material < 0) return default_material_;
    if (static_cast<uint32_t>(material) >= default_material_) throw Fault(where + ".material is not in the file");
    return static_cast<uint32_t>(material);
  }

  void append_triangles(const tinygltf::Primitive& primitive, const std::string& where, Vertices& vertices) {
    std::optional<Accessor> indices;
    if (primitive.indices >= 0) {
      indices.emplace(document_, primitive.indices);
      indices->need_indices();
    }
    const uint64_t corners = indices ? indices->count() : vertices.count();
    const std::vector<Run> runs = indices ? runs_of(*indices, vertices.count()) : std::vector<Run>{{0, corners}};
    for (const Run& run : runs) append_run(primitive.mode, run, indices, vertices);
    if (dropped_ > 0)
      notes_.leave_out(std::to_string(dropped_) + " triangles of " + where, Fault(where + " " + fault_));
    dropped_ = 0;
  }

  void append_run(int mode, const Run& run, const std::optional<Accessor>& indices, Vertices& vertices) {
    const uint64_t many =
        mode == TINYGLTF_MODE_TRIANGLES ? run.count / 3 : run.count - std::min<uint64_t>(run.count, 2);
    document_.spend(many * triangle_cost);
    for (uint64_t t = 0; t < many; ++t) {
      std::array<uint64_t, 3> places = corners(mode, t);
      for (uint64_t& place : places) place = indices ? indices->integer_at(run.first + place) : place;
      append_triangle(places, vertices);
    }
  }

  /// Leaves it out where one of its corners has a fault.
  void append_triangle(const std::array<uint64_t, 3>& places, Vertices& vertices) {
    for (const uint64_t place : places)
      if (const char* fault = vertices.fault_of(place)) {
        fault_ = dropped_++ == 0 ? fault : fault_;
        return;
      }
    glm::uvec3 triangle;
    for (int c = 0; c < 3; ++c) triangle[c] = vertices.vertex(mesh, places[static_cast<size_t>(c)]);
    mesh.triangles.push_back(triangle);
  }

  Document& document_;
  Notes& notes_;
  uint32_t default_material_;
  MeshOptions options_;
  std::map<Block, Vertices> blocks_;
  uint64_t dropped_ = 0;         // triangles of the primitive at hand
  const char* fault_ = nullptr;  // of the first of them
};

/// Attributes that the last primitives did not have.
void fill_up(Mesh& mesh) {
  const size_t count = mesh.positions.size();
  if (!mesh.tangents.empty()) mesh.tangents.resize(count, glm::vec4(0));
  for (std::vector<glm::vec2>& uv : mesh.uv)
    if (!uv.empty()) uv.resize(count, glm::vec2(0));
}

}  // namespace

Mesh read_mesh(Document& document, int64_t index, uint32_t default_material, Notes& notes, const MeshOptions& options) {
  const tinygltf::Mesh& from = at(document.model().meshes, index, "meshes");
  const std::string where = place("meshes", index) + ".primitives";
  MeshReader reader(document, notes, default_material, options);
  reader.mesh.name = from.name;
  if (from.primitives.empty()) throw Fault(where + " is missing");
  for (size_t i = 0; i < from.primitives.size(); ++i) {
    const std::string here = place(where, static_cast<int64_t>(i));
    notes.attempt(here, [&] { reader.add(from.primitives[i], here); });
  }
  fill_up(reader.mesh);
  reader.add_deformers(from.weights, where);
  fill_bounds(reader.mesh);
  return std::move(reader.mesh);
}

}  // namespace crsh::scene
