#include <csetjmp>
#include <cstdio>
#include <type_traits>

#include "sim/images/formats.h"
#include "sim/images/image_size.h"
// Needs <cstdio> before it.
#include <jpeglib.h>

namespace dockyard {
namespace {

// A progressive image of the usual encoders has about ten scans. Each costs time over the whole
// image, so a small file with thousands would take hours.
constexpr int kMostScans = 100;

struct Errors : jpeg_error_mgr {
  std::jmp_buf escape;
};

[[noreturn]] void Escape(j_common_ptr jpeg) {
  std::longjmp(static_cast<Errors*>(jpeg->err)->escape, 1);
}

/// libjpeg's reader. It tells of an error by a jump back to Read, which therefore holds nothing
/// that must be destroyed.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {
    jpeg_.err = jpeg_std_error(&errors_);
    errors_.error_exit = Escape;
    errors_.output_message = [](j_common_ptr) {};
    progress_.progress_monitor = [](j_common_ptr jpeg) {
      if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > kMostScans) Escape(jpeg);
    };
  }
  ~Reader() { jpeg_destroy_decompress(&jpeg_); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// False when it is no image that we read. `image` then holds anything.
  template <class Image>
  bool Read(Image& image) {
    constexpr int kChannels = std::is_same_v<Image, RgbImage> ? 3 : 1;
    if (setjmp(errors_.escape) != 0) return false;
    jpeg_create_decompress(&jpeg_);
    jpeg_.progress = &progress_;
    jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size());
    jpeg_read_header(&jpeg_, TRUE);
    if (!ImageSize{jpeg_.image_width, jpeg_.image_height}.usable()) return false;
    if (jpeg_.num_components != 1 && jpeg_.num_components != 3) return false;
    jpeg_.out_color_space = kChannels == 3 ? JCS_RGB : JCS_GRAYSCALE;
    image.width = static_cast<int>(jpeg_.image_width);
    image.height = static_cast<int>(jpeg_.image_height);
    const std::size_t row_bytes = static_cast<std::size_t>(kChannels) * image.width;
    image.pixels.resize(row_bytes * image.height);
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height) {
      JSAMPROW row = image.pixels.data() + jpeg_.output_scanline * row_bytes;
      jpeg_read_scanlines(&jpeg_, &row, 1);
    }
    jpeg_finish_decompress(&jpeg_);
    return true;
  }

 private:
  std::string_view bytes_;
  jpeg_decompress_struct jpeg_{};
  Errors errors_{};
  jpeg_progress_mgr progress_{};
};

}  // namespace

std::optional<GrayImage> GrayFromJpeg(std::string_view bytes) {
  GrayImage image;
  if (!Reader(bytes).Read(image)) return std::nullopt;
  return image;
}

std::optional<RgbImage> RgbFromJpeg(std::string_view bytes) {
  RgbImage image;
  if (!Reader(bytes).Read(image)) return std::nullopt;
  return image;
}

}  // namespace dockyard
