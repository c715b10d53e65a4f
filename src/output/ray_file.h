#pragma once
// Tables of rays as NPZ files, which numpy.load reads and numpy.savez writes. The arrays are RayTable's columns:
//
//   origin, direction  float32 (rays, 3)     key            uint64 (rays,)
//   tmax, t            float32 (rays,)       transmittance  uint32 (rays, 3)
//   kind, bounce, past_backs  uint8 (rays,)         kinds          words (kinds,): the names of kind's numbers
//                                            image          uint32 (2,): width and height
//                                            centre         float64 (3,)
//   light, pixel, path, batch, sorted, hit   uint32 (rays,)
//
// Origins are measured from `centre`, a place in the scene file's coordinates: there far from 0,0,0 float32 could not
// tell them apart. Without it they are the file's coordinates.

#include <filesystem>
#include <string>

#include "crsh/ray_table.h"

namespace crsh::output {

/// The same table gives the same bytes.
[[nodiscard]] std::string encode_rays(const RayTable& table);

/// encode_rays to a file that appears whole or not at all.
void write_rays(const std::filesystem::path& path, const RayTable& table);

/// A file with origin, direction, tmax and kind, of float32 or float64 and of any integers; where the others are
/// missing, bounce, past_backs, light, pixel, batch and centre are 0 and path is 1. Without kinds, 0 to 2 are
/// shadow, reflection and refraction. Without image, rays stay in the file's order. What became of the rays is not
/// read, but for `key`. Throws UserError that begins with the path: no archive, no such array, another shape or type, a
/// number that no ray has.
[[nodiscard]] RayTable read_rays(const std::filesystem::path& path);

}  // namespace crsh::output
