#ifndef CRSH_SHARED_TYPES_H
#define CRSH_SHARED_TYPES_H
// Names that let one header compile as C++ (GLM) and as GLSL (scalar layout).
// Records are made of words of 16 bytes: on lavapipe a vec4 takes as long as two scalars to load.

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace crsh::shared {
using glm::mat4;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = uint32_t;
}  // namespace crsh::shared
#define CRSH_SHARED_BEGIN namespace crsh::shared {
#define CRSH_SHARED_END }
#define CRSH_CONST inline constexpr
#else
#define CRSH_SHARED_BEGIN
#define CRSH_SHARED_END
#define CRSH_CONST const
#endif

#endif
