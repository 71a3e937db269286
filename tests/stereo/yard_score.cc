#include "stereo/yard_score.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace dockyard {

void BandScore::Add(const BandScore& o) {
  seen += o.seen, both += o.both, matched += o.matched, matched_both += o.matched_both;
  off += o.off, px += o.px, px2 += o.px2, up += o.up, up2 += o.up2;
}

double BandScore::Sigma(double sum, double squares) const {
  const double count = matched - off, mean = sum / count;
  return std::sqrt(std::max(0.0, squares / count - mean * mean));
}

void YardScore::Add(const YardScore& other) {
  for (int i = 0; i < kBandCount; ++i) {
    ground[static_cast<std::size_t>(i)].Add(other.ground[static_cast<std::size_t>(i)]);
    beside[static_cast<std::size_t>(i)].Add(other.beside[static_cast<std::size_t>(i)]);
    rocks[static_cast<std::size_t>(i)].Add(other.rocks[static_cast<std::size_t>(i)]);
  }
}

namespace {

// Pixels with a rock within kBeside_px along rows and columns.
std::vector<bool> BesideRocks(const YardTruth& truth) {
  std::vector<bool> beside(truth.pixels.size(), false);
  for (int v = 0; v < truth.height; ++v) {
    for (int u = 0; u < truth.width; ++u) {
      const auto at = static_cast<std::size_t>(v * truth.width + u);
      if (truth.pixels[at].rock < 0) continue;
      for (int y = std::max(0, v - kBeside_px); y <= std::min(truth.height - 1, v + kBeside_px);
           ++y) {
        for (int x = std::max(0, u - kBeside_px); x <= std::min(truth.width - 1, u + kBeside_px);
             ++x) {
          beside[static_cast<std::size_t>(y * truth.width + x)] = true;
        }
      }
    }
  }
  return beside;
}

}  // namespace

YardScore ScoreOf(const Disparities& found, const YardTruth& truth, const Rectifier& rectifier) {
  const RectifiedPair& pair = rectifier.pair();
  const std::vector<bool> beside = BesideRocks(truth);
  YardScore score;
  std::size_t place = 0;
  for (int v = 0; v < truth.height; ++v) {
    for (int u = 0; u < truth.width; ++u, ++place) {
      const YardTruth::Pixel& pixel = truth.pixels[place];
      if (pixel.disparity_px <= 0.0F) continue;
      const double want_px = static_cast<double>(pixel.disparity_px);
      const Eigen::Vector3d p_R = pair.X_RC * pair.Point(u, v, want_px);
      const double ahead_m = p_R.x() - pair.X_RC.p.x();
      std::size_t band = 0;
      while (band < kBandCount && ahead_m >= kBands_m[band + 1]) ++band;
      if (band == kBandCount || ahead_m < kBands_m[0]) continue;
      BandScore& to = pixel.rock >= 0 ? score.rocks[band]
                      : beside[place] ? score.beside[band]
                                      : score.ground[band];
      ++to.seen;
      to.both += pixel.both;
      const double got_px = static_cast<double>(found.px[place]);
      if (!(got_px > 0.0)) continue;
      ++to.matched;
      to.matched_both += pixel.both;
      const double error_px = got_px - want_px;
      if (std::abs(error_px) > 1.0) {
        ++to.off;
        continue;
      }
      const double up_m = (pair.X_RC * pair.Point(u, v, got_px)).z() - p_R.z();
      to.px += error_px;
      to.px2 += error_px * error_px;
      to.up += up_m;
      to.up2 += up_m * up_m;
    }
  }
  return score;
}

void PrintScore(const char* name, const YardScore& score, double ms) {
  std::printf("%s, %.0f ms\n", name, ms);
  const auto row = [&](const char* what, const auto& bands, auto value, const char* format) {
    std::printf("  %-30s", what);
    for (const BandScore& band : bands) std::printf(format, value(band));
    std::printf("\n");
  };
  const auto both = [&](const char* whose, const auto& bands) {
    std::printf(" %s\n", whose);
    row(
        "density", bands, [](const BandScore& b) { return b.Density(); }, " %7.3f");
    row(
        "of what both cameras see", bands, [](const BandScore& b) { return b.DensityOfBoth(); },
        " %7.3f");
    row(
        "off by > 1 px, %", bands, [](const BandScore& b) { return 100.0 * b.Off(); }, " %7.2f");
    row(
        "sigma, px", bands, [](const BandScore& b) { return b.SigmaPx(); }, " %7.3f");
    row(
        "sigma up, mm", bands, [](const BandScore& b) { return 1e3 * b.SigmaUp(); }, " %7.2f");
    row(
        "bias up, mm", bands, [](const BandScore& b) { return 1e3 * b.BiasUp(); }, " %7.2f");
  };
  both("ground", score.ground);
  both("ground beside rocks", score.beside);
  both("rocks", score.rocks);
}

}  // namespace dockyard
