#include "controller/raposa/guide_track.h"

namespace dockyard::raposa {

void Carry(double turned_rad, double driven_m, GuideTrack* guide) {
  guide->bearing_rad -= turned_rad;
  guide->driven_m += driven_m;
}

void Take(const PyramidSeen& image, Tick now, GuideTrack* guide) {
  guide->now = image.guide;
  if (image.guide) {
    guide->last = image.guide;
    guide->detected = now;
    guide->bearing_rad = image.guide->bearing_rad;
    guide->driven_m = 0.0;
  }
  if (!image.fits.empty()) {
    guide->fitless = 0;
    guide->sides = 0.0;
    return;
  }
  ++guide->fitless;
  if (image.guide) guide->sides += image.guide->likely_side;
}

bool MayBeAhead(const GuideTrack& guide, const DockyardOptions& options) {
  const bool far = !guide.last || guide.last->range_m > options.far_m;
  return far && guide.driven_m < options.unseen_way_m;
}

}  // namespace dockyard::raposa
