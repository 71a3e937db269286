// How well disparities agree with the truth, in bands of distance ahead of the cameras.
#pragma once

#include <array>
#include <vector>

#include "stereo/rendered_yard.h"

namespace dockyard {

inline constexpr std::array<double, 5> kBands_m{0.1, 0.3, 0.6, 1.0, 1.5};
inline constexpr int kBandCount = 4;

/// Ground so near to a rock's pixels, or to ground that one camera alone sees, counts apart: blocks
/// reach over the edge.
inline constexpr int kBeside_px = 8;

/// Of the ground's pixels, or of the rocks'. Sigmas and bias: of those that are off by a pixel at
/// most.
struct BandScore {
  double seen = 0, both = 0, matched = 0, matched_both = 0, off = 0;
  double px = 0, px2 = 0, up = 0, up2 = 0;  // sums of errors

  double Density() const { return matched / seen; }
  double DensityOfBoth() const { return matched_both / both; }
  double Off() const { return off / matched; }
  double SigmaPx() const { return Sigma(px, px2); }
  double SigmaUp() const { return Sigma(up, up2); }
  double BiasUp() const { return up / (matched - off); }
  void Add(const BandScore& other);

 private:
  double Sigma(double sum, double squares) const;
};

struct YardScore {
  std::array<BandScore, kBandCount> ground, beside, rocks;
  void Add(const YardScore& other);
};

/// The disparities are of a rectifier that may believe another rig than the true one; the truth has
/// the same size.
YardScore ScoreOf(const Disparities& found, const YardTruth& truth, const Rectifier& rectifier);

/// One line a band.
void PrintScore(const char* name, const YardScore& score, double ms);

}  // namespace dockyard
