// The guide, as images showed it and as belts carry it on: what the filter's pose leaves out.
#pragma once

#include <array>
#include <optional>

#include "controller/io/sensors.h"
#include "controller/raposa/dockyard_options.h"
#include "controller/raposa/pyramid_finder.h"

namespace dockyard::raposa {

struct GuideTrack {
  std::optional<GuideSighting> now,
      last;                  // in the last image; the last one detected
  Tick detected = 0;         // then; 0: never
  double bearing_rad = 0.0;  // of the last one, by the belts since
  double driven_m = 0.0;     // since then, either way
  int fitless = 0;           // images in a row without a pose
  // By angle: images of this guide, without a pose, in which its square would be in view and is
  // not.
  std::array<int, Angles().size()> without_square{};
  double sides = 0.0;  // sum of the likely sides in these
};

void Carry(double turned_rad, double driven_m, GuideTrack* guide);
void Take(const PyramidSighting& image, Tick now, GuideTrack* guide);

/// Whether that many images rule out each angle.
bool HasNoSquare(const GuideTrack& guide, int images);

/// Nothing is in view then, and nothing to be expected ahead.
GuideTrack AfterRefuting(const GuideTrack& guide, const DockyardOptions& options);

inline double UnseenFor(const GuideTrack& guide, Tick now) {
  return kTickSeconds * static_cast<double>(now - guide.detected);
}

/// A far guide shows in some images alone: the robot goes on towards it for a while. At the start
/// the guide is ahead, by the mission.
bool MayBeAhead(const GuideTrack& guide, const DockyardOptions& options);

}  // namespace dockyard::raposa
