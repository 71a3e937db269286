// From a sighting to the estimate: accepts, doubts or rejects the measurement.
#pragma once

#include <optional>
#include <string>

#include "controller/axel/axel.h"
#include "controller/axel/senses.h"
#include "controller/io/belief.h"

namespace dockyard::axel {

/// Checks sightings against dead reckoning. When one contradicts it, another is asked for. Once two
/// in a row agree with each other, they are accepted and dead reckoning is dropped.
class SightingJudge {
 public:
  enum class Ruling { kAccepted, kLookAgain, kRejected };

  SightingJudge(const LookOptions& options, const Pose3& X_DB) : options_(options), X_DB_(X_DB) {}

  Ruling Judge(const DockSighting& sighting, Senses* senses);
  /// Of a sighting from under way, carried to now: one that contradicts dead reckoning is dropped,
  /// as the next stop will tell. Returns whether it was taken.
  bool JudgeUnderWay(const DockSighting& sighting, Senses* senses);
  const std::string& why() const { return why_; }
  /// A new stop: its doubted sightings are counted from zero.
  void NewStop() { doubts_here_ = 0; }

 private:
  /// The sighting in the plane, with what it teaches of the ground; none where it cannot be.
  std::optional<BoardFix> FixOf(const DockSighting& sighting, const Senses& senses,
                                GroundSlope* ground) const;
  void Accept(const BoardFix& fix, const GroundSlope& ground, Senses* senses);
  Ruling Doubt(const BoardFix& fix, Senses* senses);

  LookOptions options_;
  Pose3 X_DB_;
  std::optional<BoardFix> doubted_;
  int doubts_ = 0, doubts_here_ = 0;
  std::string why_;
};

LocateHints HintsFrom(const Senses& senses);

/// Belief about the cameras' relative turn over a run. Each stereo sighting narrows it: its fit
/// begins with the belief so far and gives the next one.
class CameraTurnFilter {
 public:
  const CameraTurn& belief() const { return belief_; }
  /// A sighting that the judge accepted.
  void Take(const DockSighting& sighting);

 private:
  CameraTurn belief_{};
};

/// The belief's newest sighting is none that the estimate took.
void RuleOut(const std::string& why, Belief* belief);

/// Images in, the board out.
struct Perception {
  Locator locator;
  CameraTurnFilter camera_turn{};
  LocateOutput Locate(const StereoImages& images, LocateHints hints) const {
    hints.camera_turn = camera_turn.belief();
    return locator(images, hints);
  }
};

}  // namespace dockyard::axel
