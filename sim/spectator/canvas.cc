#include "sim/spectator/canvas.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace dockyard {
namespace {

const cv::Scalar kMeasured(80, 220, 80), kPredicted(255, 140, 0);  // red first
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;

/// The picture's own pixels.
cv::Mat PixelsOf(RgbImage& picture) {
  return {picture.height, picture.width, CV_8UC3, picture.pixels.data()};
}

std::string Ascii(std::string text) {
  for (char& c : text) {
    if (c < 0x20 || c > 0x7e) c = '?';
  }
  return text;
}

constexpr int kSub = 4;  // fractional bits of OpenCV's drawing

cv::Point SubPixel(double u_px, double v_px) {
  return {static_cast<int>(std::lround(u_px * (1 << kSub))),
          static_cast<int>(std::lround(v_px * (1 << kSub)))};
}

}  // namespace

void DrawMarks(RgbImage& picture, const SightingReport& report, int camera, double scale) {
  cv::Mat pixels = PixelsOf(picture);
  const int size = std::max(4, picture.width / 128);
  const auto draw = [&](const SightingReport::Mark& mark, const cv::Scalar& colour, bool cross) {
    const double u = scale * mark.u_px, v = scale * mark.v_px;
    if (mark.camera != camera || !(std::abs(u) < 1e5) || !(std::abs(v) < 1e5)) return;
    cv::circle(pixels, SubPixel(u, v), size << kSub, colour, 1, cv::LINE_AA, kSub);
    const double reach = 0.6 * size;
    for (const double slope : {-1.0, 1.0}) {
      if (!cross) break;
      cv::line(pixels, SubPixel(u - reach, v - slope * reach),
               SubPixel(u + reach, v + slope * reach), colour, 1, cv::LINE_AA, kSub);
    }
    cv::putText(pixels, std::to_string(mark.id),
                cv::Point(static_cast<int>(u) + size, static_cast<int>(v) - size),
                cv::FONT_HERSHEY_PLAIN, 1.0, colour, 1, cv::LINE_AA);
  };
  for (const auto& mark : report.predicted) draw(mark, kPredicted, true);
  for (const auto& mark : report.marks) draw(mark, kMeasured, false);
}

void DrawWords(RgbImage& picture, Corner at, const std::vector<std::string>& lines,
               double height_px) {
  cv::Mat pixels = PixelsOf(picture);
  constexpr double kFontHeight_px = 34.0;  // of a line at scale 1
  const double scale = height_px / kFontHeight_px;
  const int step = static_cast<int>(std::lround(height_px)), edge = std::max(2, step / 4);
  int widest = 0;
  for (const std::string& line : lines) {
    int below = 0;
    widest = std::max(widest, cv::getTextSize(Ascii(line), kFont, scale, 1, &below).width);
  }
  const int height = step * static_cast<int>(lines.size()) + edge;
  cv::rectangle(pixels,
                cv::Rect(at.x, at.y, widest + 2 * edge, height) &
                    cv::Rect(0, 0, picture.width, picture.height),
                cv::Scalar(25, 25, 25), cv::FILLED);
  int y = at.y;
  for (const std::string& line : lines) {
    y += step;
    cv::putText(pixels, Ascii(line), cv::Point(at.x + edge, y - edge), kFont, scale,
                cv::Scalar(255, 255, 255), 1, cv::LINE_AA);
  }
}

RgbImage Resized(const RgbImage& picture, int width) {
  const double scale = static_cast<double>(width) / std::max(1, picture.width);
  const int height = std::max(1, static_cast<int>(std::lround(scale * picture.height)));
  RgbImage source = picture, resized{width, height, {}};
  resized.pixels.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  cv::Mat pixels = PixelsOf(resized);
  cv::resize(PixelsOf(source), pixels, pixels.size(), 0.0, 0.0, cv::INTER_AREA);
  return resized;
}

void PutInset(RgbImage& picture, Corner at, const RgbImage& inset) {
  RgbImage edged = inset;
  cv::Mat from = PixelsOf(edged), pixels = PixelsOf(picture);
  cv::rectangle(from, cv::Rect(0, 0, inset.width, inset.height), cv::Scalar(230, 230, 230), 1);
  const cv::Rect place = cv::Rect(at.x, at.y, inset.width, inset.height) &
                         cv::Rect(0, 0, picture.width, picture.height);
  if (place.empty()) return;
  from(cv::Rect(place.x - at.x, place.y - at.y, place.width, place.height)).copyTo(pixels(place));
}

RgbImage SideBySide(const RgbImage& left, const RgbImage& right) {
  RgbImage both{left.width + right.width, std::max(left.height, right.height), {}};
  both.pixels.assign(3 * static_cast<std::size_t>(both.width) * both.height, 0);
  const auto put = [&](const RgbImage& image, int x0) {
    for (int y = 0; y < image.height; ++y) {
      std::copy_n(image.pixels.begin() + 3 * std::ptrdiff_t{y} * image.width, 3 * image.width,
                  both.pixels.begin() + 3 * (std::ptrdiff_t{y} * both.width + x0));
    }
  };
  put(left, 0);
  put(right, left.width);
  return both;
}

}  // namespace dockyard
