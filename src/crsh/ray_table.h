#pragma once
// Rays as data: every ray of a frame and what became of it (--dump-rays), or rays to be traced (--replay-rays).

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace crsh {

/// Columns of equal length, or empty where nothing is known, with a row a ray. A frame's rows are in creation order: by
/// sample, portion of the image, bounce, kind and light.
struct RayTable {
  // What is traced.
  std::vector<glm::vec3> origin;     ///< metres, from `centre`; a shadow ray's is the light's end
  std::vector<glm::vec3> direction;  ///< unit
  std::vector<float> tmax;           ///< metres; infinity for closest-hit rays
  std::vector<uint32_t> kind;        ///< shared::kind_*
  std::vector<uint32_t> bounce;      ///< surfaces passed
  std::vector<uint32_t> light;       ///< where there is a ray a light: its index
  std::vector<uint32_t> past_backs;  ///< 1: an any-hit ray that passes the backs of single-sided triangles
  // Where it belongs.
  std::vector<uint32_t> pixel;  ///< row-major in the image
  std::vector<uint32_t> path;   ///< 1, then shared::path_bits a bounce: RayKind::turn (0 reflected, 1 refracted)
  std::vector<uint32_t> batch;  ///< rays of one batch, bounce, kind and light are sorted and bundled together
  // What became of it.
  std::vector<uint64_t> key;     ///< its hash, without kind and light; 0 where rays are not sorted
  std::vector<uint32_t> sorted;  ///< its place among all rays after sorting; batches follow each other
  std::vector<uint32_t> hit;     ///< the closest triangle, in the order in which the scene draws them, or `none`
  std::vector<float> t;          ///< where; infinity: nothing
  std::vector<glm::uvec3> transmittance;  ///< of any-hit rays: shared::Hit's words

  uint32_t width = 0, height = 0;  ///< of the image; 0: unknown
  glm::dvec3 centre{0};            ///< where origins are measured from, in the file's coordinates

  [[nodiscard]] uint32_t size() const { return static_cast<uint32_t>(origin.size()); }
};

/// Calls `visit(column)` for every column of `table`.
template <class Table, class Visit>
void for_columns(Table& table, Visit visit) {
  visit(table.origin), visit(table.direction), visit(table.tmax), visit(table.kind), visit(table.bounce);
  visit(table.past_backs), visit(table.light), visit(table.pixel), visit(table.path), visit(table.batch),
      visit(table.key), visit(table.sorted);
  visit(table.hit), visit(table.t), visit(table.transmittance);
}

/// Gives every column so many rows; new ones are zeros.
void resize(RayTable& table, size_t rows);

/// The rows of these numbers, in this order.
[[nodiscard]] RayTable rows_of(const RayTable& table, std::span<const uint32_t> numbers);

}  // namespace crsh
