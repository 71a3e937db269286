// How the uniform numbers of a campaign's runs are made: the design of the experiment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/base/random.h"
#include "sim/draws/permutation.h"
#include "sim/draws/sobol.h"

namespace dockyard {

enum class DesignKind {
  kMonteCarlo,      // independent numbers
  kLatinHypercube,  // each of `repeats` equal strata once for each key (McKay et al. 1979)
  kSobol,           // points of Sobol' with a random digital shift for each key
};

/// The most repeats of a place that a Latin hypercube or Sobol' points can have.
inline constexpr std::uint64_t kMostRepeats = kLongestPermutation;

/// One uniform number for each key of each run, as a pure function of the run: any worker draws any
/// run in any order. Numbers of different places are independent, so that an interval can be had
/// from places that repeat the same design.
class Design {
 public:
  /// @param repeats  runs at each place, 1 .. kMostRepeats, fixed in advance: another number gives
  ///   other draws of a Latin hypercube, and leaves the points of Sobol' less even unless it is a
  ///   power of 2. Monte Carlo does not use it.
  /// @param keys  names such as "start.r_m", each once. A key's random bits come from its name:
  ///   with Monte Carlo and Latin hypercube it has the same draws whatever the other keys are. With
  ///   Sobol' its place in the list is its dimension, so only keys at the end may come and go;
  ///   there are kSobolDimensions at most.
  Design(DesignKind kind, std::uint64_t repeats, const Seed& campaign,
         const std::vector<std::string>& keys);

  /// The number in (0, 1) of one key, counted from 0 in the list.
  /// @param place   point of the campaign's grid or row of its table, counted from 0
  /// @param repeat  counts the runs at the place from 0; below `repeats` except with Monte Carlo
  double Uniform(std::size_t key, std::uint64_t place, std::uint64_t repeat) const;

 private:
  /// Names of a key's streams: of each run, and of all runs at a place.
  struct Streams {
    std::string run, place;
  };

  DesignKind kind_;
  std::uint64_t repeats_;
  Seed campaign_;
  std::vector<Streams> streams_;
  SobolPoints sobol_;
};

}  // namespace dockyard
