#include "scene/gltf/instancing.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>

#include "scene/gltf/accessor.h"

namespace crsh::scene {

namespace {

/// The accessors that move instances; whatever else the extension has (ids, colours) is the application's own.
class Attributes {
 public:
  Attributes(Document& document, const Extension& extension) {
    const std::optional<Extension> list = extension.object("attributes");
    if (!list) return;
    open(document, *list, "TRANSLATION", 3, translation_);
    open(document, *list, "ROTATION", 4, rotation_);
    open(document, *list, "SCALE", 3, scale_);
  }

  [[nodiscard]] uint64_t count() const { return count_.value_or(0); }

  [[nodiscard]] glm::mat4 transform(uint64_t i) const {
    glm::mat4 out(1);
    if (translation_) out = glm::translate(out, glm::vec3(translation_->at(i)));
    if (rotation_) out = out * glm::mat4_cast(rotation(i));
    return scale_ ? glm::scale(out, glm::vec3(scale_->at(i))) : out;
  }

 private:
  void open(Document& document, const Extension& list, const char* name, uint32_t components,
            std::optional<Accessor>& out) {
    if (!list.has(name)) return;
    out.emplace(document, list.index(name));
    out->need_components({components});
    if (out->count() != count_.value_or(out->count()))
      throw Fault(out->where() + " has not as many elements as the other attributes of " + list.where());
    count_ = out->count();
  }

  /// glTF writes x, y, z, w. What is not of unit length is made so, zero is no rotation.
  [[nodiscard]] glm::quat rotation(uint64_t i) const {
    const glm::vec4 v = rotation_->at(i);
    const glm::quat out(v.w, v.x, v.y, v.z);
    const float length = glm::length(out);
    return length > 0 ? out / length : glm::quat(1, 0, 0, 0);
  }

  std::optional<uint64_t> count_;
  std::optional<Accessor> translation_, rotation_, scale_;
};

void check_finite(const glm::mat4& transform, const std::string& where) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(transform[c][r])) throw Fault(where + " has an instance whose place is not finite");
}

}  // namespace

std::vector<glm::mat4> instance_transforms(Document& document, const Extension& extension, uint64_t max) {
  const Attributes attributes(document, extension);
  if (attributes.count() > max) throw Fault(extension.where() + " has too many instances", "simplify the scene");
  document.spend(attributes.count());
  std::vector<glm::mat4> out;
  out.reserve(attributes.count());
  for (uint64_t i = 0; i < attributes.count(); ++i) {
    out.push_back(attributes.transform(i));
    check_finite(out.back(), extension.where());
  }
  return out;
}

}  // namespace crsh::scene
