#include "controller/vision/board/hypotheses.h"

#include <algorithm>

namespace dockyard {
namespace {

/// Ways to name the detections of one rotation: every one-to-one map of the fewer onto the more.
std::vector<std::vector<MarkMatch>> Namings(const std::vector<int>& detections,
                                            const std::vector<int>& ids) {
  std::vector<std::vector<MarkMatch>> namings{{}};
  const bool few = detections.size() <= ids.size();
  const std::vector<int>& outer = few ? detections : ids;
  const std::vector<int>& inner = few ? ids : detections;
  for (const int o : outer) {
    std::vector<std::vector<MarkMatch>> longer;
    for (const std::vector<MarkMatch>& naming : namings) {
      for (const int i : inner) {
        const MarkMatch match = few ? MarkMatch{i, o} : MarkMatch{o, i};
        const bool taken = std::any_of(naming.begin(), naming.end(), [&](const MarkMatch& m) {
          return m.id == match.id || m.detection == match.detection;
        });
        if (taken) continue;
        longer.push_back(naming);
        longer.back().push_back(match);
      }
    }
    namings = longer;
  }
  return namings;
}

}  // namespace

std::vector<std::vector<MarkMatch>> NamingHypotheses(const std::vector<DetectedFiducial>& all,
                                                     const FiducialBoard& board,
                                                     std::size_t max_of_one_class) {
  std::vector<std::vector<MarkMatch>> hypotheses{{}};
  for (int c = 0; c < 4; ++c) {
    std::vector<int> detections, ids;
    for (std::size_t i = 0; i < all.size(); ++i) {
      // Detections come best match first, so the doubtful ones are left out.
      if (all[i].rotation_class == c && detections.size() < max_of_one_class) {
        detections.push_back(static_cast<int>(i));
      }
    }
    for (std::size_t i = 0; i < board.fiducials.size(); ++i) {
      if (RotationClass(board.fiducials[i].rotation) == c) ids.push_back(static_cast<int>(i));
    }
    std::vector<std::vector<MarkMatch>> longer;
    for (const auto& hypothesis : hypotheses) {
      for (const auto& naming : Namings(detections, ids)) {
        longer.push_back(hypothesis);
        longer.back().insert(longer.back().end(), naming.begin(), naming.end());
      }
    }
    hypotheses = longer;
  }
  return hypotheses;
}

}  // namespace dockyard
