#include "scene/gltf/tiny_model.h"

// tinygltf 2.7 uses streams without including them where it has no files.
#include <fstream>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>

#include "scene/gltf/fault.h"

namespace crsh::scene {

namespace {

/// Callbacks that find, read and write nothing. Prepared JSON names no file, so none is called.
template <class Callbacks>
Callbacks no_files() {
  Callbacks out{};
  out.FileExists = [](const std::string&, void*) { return false; };
  out.ExpandFilePath = [](const std::string&, void*) { return std::string(); };
  out.ReadWholeFile = [](std::vector<unsigned char>*, std::string*, const std::string&, void*) { return false; };
  out.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; };
  if constexpr (requires { out.GetFileSizeInBytes; })
    out.GetFileSizeInBytes = [](size_t*, std::string*, const std::string&, void*) { return false; };
  return out;
}

bool no_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

std::string refusal(const std::string& reason) { return "is refused by tinygltf: " + printable(reason, 200); }

}  // namespace

tinygltf::Model tiny_model(const std::string& text) {
  if (text.size() > std::numeric_limits<int>::max()) throw Fault("its JSON is larger than 2 GiB", "split the scene");
  tinygltf::TinyGLTF reader;
  reader.SetFsCallbacks(no_files<tinygltf::FsCallbacks>());
  reader.SetImageLoader(no_image, nullptr);
  tinygltf::Model model;
  std::string reason, warning;
  try {
    if (!reader.LoadASCIIFromString(&model, &reason, &warning, text.data(), static_cast<unsigned>(text.size()), ""))
      throw Fault(refusal(reason));
  } catch (const Fault&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::length_error&) {
    throw;
  } catch (const std::exception& error) {
    throw Fault(refusal(error.what()));
  }
  return model;
}

}  // namespace crsh::scene
