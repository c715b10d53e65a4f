#include "scene/gltf/decode_images.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <numeric>

namespace crsh::scene {

namespace {

/// Lets in pictures while those inside have no more texels together than this. 8 bytes a texel are what decoders take.
class Gate {
 public:
  void enter(uint64_t texels) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return inside_ == 0 || inside_ + texels <= most_texels; });
    inside_ += texels;
  }
  void leave(uint64_t texels) {
    const std::lock_guard lock(mutex_);
    inside_ -= texels;
    changed_.notify_all();
  }

 private:
  static constexpr uint64_t most_texels = uint64_t{1} << 27u;
  std::mutex mutex_;
  std::condition_variable changed_;
  uint64_t inside_ = 0;
};

class Visit {
 public:
  Visit(Gate& gate, uint64_t texels) : gate_(gate), texels_(texels) { gate_.enter(texels_); }
  ~Visit() { gate_.leave(texels_); }
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;

 private:
  Gate& gate_;
  uint64_t texels_;
};

Decoding decoding_of(std::span<const uint8_t> bytes) {
  try {
    return {decode_image(bytes), {}};
  } catch (const Fault& fault) {
    return {{}, fault.what()};
  }
}

/// The largest first: no core is left with one of them when the others are done.
std::vector<size_t> largest_first(std::span<const EncodedImage> images) {
  std::vector<size_t> order(images.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return images[a].size.texels() > images[b].size.texels(); });
  return order;
}

}  // namespace

std::vector<Decoding> decode_images(std::span<const EncodedImage> images, unsigned threads) {
  const std::vector<size_t> order = largest_first(images);
  std::vector<Decoding> out(images.size());
  Gate gate;
  in_parallel(images.size(), threads, [&](size_t i) {
    const EncodedImage& image = images[order[i]];
    const Visit visit(gate, image.size.texels());
    out[order[i]] = decoding_of(image.bytes);
  });
  return out;
}

}  // namespace crsh::scene
