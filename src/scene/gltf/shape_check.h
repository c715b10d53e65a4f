#pragma once
// Holds JSON against a shape.

#include <nlohmann/json_fwd.hpp>

#include "scene/gltf/shape.h"

namespace crsh::scene {

/// Brings the whole file into its shape: removes what the shape does not name, fills in what it says, and writes whole
/// numbers as integers and others as floats. A Fault, which names the field, where a value does not fit.
void bring_into_shape(nlohmann::json& root, const Shape& shape);

}  // namespace crsh::scene
