// Compressed geometry that lies or is damaged ends with a line, in memory bounded by the file's size.

#include <doctest/doctest.h>

#include <random>

#include "../unit/compressed.h"
#include "complaint.h"

using namespace crsh;
using test::complaint;
using test::GltfText;
using test::replaced;
using test::says;

namespace {

const std::string four_vertices = R"("count":4,"mode":"ATTRIBUTES")";

/// The meshoptimizer square with one text of its first view replaced.
std::string square_with(const std::string& from, const std::string& to) {
  GltfText file = test::meshopt_square();
  file.views[0] = replaced(file.views[0], from, to);
  return complaint(file);
}

}  // namespace

TEST_CASE("a compressed view that claims what its mode or its bytes cannot hold is refused before memory is taken") {
  says(square_with(four_vertices, R"("count":1099511627776,"mode":"ATTRIBUTES")"),
       "bufferViews[0] has more elements than");
  says(square_with(four_vertices, R"("count":4000000,"mode":"ATTRIBUTES")"), "bufferViews[0] has more elements than");
  says(square_with(four_vertices, R"("count":4,"mode":"TRIANGLES")"), "that its mode 'TRIANGLES' cannot have");
  says(square_with(four_vertices, R"("count":4,"mode":"NONE")"), "that its mode 'NONE' cannot have");
  says(square_with(four_vertices, four_vertices + R"(,"filter":"QUATERNION")"),
       "a filter 'QUATERNION' that does not fit");
  says(square_with(R"("byteStride":12,"count")", R"("byteStride":6,"count")"),
       "that its mode 'ATTRIBUTES' cannot have");
  says(square_with(R"("byteStride":12,"count")", R"("byteStride":0,"count")"),
       "that its mode 'ATTRIBUTES' cannot have");
  says(square_with(R"("buffer":0,"byteOffset":0)", R"("buffer":0,"byteOffset":1000)"), "bufferViews[0] reaches past");
}

TEST_CASE("a view by a newer codec than the library knows says so") {
  GltfText file = test::meshopt_square();
  file.buffer[0] = static_cast<char>(0xAE);
  says(complaint(file), "is compressed by version 14 of meshoptimizer's codec, which the library here does not decode");
}

TEST_CASE("a buffer that is only there to be fallen back to, and is not, is not read as the file's own") {
  GltfText file = test::meshopt_square();
  file.accessors[0] = replaced(file.accessors[0], R"("bufferView":0)", R"("bufferView":2)");
  file.views.emplace_back(R"({"buffer":1,"byteLength":48})");
  says(complaint(file), "buffers[1] has no data");
}

TEST_CASE("Draco data that claims many faces in few bytes is refused before memory is taken") {
  GltfText file = test::draco_square(draco::MESH_SEQUENTIAL_ENCODING);
  const size_t counts = 11;  // behind "DRACO", the version, the type, the method and the flags
  REQUIRE(file.buffer[counts] == 2);
  std::string claims = file.buffer;
  claims.replace(counts, 1, "\xFF\xFF\xFF\x7F", 4);
  file.buffer = claims;
  file.views[0] = replaced(file.views[0], R"("byteLength":)" + std::to_string(claims.size() - 3),
                           R"("byteLength":)" + std::to_string(claims.size()));
  says(complaint(file), "cannot be decompressed");
}

TEST_CASE("Draco and meshoptimizer data damaged at random returns or is refused") {
  std::mt19937 random(8);
  for (const GltfText& whole : {test::draco_square(draco::MESH_SEQUENTIAL_ENCODING),
                                test::draco_square(draco::MESH_EDGEBREAKER_ENCODING), test::meshopt_square()}) {
    int refused = 0;
    for (int round = 0; round < 1500; ++round) {
      GltfText file = whole;
      for (uint32_t hits = 1 + random() % 3; hits > 0; --hits)
        file.buffer[random() % file.buffer.size()] = static_cast<char>(random());
      refused += !complaint(file).empty();
    }
    CHECK(refused > 100);
  }
}
