// What makes two images no pair of their rig, in words.
#pragma once

#include <string>
#include <vector>

#include "controller/stereo/pair_check.h"
#include "sim/base/json.h"

namespace dockyard {

struct PairVerdict {
  PairCheck check;
  std::vector<std::string> warnings;
};

/// most_px: the largest disparity that is tried; 0 where the ground is taken out.
PairVerdict JudgePair(const Rectifier& rectifier, const StereoImages& images, int most_px);

Json ToJson(const PairCheck& check);

}  // namespace dockyard
