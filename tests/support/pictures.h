#pragma once
// Small pictures for the tests of files and comparisons.

#include <array>
#include <utility>

#include "crsh/picture.h"

namespace crsh::test {

/// One layer of `colour` all over.
inline Picture plain_picture(uint32_t width, uint32_t height, std::array<float, 4> colour) {
  Picture picture{.width = width, .height = height, .layers = {{"", {"R", "G", "B", "A"}, {}}}};
  for (size_t pixel = 0; pixel < size_t(width) * height; ++pixel)
    picture.layers[0].values.insert(picture.layers[0].values.end(), colour.begin(), colour.end());
  return picture;
}

/// All default layers, no two values alike.
inline Picture varied_picture(uint32_t width, uint32_t height) {
  Picture picture = plain_picture(width, height, {0, 0, 0, 1});
  picture.layers.push_back({"Z", {"Z"}, {}});
  picture.layers.push_back({"N", {"N.X", "N.Y", "N.Z"}, {}});
  picture.layers.push_back({"Albedo", {"Albedo.R", "Albedo.G", "Albedo.B"}, {}});
  float value = 0.001f;
  for (Layer& layer : picture.layers) {
    layer.values.resize(size_t(width) * height * layer.channels.size());
    for (float& sample : layer.values) sample = value += 0.0137f;
  }
  picture.world_to_camera[3] = {1, 2, 3, 1};
  picture.world_to_ndc[0][0] = 0.5f;
  return picture;
}

}  // namespace crsh::test
