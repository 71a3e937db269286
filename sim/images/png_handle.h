// libpng with its errors as a result. It tells of an error by a jump back, so the steps given to
// Run must hold nothing that is to be destroyed.
#pragma once

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <string>
#include <string_view>

namespace dockyard {

class PngHandle {
 public:
  PngHandle(const PngHandle&) = delete;
  PngHandle& operator=(const PngHandle&) = delete;

  /// False at libpng's first error.
  template <class Steps>
  bool Run(const Steps& steps) {
    if (png == nullptr || info == nullptr || setjmp(png_jmpbuf(png)) != 0) return false;
    steps();
    return true;
  }

  png_structp png = nullptr;
  png_infop info = nullptr;

 protected:
  PngHandle() = default;
  ~PngHandle() = default;

  static void Fail(png_structp png, png_const_charp) { png_longjmp(png, 1); }
  static void Ignore(png_structp, png_const_charp) {}
};

/// Writes into a string.
class PngWriter : public PngHandle {
 public:
  PngWriter() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, Fail, Ignore);
    if (png == nullptr) return;
    info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, Append, [](png_structp) {});
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }

  std::string bytes;

 private:
  static void Append(png_structp png, png_bytep data, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))
        ->append(reinterpret_cast<const char*>(data), count);
  }
};

/// Reads from bytes, which outlive it.
class PngReader : public PngHandle {
 public:
  explicit PngReader(std::string_view bytes) : rest_(bytes) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, Fail, Ignore);
    if (png == nullptr) return;
    info = png_create_info_struct(png);
    png_set_read_fn(png, &rest_, Take);
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

 private:
  static void Take(png_structp png, png_bytep to, std::size_t count) {
    auto* rest = static_cast<std::string_view*>(png_get_io_ptr(png));
    if (count > rest->size()) png_error(png, "the file ends early");
    std::memcpy(to, rest->data(), count);
    rest->remove_prefix(count);
  }

  std::string_view rest_;
};

}  // namespace dockyard
