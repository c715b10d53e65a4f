// JPEG, by libjpeg-turbo.

#include <csetjmp>
#include <cstddef>
#include <cstdio>

#include <jpeglib.h>

#include <jerror.h>
#include <algorithm>

#include "scene/gltf/image_format.h"

namespace crsh::scene {

namespace {

constexpr std::array<uint8_t, 3> start = {0xFF, 0xD8, 0xFF};

bool is_jpeg(std::span<const uint8_t> bytes) { return begins_with(bytes, start); }

/// libjpeg, reading from memory. Its errors jump: between run() and libjpeg no object may need its destructor.
class JpegReader {
 public:
  explicit JpegReader(std::span<const uint8_t> bytes) : bytes_(bytes) {
    jpeg_.err = jpeg_std_error(&errors_);
    jpeg_.client_data = this;
    errors_.error_exit = [](j_common_ptr jpeg) { std::longjmp(of(jpeg).back_, 1); };
    errors_.emit_message = [](j_common_ptr jpeg, int level) {
      if (level < 0) of(jpeg).take_warning(jpeg->err->msg_code);
    };
    errors_.output_message = [](j_common_ptr) {};
    progress_.progress_monitor = watch;
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  /// Runs `step(jpeg)` behind the head; a Fault where libjpeg gives up.
  template <class Step>
  void run(const Step& step) {
    if (setjmp(back_) != 0) throw Fault(too_many_scans_ ? "has too many scans" : ended_ ? "is cut short" : broken);
    jpeg_create_decompress(&jpeg_);
    jpeg_.progress = &progress_;
    jpeg_mem_src(&jpeg_, bytes_.data(), bytes_.size());
    jpeg_read_header(&jpeg_, TRUE);
    several_scans_ = jpeg_has_multiple_scans(&jpeg_) != 0;
    step(jpeg_);
  }

  /// What viewers draw of a damaged file is what libjpeg makes of it: the last texels' colour for what is missing in a
  /// row of blocks, grey below. So do we, and say so. Files that lack nothing but their end marker get no remark; where
  /// a picture comes in several scans, the last of them may be what is missing.
  [[nodiscard]] std::string remark() const {
    if (ended_ && (damaged_ || several_scans_)) return "is cut short";
    return damaged_ ? "is damaged" : "";
  }

 private:
  static constexpr const char* broken = "cannot be decoded";

  static JpegReader& of(j_common_ptr jpeg) { return *static_cast<JpegReader*>(jpeg->client_data); }

  void take_warning(int code) {
    ended_ |= code == JWRN_JPEG_EOF;
    damaged_ |= code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE || code == JWRN_ARITH_BAD_CODE ||
                code == JWRN_MUST_RESYNC;
  }

  /// Each scan passes over the whole picture, and a hostile one takes a few bytes. Files have ten or so.
  static void watch(j_common_ptr jpeg) {
    JpegReader& self = of(jpeg);
    const uint64_t texels = std::max(uint64_t{self.jpeg_.image_width} * self.jpeg_.image_height, uint64_t{1});
    const uint64_t most = std::clamp((uint64_t{1} << 31u) / texels, uint64_t{32}, uint64_t{512});
    self.too_many_scans_ = static_cast<uint64_t>(self.jpeg_.input_scan_number) > most;
    if (self.too_many_scans_) std::longjmp(self.back_, 1);
  }

  std::span<const uint8_t> bytes_;
  jpeg_decompress_struct jpeg_{};
  jpeg_error_mgr errors_{};
  jpeg_progress_mgr progress_{};
  std::jmp_buf back_{};
  bool ended_ = false, damaged_ = false, several_scans_ = false, too_many_scans_ = false;
};

ImageSize jpeg_size(std::span<const uint8_t> bytes) {
  ImageSize size;
  JpegReader(bytes).run([&](jpeg_decompress_struct& jpeg) { size = {jpeg.image_width, jpeg.image_height}; });
  return size;
}

/// Inks to light. Adobe, and all that follow it, store 255 for no ink (Adobe technical note 5116).
void inks_to_light(std::span<uint8_t> row, bool inverted) {
  const auto light = [&](uint32_t ink) { return inverted ? ink : 255 - ink; };
  for (size_t i = 0; i < row.size(); i += 4) {
    for (size_t c = 0; c < 3; ++c)
      row[i + c] = static_cast<uint8_t>((light(row[i + c]) * light(row[i + 3]) + 127) / 255);
    row[i + 3] = 255;
  }
}

/// What libjpeg converts to: from grey, YCbCr and RGB the texels themselves, from CMYK and YCCK the inks.
void decode_rows(jpeg_decompress_struct& jpeg, ImageSize size, std::span<uint8_t> rgba) {
  const bool inks = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
  jpeg.out_color_space = inks ? JCS_CMYK : JCS_EXT_RGBA;
  jpeg_start_decompress(&jpeg);
  const size_t stride = size_t{size.width} * 4;
  while (jpeg.output_scanline < jpeg.output_height) {
    const std::span<uint8_t> row = rgba.subspan(jpeg.output_scanline * stride, stride);
    JSAMPROW to = row.data();
    jpeg_read_scanlines(&jpeg, &to, 1);
    if (inks) inks_to_light(row, jpeg.saw_Adobe_marker != 0);
  }
}

std::string decode_jpeg(std::span<const uint8_t> bytes, ImageSize size, std::span<uint8_t> rgba) {
  JpegReader reader(bytes);
  reader.run([&](jpeg_decompress_struct& jpeg) { decode_rows(jpeg, size, rgba); });
  return reader.remark();
}

}  // namespace

// A block of 8 x 8 samples takes a bit at least, and one of a picture's components may have one for four blocks' texels
// in each direction.
const ImageFormat jpeg_format = {is_jpeg, jpeg_size, decode_jpeg, 8 * 1024};

}  // namespace crsh::scene
