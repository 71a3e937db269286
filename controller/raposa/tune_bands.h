// Bands of hue, saturation and value from one picture of the pyramid: what the user of Ferreira and
// Ventura's robot did by hand when the light had changed (F, C.3).
#pragma once

#include <optional>

#include "controller/raposa/marks.h"

namespace dockyard::raposa {

struct TunedBands {
  HsvBand orange, blue;
  MarkPair pair;        // that they were measured on
  double misfit = 0.0;  // of the pair
};

/// The band of the colours of a region: from the 5th to the 95th hundredth of hue, saturation and
/// value, widened by the margins of FerreiraTuning. Pixels of no colour (grey, or dark) are left
/// out; none if few are left.
std::optional<HsvBand> BandOf(const ColourSearch& image, const BlobBounds& region,
                              const HsvBand& within, const FerreiraTuning& tuning);

/// The band with another least saturation. Its region then ends where the colours are halfway
/// between mark and surroundings, as nearly as whole pixels allow on all four sides. The user of
/// the paper's robot tunes by hand (F, C.3). The band as it is where the image has no such edges.
HsvBand AtHalfLevel(const RgbImage& image, const ColourSearch& search, const BlobBounds& region,
                    const HsvBand& band);

/// The pair that fits the pyramid best over a grid of candidate bands about orange and blue, then
/// the bands of its two marks, each AtHalfLevel. Geometry finds the colours, so the image should
/// show the pyramid, both marks whole, at a moderate distance: 0.5 to 1.5 m, 20 to 60 deg from its
/// axis. None when no candidate gives a possible pair, by the tight limits.
std::optional<TunedBands> TuneBands(const RgbImage& image, const Nominal& nominal,
                                    const FerreiraTuning& tuning = {});

}  // namespace dockyard::raposa
