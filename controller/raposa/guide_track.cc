#include "controller/raposa/guide_track.h"

#include <algorithm>
#include <cmath>

namespace dockyard::raposa {
namespace {

// One guide in two images: its bearing as the belts carry it, and its range. Assumed, 0.03-0.1 rad
// and 1.2-1.6.
constexpr double kSameBearing_rad = 0.05, kSameRange = 1.4;

bool IsSame(const GuideTrack& guide, const GuideSighting& image) {
  return std::abs(WrapPi(image.bearing_rad - guide.bearing_rad)) < kSameBearing_rad &&
         image.range_m < kSameRange * guide.last->range_m &&
         kSameRange * image.range_m > guide.last->range_m;
}

}  // namespace

void Carry(double turned_rad, double driven_m, GuideTrack* guide) {
  guide->bearing_rad -= turned_rad;
  guide->driven_m += driven_m;
}

void Take(const PyramidSighting& image, Tick now, GuideTrack* guide) {
  guide->now = image.guide;
  const bool another = image.guide && guide->last && !IsSame(*guide, *image.guide);
  if (!image.guide || another || !image.fits.empty()) guide->without_square.fill(0);
  if (image.guide) {
    guide->last = image.guide;
    guide->detected = now;
    guide->bearing_rad = image.guide->bearing_rad;
    guide->driven_m = 0.0;
    for (std::size_t i = 0; i < guide->without_square.size(); ++i) {
      guide->without_square[i] += image.guide->without_square[i];
    }
  }
  if (!image.fits.empty()) {
    guide->fitless = 0;
    guide->sides = 0.0;
    return;
  }
  ++guide->fitless;
  if (image.guide) guide->sides += image.guide->likely_side;
}

bool HasNoSquare(const GuideTrack& guide, int images) {
  return std::ranges::min(guide.without_square) >= images;
}

GuideTrack AfterRefuting(const GuideTrack& guide, const DockyardOptions& options) {
  GuideTrack nothing;
  nothing.detected = guide.detected;
  nothing.driven_m = options.unseen_way_m;
  return nothing;
}

bool MayBeAhead(const GuideTrack& guide, const DockyardOptions& options) {
  const bool far = !guide.last || guide.last->range_m > options.far_m;
  return far && guide.driven_m < options.unseen_way_m;
}

}  // namespace dockyard::raposa
