#pragma once
// KHR_materials_variants: other materials for the same primitives.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/document.h"

namespace crsh::scene {

/// Of all variants in the file.
[[nodiscard]] std::vector<std::string> variant_names(const Document& document);

/// The variant with this index or name; none for an empty text. A Fault that lists them.
[[nodiscard]] std::optional<uint32_t> chosen_variant(const std::vector<std::string>& names, const std::string& which);

/// The material that the primitive wears in this variant: where it names none for it, its usual one. -1: none.
[[nodiscard]] int material_in(std::optional<uint32_t> variant, const tinygltf::Primitive& primitive,
                              const std::string& where);

}  // namespace crsh::scene
