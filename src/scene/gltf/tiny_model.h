#pragma once
// Runs tinygltf. It is compiled here, of the packaged header, without files and decoders.

#include <string>

namespace tinygltf {
class Model;
}

namespace crsh::scene {

/// What tinygltf reads in prepared JSON (prepare.h). A Fault with its reason where it refuses.
[[nodiscard]] tinygltf::Model tiny_model(const std::string& text);

}  // namespace crsh::scene
