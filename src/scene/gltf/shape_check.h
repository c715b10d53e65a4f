#pragma once
// Holds JSON against a shape.

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scene/gltf/shape.h"

namespace crsh::scene {

/// Brings the whole file into its shape: removes what the shape does not name, fills in what it says, and writes whole
/// numbers as integers and others as floats. A Fault, which names the field, where a value does not fit; in a list
/// whose elements have a stand-in, it takes the element's place, and `broken` gets the reason.
void bring_into_shape(nlohmann::json& root, const Shape& shape, std::map<std::string, std::string>& broken);

}  // namespace crsh::scene
