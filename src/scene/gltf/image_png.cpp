// PNG, by libpng.

#include <png.h>
#include <csetjmp>
#include <cstring>
#include <vector>

#include "scene/gltf/image_format.h"

namespace crsh::scene {

namespace {

constexpr std::array<uint8_t, 8> start = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

bool is_png(std::span<const uint8_t> bytes) { return begins_with(bytes, start); }

uint32_t big_endian(std::span<const uint8_t> bytes) {
  return uint32_t{bytes[0]} << 24u | uint32_t{bytes[1]} << 16u | uint32_t{bytes[2]} << 8u | bytes[3];
}

/// The first chunk is IHDR, and that begins with width and height.
ImageSize png_size(std::span<const uint8_t> bytes) {
  if (bytes.size() < 24) throw Fault("is cut short");
  if (std::memcmp(&bytes[12], "IHDR", 4) != 0) throw Fault("cannot be decoded");
  return {big_endian(bytes.subspan(16)), big_endian(bytes.subspan(20))};
}

/// libpng, reading from memory. Its errors jump: between run() and libpng no object may need its destructor.
class PngReader {
 public:
  explicit PngReader(std::span<const uint8_t> bytes)
      : rest_(bytes), png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, [](png_structp, auto) {})) {
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) png_destroy_read_struct(&png_, nullptr, nullptr);
    if (info_ == nullptr) throw std::bad_alloc();
    png_set_read_fn(png_, this, read);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  /// Whether `step(png, info)` came to its end.
  template <class Step>
  bool run(const Step& step) {
    if (setjmp(back_) != 0) return false;
    step(png_, info_);
    return true;
  }
  /// Whether libpng asked for more than there is.
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  [[noreturn]] static void fail(png_structp png, png_const_charp) {
    std::longjmp(static_cast<PngReader*>(png_get_error_ptr(png))->back_, 1);
  }
  static void read(png_structp png, png_bytep to, size_t count) {
    auto& self = *static_cast<PngReader*>(png_get_io_ptr(png));
    self.ended_ = count > self.rest_.size();
    if (self.ended_) png_error(png, "ended");
    std::memcpy(to, self.rest_.data(), count);
    self.rest_ = self.rest_.subspan(count);
  }

  std::span<const uint8_t> rest_;
  std::jmp_buf back_{};
  bool ended_ = false;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

/// Of all chunks but those that make the picture nothing is read: not gAMA and iCCP, as glTF says, and no texts, which
/// may unpack to any length. Wrong checksums of chunks are let pass.
void be_lenient(png_structp png) {
  static constexpr char left_out[] =
      "bKGD\0cHRM\0eXIf\0gAMA\0hIST\0iCCP\0iTXt\0oFFs\0pCAL\0pHYs\0sBIT\0sCAL\0sPLT\0sRGB\0sTER\0tEXt\0tIME\0zTXt";
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, reinterpret_cast<png_const_bytep>(left_out),
                              sizeof left_out / 5);
  png_set_crc_action(png, PNG_CRC_QUIET_USE, PNG_CRC_QUIET_USE);
  png_set_user_limits(png, longest_image_side, longest_image_side);
}

/// Palettes, grey, fewer bits and more, with and without transparency: all become RGBA8.
void ask_for_rgba8(png_structp png) {
  png_set_expand(png);    // palettes and 1, 2, 4 bits; tRNS becomes alpha
  png_set_scale_16(png);  // rounds to nearest
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
}

/// A file that ends before its last row is not drawn: viewers differ on what they make of it. What follows that row is
/// not looked at.
std::string decode_png(std::span<const uint8_t> bytes, ImageSize size, std::span<uint8_t> rgba) {
  std::vector<png_bytep> rows(size.height);
  for (size_t y = 0; y < rows.size(); ++y) rows[y] = &rgba[y * size.width * 4];
  PngReader reader(bytes);
  const bool whole = reader.run([&](png_structp png, png_infop info) {
    be_lenient(png);
    png_read_info(png, info);
    ask_for_rgba8(png);
    png_read_update_info(png, info);
    if (png_get_rowbytes(png, info) != size_t{size.width} * 4) png_error(png, "of another size");
    png_read_image(png, rows.data());
  });
  if (!whole) throw Fault(reader.ended() ? "is cut short" : "cannot be decoded");
  return {};
}

}  // namespace

// Deflate compresses to 1/1032 at best, and a byte has up to eight texels.
const ImageFormat png_format = {is_png, png_size, decode_png, 8 * 1032 + 64};

}  // namespace crsh::scene
