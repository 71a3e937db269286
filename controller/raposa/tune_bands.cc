#include "controller/raposa/tune_bands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "controller/base/median.h"
#include "controller/raposa/half_level.h"

namespace dockyard::raposa {
namespace {

/// Windows of hue that overlap by half, from the first to the last middle.
std::vector<HsvBand> Candidates(int first_hue, int last_hue, const FerreiraTuning& tuning) {
  std::vector<HsvBand> bands;
  const int half = tuning.window_hue / 2;
  for (int hue = first_hue; hue <= last_hue; hue += half) {
    for (const int saturation : tuning.least_saturations) {
      for (const int value : tuning.least_values) {
        bands.push_back({.hue_from = static_cast<std::uint8_t>((hue - half + 180) % 180),
                         .hue_to = static_cast<std::uint8_t>((hue + half) % 180),
                         .saturation_from = static_cast<std::uint8_t>(saturation),
                         .value_from = static_cast<std::uint8_t>(value)});
      }
    }
  }
  return bands;
}

struct BandRange {
  int from = 0, to = 0;
};

BandRange Middle(std::vector<int> values, double outside_share) {
  std::ranges::sort(values);
  const auto skip = static_cast<std::size_t>(outside_share * static_cast<double>(values.size()));
  return {values[skip], values[values.size() - 1 - skip]};
}

// Between which the least saturation of a mark is searched. Assumed, 15-30 and 200-250.
constexpr int kLeastSaturation = 20, kMostSaturation = 220;

double SquaredOff(const BlobBounds& a, const BlobBounds& b) {
  return std::pow(a.left_px - b.left_px, 2) + std::pow(a.right_px - b.right_px, 2) +
         std::pow(a.top_px - b.top_px, 2) + std::pow(a.bottom_px - b.bottom_px, 2);
}

}  // namespace

std::optional<HsvBand> BandOf(const ColourSearch& image, const BlobBounds& region,
                              const HsvBand& within, const FerreiraTuning& tuning) {
  std::vector<int> hues, saturations, values;  // hues from the lower end of `within` on
  const int x1 = std::min(image.width() - 1, static_cast<int>(std::floor(region.right_px)));
  const int y1 = std::min(image.height() - 1, static_cast<int>(std::floor(region.bottom_px)));
  for (int y = std::max(0, static_cast<int>(std::ceil(region.top_px))); y <= y1; ++y) {
    for (int x = std::max(0, static_cast<int>(std::ceil(region.left_px))); x <= x1; ++x) {
      const Hsv& colour = image.At(x, y);
      if (!Within(colour, within)) continue;
      hues.push_back((colour.hue - within.hue_from + 180) % 180);
      saturations.push_back(colour.saturation);
      values.push_back(colour.value);
    }
  }
  if (static_cast<double>(hues.size()) < tuning.least_pixels) return std::nullopt;
  const BandRange hue = Middle(hues, tuning.outside_share);
  const BandRange saturation = Middle(saturations, tuning.outside_share);
  const BandRange value = Middle(values, tuning.outside_share);
  const auto turned = [&](int at) {
    return static_cast<std::uint8_t>((at + within.hue_from + 180) % 180);
  };
  return HsvBand{.hue_from = turned(hue.from - tuning.hue_margin),
                 .hue_to = turned(hue.to + tuning.hue_margin),
                 .saturation_from = static_cast<std::uint8_t>(
                     std::max(0.0, tuning.saturation_share * saturation.from)),
                 .saturation_to = 255,
                 .value_from = static_cast<std::uint8_t>(tuning.value_share * value.from),
                 .value_to = 255};
}

HsvBand AtHalfLevel(const RgbImage& image, const ColourSearch& search, const BlobBounds& region,
                    const HsvBand& band) {
  const auto edges = HalfLevelBounds(image, region);
  if (!edges) return band;
  HsvBand tried = band;
  double least = std::numeric_limits<double>::infinity();
  std::vector<int> best;  // saturations whose regions are equally near
  for (int saturation = kLeastSaturation; saturation <= kMostSaturation; ++saturation) {
    tried.saturation_from = static_cast<std::uint8_t>(saturation);
    double off = std::numeric_limits<double>::infinity();
    for (const ColourBlob& blob : search.Blobs(tried, 1.0)) {
      off = std::min(off, SquaredOff(blob.bounds, *edges));
    }
    if (off < least) best.clear();
    if (off <= least) best.push_back(saturation);
    least = std::min(least, off);
  }
  if (std::isinf(least)) return band;
  tried.saturation_from = static_cast<std::uint8_t>(Median(std::move(best)));
  return tried;
}

std::optional<TunedBands> TuneBands(const RgbImage& image, const Nominal& nominal,
                                    const FerreiraTuning& tuning) {
  const ColourSearch search(image);
  FerreiraVision vision = nominal.ferreira_vision;
  struct Marked {
    OrangeMark mark;
    HsvBand band;
  };
  std::vector<Marked> oranges;
  for (const HsvBand& band : Candidates(tuning.orange_from, tuning.orange_to, tuning)) {
    vision.orange = band;
    for (const OrangeMark& mark : OrangeMarks(search, nominal, vision)) {
      oranges.push_back({mark, band});
    }
  }
  std::optional<TunedBands> best;
  for (const HsvBand& band : Candidates(tuning.blue_from, tuning.blue_to, tuning)) {
    vision.blue = band;
    for (const BlobBounds& blue : BlueMarks(search, vision)) {
      for (const Marked& orange : oranges) {
        const MarkPair pair = PairOf(orange.mark, blue, nominal);
        if (!Possible(pair, nominal, TightLimits(vision))) continue;
        const double misfit = Misfit(pair, nominal);
        if (best && misfit >= best->misfit) continue;
        best = TunedBands{orange.band, band, pair, misfit};
      }
    }
  }
  if (!best) return std::nullopt;
  const Ellipse& guide = best->pair.orange.ellipse;
  const Eigen::Vector2d reach(guide.shape_px.row(0).norm(), guide.shape_px.row(1).norm());
  const BlobBounds about{.left_px = guide.centre_px.x() - reach.x(),
                         .top_px = guide.centre_px.y() - reach.y(),
                         .right_px = guide.centre_px.x() + reach.x(),
                         .bottom_px = guide.centre_px.y() + reach.y()};
  const auto orange = BandOf(search, about, best->orange, tuning);
  const auto blue = BandOf(search, best->pair.blue, best->blue, tuning);
  if (!orange || !blue) return std::nullopt;
  best->orange = AtHalfLevel(image, search, about, *orange);
  best->blue = AtHalfLevel(image, search, best->pair.blue, *blue);
  return best;
}

}  // namespace dockyard::raposa
