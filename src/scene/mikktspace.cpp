#include "scene/mikktspace.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <span>

namespace crsh::scene {
namespace {

constexpr uint32_t none = 0xFFFFFFFFu;
/// Where more triangles than this have one tangent at a vertex, none is left out of it for going the opposite way:
/// each would have to be compared with all.
constexpr size_t most_compared = 128;

uint32_t next(uint32_t corner) { return corner == 2 ? 0 : corner + 1; }
uint32_t previous(uint32_t corner) { return corner == 0 ? 2 : corner - 1; }

/// What the algorithm knows of a triangle.
struct Face {
  glm::vec3 along_u{0}, along_v{0};                      // unit: where the point goes as u or v grows
  std::array<uint32_t, 3> neighbours{none, none, none};  // across the edge from a corner to the next
  std::array<bool, 3> grouped{};                         // by corner
  bool degenerate = false;                               // two of its corners are in one place
  bool loose = true;                                     // its u and v give no direction; it joins any neighbour
  bool preserving = false;                               // u and v turn the way the corners do
};

bool counts(float value) { return std::abs(value) > FLT_MIN && std::isfinite(value); }

glm::vec3 unit_or_zero(const glm::vec3& v) {
  const float length = glm::length(v);
  return length > 0 && std::isfinite(length) ? (1 / length) * v : glm::vec3(0);
}

/// A direction within the plane of a unit normal.
glm::vec3 projected(const glm::vec3& v, const glm::vec3& normal) {
  return unit_or_zero(v - glm::dot(normal, v) * normal);
}

/// All corners in use are `first` ones of welded().
class Tangents {
 public:
  explicit Tangents(const TangentMesh& mesh) : mesh_(mesh), triangles_(mesh.triangles), out_(mesh.triangles.size()) {
    const std::vector<uint32_t> first = welded(mesh);
    for (glm::uvec3& triangle : triangles_)
      for (int c = 0; c < 3; ++c) triangle[c] = first[triangle[c]];
    for (const glm::uvec3& triangle : triangles_) faces_.push_back(face_of(triangle));
  }

  std::vector<CornerTangents> compute() {
    find_neighbours();
    for (uint32_t f = 0; f < faces_.size(); ++f)
      for (uint32_t corner = 0; corner < 3; ++corner)
        if (!faces_[f].degenerate && !faces_[f].loose && !faces_[f].grouped[corner]) {
          gather_group(f, corner);
          measure_group(triangles_[f][int(corner)]);
          write_group(faces_[f].preserving);
        }
    fill_degenerate();
    return std::move(out_);
  }

 private:
  /// A triangle of the group at hand, seen from the vertex that its triangles share.
  struct Member {
    uint32_t face;
    uint32_t corner;
    glm::vec3 along_u{0}, along_v{0};  // within the plane of the vertex' normal
    float angle = 0;                   // between the edges at the vertex, there; radians
  };

  [[nodiscard]] Face face_of(const glm::uvec3& t) const {
    Face face;
    const glm::vec3 &a = mesh_.positions[t.x], &b = mesh_.positions[t.y], &c = mesh_.positions[t.z];
    face.degenerate = a == b || b == c || c == a;
    const glm::vec2 du = mesh_.uv[t.y] - mesh_.uv[t.x], dv = mesh_.uv[t.z] - mesh_.uv[t.x];
    const float area = du.x * dv.y - du.y * dv.x;  // twice the signed area in u and v
    face.preserving = area > 0;
    const glm::vec3 along_u = dv.y * (b - a) - du.y * (c - a), along_v = -dv.x * (b - a) + du.x * (c - a);
    const float u_length = glm::length(along_u), v_length = glm::length(along_v), sign = area > 0 ? 1.0f : -1.0f;
    face.loose = !counts(area) || !counts(u_length / std::abs(area)) || !counts(v_length / std::abs(area));
    if (!face.loose) {
      face.along_u = (sign / u_length) * along_u;
      face.along_v = (sign / v_length) * along_v;
    }
    return face;
  }

  /// Pairs triangles that have an edge in opposite directions: of those along one edge the first of one direction with
  /// the first of the other, and so on.
  void find_neighbours() {
    const std::vector<uint32_t> begin = edges_from_each();
    for (size_t low = 0; low + 1 < begin.size(); ++low) {
      const auto edges = std::span(edges_).subspan(begin[low], begin[low + 1] - begin[low]);
      std::sort(edges.begin(), edges.end());
      for (size_t first = 0, last = 0; first < edges.size(); first = last) {
        while (last < edges.size() && edges[last] >> 32 == edges[first] >> 32) ++last;
        pair_up(edges.subspan(first, last - first), uint32_t(low));
      }
    }
    edges_ = {};
  }

  /// Fills edges_, ordered by the lower of their two vertices, with the higher one << 32 | 3 * triangle + corner.
  /// Returns where those of each lower vertex begin, and where all end.
  std::vector<uint32_t> edges_from_each() {
    std::vector<uint32_t> begin(mesh_.positions.size() + 2, 0);
    for_each_edge([&](uint32_t low, uint32_t, uint32_t) { ++begin[low + 2]; });
    for (size_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
    edges_.resize(begin.back());
    for_each_edge(
        [&](uint32_t low, uint32_t high, uint32_t place) { edges_[begin[low + 1]++] = uint64_t(high) << 32 | place; });
    begin.pop_back();
    return begin;
  }

  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    for (uint32_t f = 0; f < faces_.size(); ++f)
      for (uint32_t corner = 0; corner < 3 && !faces_[f].degenerate; ++corner) {
        const uint32_t a = triangles_[f][int(corner)], b = triangles_[f][int(next(corner))];
        visit(std::min(a, b), std::max(a, b), 3 * f + corner);
      }
  }

  /// Edges between the same two vertices, in order of their triangles.
  void pair_up(std::span<const uint64_t> edges, uint32_t low) {
    const auto place = [&](size_t i) { return uint32_t(edges[i]); };
    const auto rises = [&](size_t i) { return triangles_[place(i) / 3][int(place(i) % 3)] == low; };
    size_t up = 0, down = 0;
    for (;; ++up, ++down) {
      while (up < edges.size() && !rises(up)) ++up;
      while (down < edges.size() && rises(down)) ++down;
      if (up >= edges.size() || down >= edges.size()) return;
      faces_[place(up) / 3].neighbours[place(up) % 3] = place(down) / 3;
      faces_[place(down) / 3].neighbours[place(down) % 3] = place(up) / 3;
    }
  }

  /// The triangles round a vertex that can be reached over edges without changing orientation.
  void gather_group(uint32_t face, uint32_t corner) {
    const uint32_t vertex = triangles_[face][int(corner)];
    const bool preserving = faces_[face].preserving;
    members_.assign(1, {face, corner});
    faces_[face].grouped[corner] = true;
    for (uint32_t at = faces_[face].neighbours[corner]; join(at, vertex, preserving);)
      at = faces_[at].neighbours[members_.back().corner];
    for (uint32_t at = faces_[face].neighbours[previous(corner)]; join(at, vertex, preserving);)
      at = faces_[at].neighbours[previous(members_.back().corner)];
    std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) { return a.face < b.face; });
  }

  /// A loose triangle takes the orientation of the first group that it joins.
  bool join(uint32_t at, uint32_t vertex, bool preserving) {
    if (at == none) return false;
    Face& face = faces_[at];
    const glm::uvec3& t = triangles_[at];
    const uint32_t corner = t.x == vertex ? 0 : t.y == vertex ? 1 : 2;
    if (face.grouped[corner]) return false;
    if (face.loose && !face.grouped[0] && !face.grouped[1] && !face.grouped[2]) face.preserving = preserving;
    if (face.preserving != preserving) return false;
    face.grouped[corner] = true;
    members_.push_back({at, corner});
    return true;
  }

  void measure_group(uint32_t vertex) {
    const glm::vec3 &normal = mesh_.normals[vertex], &place = mesh_.positions[vertex];
    for (Member& member : members_) {
      const Face& face = faces_[member.face];
      if (face.loose) continue;
      const glm::uvec3& t = triangles_[member.face];
      const auto edge_to = [&](uint32_t corner) { return projected(mesh_.positions[t[int(corner)]] - place, normal); };
      member.along_u = projected(face.along_u, normal);
      member.along_v = projected(face.along_v, normal);
      const float cosine = glm::dot(edge_to(previous(member.corner)), edge_to(next(member.corner)));
      member.angle = std::acos(std::clamp(cosine, -1.0f, 1.0f));
    }
  }

  void write_group(bool preserving) {
    if (members_.size() > most_compared || none_opposed()) {
      const glm::vec4 all = tangent_of([](const Member&) { return true; }, preserving);
      for (const Member& member : members_) out_[member.face][member.corner] = all;
      return;
    }
    for (const Member& member : members_)
      out_[member.face][member.corner] = tangent_of([&](const Member& m) { return !opposed(member, m); }, preserving);
  }

  /// Whether it is clear at once that no two go opposite ways: all go about the same.
  [[nodiscard]] bool none_opposed() const {
    const auto first =
        std::find_if(members_.begin(), members_.end(), [&](const Member& m) { return !faces_[m.face].loose; });
    return std::all_of(members_.begin(), members_.end(), [&](const Member& m) {
      return faces_[m.face].loose ||
             (glm::dot(m.along_u, first->along_u) > 0.1f && glm::dot(m.along_v, first->along_v) > 0.1f);
    });
  }

  /// Whether u or v run exactly against one another in two triangles: their mean would be no direction.
  [[nodiscard]] bool opposed(const Member& a, const Member& b) const {
    if (a.face == b.face || faces_[a.face].loose || faces_[b.face].loose) return false;
    return glm::dot(a.along_u, b.along_u) <= -1 || glm::dot(a.along_v, b.along_v) <= -1;
  }

  /// The mean of u's directions in the members that are `in`, weighted by their angles. MikkTSpace's sign is for v that
  /// goes up; glTF's goes down.
  template <class In>
  [[nodiscard]] glm::vec4 tangent_of(const In& in, bool preserving) const {
    glm::vec3 sum(0);
    for (const Member& member : members_)
      if (in(member)) sum += member.angle * member.along_u;
    const glm::vec3 tangent = unit_or_zero(sum);
    return tangent == glm::vec3(0) ? glm::vec4(0) : glm::vec4(tangent, preserving ? -1.0f : 1.0f);
  }

  /// Corners of triangles without extent take the tangent of another triangle at the same vertex.
  void fill_degenerate() {
    std::vector<uint32_t> corner_at(mesh_.positions.size(), none);
    for (uint32_t f = uint32_t(faces_.size()); f-- > 0;)
      for (uint32_t corner = 3; corner-- > 0 && !faces_[f].degenerate;)
        corner_at[triangles_[f][int(corner)]] = 3 * f + corner;
    for (size_t f = 0; f < faces_.size(); ++f)
      for (uint32_t corner = 0; corner < 3 && faces_[f].degenerate; ++corner)
        if (const uint32_t from = corner_at[triangles_[f][int(corner)]]; from != none)
          out_[f][corner] = out_[from / 3][from % 3];
  }

  const TangentMesh& mesh_;
  std::vector<glm::uvec3> triangles_;
  std::vector<Face> faces_;
  std::vector<uint64_t> edges_;
  std::vector<Member> members_;  // of the group at hand
  std::vector<CornerTangents> out_;
};

}  // namespace

std::vector<CornerTangents> mikktspace(const TangentMesh& mesh) { return Tangents(mesh).compute(); }

}  // namespace crsh::scene
