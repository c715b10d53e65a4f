#pragma once
// A rendered frame: linear float layers, rows from the top.

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace crsh {

/// One named layer of `channels` interleaved floats a pixel ("" is the beauty, RGBA premultiplied).
struct Layer {
  std::string name;  ///< "" (the beauty), "Z", "N", "Albedo", ...: see crsh/layers.h
  /// names as in the EXR: {"R","G","B","A"}, {"Z"}, {"N.X","N.Y","N.Z"}, {"Albedo.R",...}
  std::vector<std::string> channels;
  std::vector<float> values;  ///< width * height * channels.size()
  std::vector<uint32_t> ids;  ///< in place of `values` where the layer is of ids
};

struct Picture {
  uint32_t width = 0, height = 0;
  std::vector<Layer> layers;      ///< the beauty first
  glm::dmat4 world_to_camera{1};  ///< OpenEXR's worldToCamera, of the file's coordinates
  glm::dmat4 world_to_ndc{1};     ///< OpenEXR's worldToNDC, of the file's coordinates
  [[nodiscard]] const Layer* find(const std::string& name) const {
    for (const Layer& layer : layers)
      if (layer.name == name) return &layer;
    return nullptr;
  }
};

}  // namespace crsh
