#include "sim/app/image_files.h"

#include <algorithm>
#include <filesystem>

#include "models/read/config_error.h"
#include "models/read/near_names.h"
#include "models/read/text_file.h"
#include "sim/base/files.h"
#include "sim/images/decode.h"
#include "sim/images/image_size.h"

namespace dockyard {
namespace {

// 40 megapixels of noise have 6 bytes each in a PNG of 16 bits a channel.
constexpr std::size_t kMaxImageBytes = std::size_t{256} << 20;

/// What a user may take for one of the formats.
std::string OtherKind(std::string_view bytes) {
  if (bytes.starts_with("BM")) return "a BMP";
  if (bytes.starts_with("II*") || bytes.starts_with(std::string_view("MM\0*", 4))) return "a TIFF";
  if (bytes.starts_with("GIF8")) return "a GIF";
  return "something else";
}

void RefuseUnlessUsable(const std::string& file, const std::string& bytes) {
  const std::optional<ImageSize> size = StatedImageSize(bytes);
  if (!size) {
    throw ConfigError(file + ": expected an image (PNG, JPEG, PGM, PPM or WebP), found " +
                      OtherKind(bytes));
  }
  if (size->usable()) return;
  throw ConfigError(file + ": expected an image of 1 to " +
                    std::to_string(kMaxImagePixels / 1000000) + " million pixels, found " +
                    std::to_string(size->width) + " x " + std::to_string(size->height));
}

}  // namespace

GrayImage LoadGray(const std::string& file) {
  const std::string bytes = ReadBytes(file, kMaxImageBytes);
  RefuseUnlessUsable(file, bytes);
  std::optional<GrayImage> image = DecodeGray(bytes);
  if (!image) {
    throw ConfigError(file + ": expected a whole image, found one that cannot be decoded");
  }
  return std::move(*image);
}

GrayImage UpsideDown(const GrayImage& image) {
  GrayImage turned = image;
  std::reverse(turned.pixels.begin(), turned.pixels.end());
  return turned;
}

bool IsCutJpeg(const std::string& file) {
  const auto bytes = ReadWhole(file);
  if (!bytes || bytes->size() < 4 || bytes->compare(0, 2, "\xff\xd8") != 0) return false;
  // A thumbnail has marks of its own, all before the scan of the image itself.
  const std::size_t scan = bytes->rfind("\xff\xda");
  return scan == std::string::npos || bytes->find("\xff\xd9", scan) == std::string::npos;
}

std::vector<std::string> ImageFilesIn(const std::string& folder) {
  // BMP and TIFF are refused, each by its name.
  const std::vector<std::string> kEndings{".png", ".pgm", ".ppm",  ".jpg", ".jpeg",
                                          ".bmp", ".tif", ".tiff", ".webp"};
  if (!std::filesystem::is_directory(folder)) {
    throw ConfigError(folder + ": expected a folder of images, found none" +
                      DidYouMeanFile(folder));
  }
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::string ending = entry.path().extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end() &&
        !entry.is_directory()) {
      files.push_back(entry.path().string());
    }
  }
  if (files.empty()) throw ConfigError(folder + ": expected images in the folder, found none");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace dockyard
