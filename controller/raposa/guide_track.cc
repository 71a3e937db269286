#include "controller/raposa/guide_track.h"

#include <algorithm>

namespace dockyard::raposa {

void Carry(double turned_rad, double driven_m, GuideTrack* guide) {
  guide->bearing_rad -= turned_rad;
  guide->driven_m += driven_m;
}

void Take(const PyramidSighting& image, Tick now, GuideTrack* guide) {
  guide->now = image.guide;
  if (!image.guide || !image.fits.empty()) guide->without_square.fill(0);
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
