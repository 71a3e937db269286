#include "sim/app/image_files.h"

#include <algorithm>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "models/read/config_error.h"
#include "models/read/text_file.h"
#include "sim/base/files.h"
#include "sim/base/image_size.h"

namespace dockyard {
namespace {

// 40 megapixels of noise have 6 bytes each in a PNG of 16 bits a channel.
constexpr std::size_t kMaxImageBytes = std::size_t{256} << 20;

void RefuseUnlessUsable(const std::string& file, const std::string& bytes) {
  const std::optional<ImageSize> size = StatedImageSize(bytes);
  if (!size) {
    throw ConfigError(file +
                      ": expected an image (PNG, JPEG, PGM, PPM, BMP, TIFF or WebP), found "
                      "something else");
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
  cv::Mat decoded;
  try {
    const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1,
                         const_cast<char*>(bytes.data()));  // only read
    decoded = cv::imdecode(buffer, cv::IMREAD_GRAYSCALE);
  } catch (const cv::Exception&) {
    decoded.release();
  }
  if (decoded.empty()) {
    throw ConfigError(file + ": expected a whole image, found one that cannot be decoded");
  }
  GrayImage image{.width = decoded.cols, .height = decoded.rows, .pixels = {}};
  for (int y = 0; y < decoded.rows; ++y) {
    image.pixels.insert(image.pixels.end(), decoded.ptr(y), decoded.ptr(y) + decoded.cols);
  }
  return image;
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
  static const std::vector<std::string> kEndings{".png", ".pgm", ".ppm",  ".jpg", ".jpeg",
                                                 ".bmp", ".tif", ".tiff", ".webp"};
  if (!std::filesystem::is_directory(folder)) {
    throw ConfigError(folder + ": expected a folder of images, found none");
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

void DrawSighting(const std::string& file, const StereoImages& images,
                  const SightingReport& report) {
  const int width = images.left.width + images.right.width;
  const int height = std::max(images.left.height, images.right.height);
  cv::Mat canvas(height, width, CV_8UC3, cv::Scalar(0, 0, 0));
  const auto put = [&](const GrayImage& image, int x0) {
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        canvas.at<cv::Vec3b>(y, x0 + x) = cv::Vec3b::all(image.at(x, y));
      }
    }
  };
  put(images.left, 0);
  put(images.right, images.left.width);
  const auto ring = [&](const SightingReport::Mark& mark, const cv::Scalar& colour) {
    const double x = mark.u_px + (mark.camera == 1 ? images.left.width : 0);
    constexpr int kSub = 4;  // fractional bits of OpenCV's drawing
    const cv::Point at(static_cast<int>(std::lround(x * (1 << kSub))),
                       static_cast<int>(std::lround(mark.v_px * (1 << kSub))));
    const int size = std::max(4, width / 256);
    cv::circle(canvas, at, size << kSub, colour, 1, cv::LINE_AA, kSub);
    cv::putText(canvas, std::to_string(mark.id),
                cv::Point((at.x >> kSub) + size, (at.y >> kSub) - size), cv::FONT_HERSHEY_PLAIN,
                1.0, colour, 1, cv::LINE_AA);
  };
  for (const auto& mark : report.predicted) ring(mark, cv::Scalar(0, 140, 255));
  for (const auto& mark : report.marks) ring(mark, cv::Scalar(80, 220, 80));
  std::vector<std::uint8_t> png;
  cv::imencode(".png", canvas, png);
  WriteWhole(file, std::string_view(reinterpret_cast<const char*>(png.data()), png.size()));
}

}  // namespace dockyard
