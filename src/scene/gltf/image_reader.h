#pragma once
// The images of one glTF file: read when first asked for, decoded together.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/gltf/decode_images.h"
#include "scene/gltf/document.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Ask want() for all that will be drawn, then read() for each: the first read() decodes on all cores what was wanted.
/// What is read without that is decoded then. What comes out is the same either way.
class ImageReader {
 public:
  /// Why an image cannot be drawn, or, of one that is, what is wrong with it.
  struct Verdict {
    std::string reason;          ///< empty: nothing is wrong
    bool unread_format = false;  ///< nothing is wrong with the file: its format is not read here
  };

  explicit ImageReader(Document& document) : document_(document) {}

  /// Whether the image can be drawn, as far as its head tells. Those asked for first take up the 2 GiB that all may
  /// have together.
  bool want(int index);
  /// Its index in `images`, to which it is added when first read; none where it cannot be drawn.
  std::optional<uint32_t> read(int index, std::vector<Image>& images);
  /// Of an image that was read.
  [[nodiscard]] const Verdict& verdict(int index) const { return entries_.at(index).verdict; }

 private:
  struct Entry {
    std::string name;  ///< for messages; empty where the image lies in a buffer
    Bytes own;         ///< of a file of its own
    std::span<const uint8_t> bytes;
    ImageSize size;
    Verdict verdict;
    bool wanted = false;            ///< waits to be decoded
    std::optional<Image> picture;   ///< decoded and not yet read
    std::optional<uint32_t> place;  ///< in the scene
  };

  Entry& entry(int index);
  void open(Entry& entry, int index);
  void find_bytes(Entry& entry, int index);
  void decode_wanted();

  Document& document_;
  std::map<int, Entry> entries_;
  uint64_t texels_ = 0, bytes_waiting_ = 0;
};

}  // namespace crsh::scene
