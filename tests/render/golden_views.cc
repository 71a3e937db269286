#include "render/golden_views.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <opencv2/imgcodecs.hpp>

#include "sim/plant/light.h"

namespace dockyard {

const std::vector<GoldenView>& GoldenViews() {
  static const std::vector<GoldenView> views = {{"even_2.5m", Light::kEven, 2.5},
                                                {"speckled_2.5m", Light::kSpeckled, 2.5},
                                                {"hard_shadow_2.5m", Light::kHardShadow, 2.5},
                                                {"hard_shadow_1.1m", Light::kHardShadow, 1.1}};
  return views;
}

std::unique_ptr<Yard> GoldenYard(const GoldenView& view) {
  auto yard = SampleYard(view.range_m, {0, 0, 1});
  const Lighting lighting = MakeLighting(view.light, Pose3{}, yard->scene.boards[0].X_WB.p, 1);
  yard->scene.light = lighting.sun_and_sky;
  for (const SceneObject& occluder : lighting.occluders) yard->scene.objects.push_back(occluder);
  return yard;
}

StereoRig GoldenRig() { return SampleRig(320, 240); }

GrayImage DrawGolden(const Yard& yard, const StereoRig& rig) {
  return StereoRenderer()
      .Render(yard.scene, rig, yard.X_WR,
              {.vignetting_exponent = 1.0, .blur_sigma_px = 0.5, .noise_key = 7})
      .left;
}

ImageDifference Compare(const GrayImage& a, const GrayImage& b) {
  if (a.width != b.width || a.height != b.height) throw std::runtime_error("images of two sizes");
  ImageDifference d;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const int off = std::abs(a.pixels[i] - b.pixels[i]);
    d.mean += off;
    d.beyond_4 += off > 4;
  }
  constexpr int kSide = 8;
  for (int y0 = 0; y0 + kSide <= a.height; y0 += kSide) {
    for (int x0 = 0; x0 + kSide <= a.width; x0 += kSide) {
      int sum = 0;
      for (int k = 0; k < kSide * kSide; ++k) {
        const int at = (y0 + k / kSide) * a.width + x0 + k % kSide;
        sum += a.pixels[at] - b.pixels[at];
      }
      d.block = std::max(d.block, std::abs(sum) / double{kSide * kSide});
    }
  }
  d.mean /= static_cast<double>(a.pixels.size());
  d.beyond_4 /= static_cast<double>(a.pixels.size());
  return d;
}

GrayImage ReadPng(const std::string& path) {
  const cv::Mat read = cv::imread(path, cv::IMREAD_GRAYSCALE);
  if (read.empty()) throw std::runtime_error("cannot read " + path);
  return {
      .width = read.cols,
      .height = read.rows,
      .pixels = std::vector<std::uint8_t>(read.begin<std::uint8_t>(), read.end<std::uint8_t>())};
}

void WritePng(const std::string& path, const GrayImage& image) {
  const cv::Mat view(image.height, image.width, CV_8UC1,
                     const_cast<std::uint8_t*>(image.pixels.data()));
  if (!cv::imwrite(path, view)) throw std::runtime_error("cannot write " + path);
}

}  // namespace dockyard
