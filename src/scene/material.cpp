#include "scene/material.h"

namespace crsh::scene {

bool has_lobes(const Material& material) {
  return material.unlit || material.texture(Slot::thickness).texture || material.specular != Specular{} ||
         material.clearcoat.factor > 0 || material.sheen.colour != glm::vec3(0) || material.iridescence.factor > 0 ||
         material.anisotropy.strength != 0 || material.attenuation != Attenuation{} ||
         material.diffuse_transmission.factor > 0 || material.specular_glossiness.has_value() ||
         material.dispersion > 0;
}

bool needs_tangents(const Material& material) {
  return material.texture(Slot::normal).texture || material.texture(Slot::clearcoat_normal).texture ||
         material.anisotropy.strength != 0;
}

}  // namespace crsh::scene
