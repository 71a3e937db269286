// What a program says that it believes, over its run.
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "controller/io/belief.h"
#include "sim/base/json.h"
#include "sim/bridge/sighting_json.h"

namespace dockyard {

/// Sightings of one run, at most: each takes 1 kB of memory and of files. Assumed,
/// 20 000-500 000.
inline constexpr int kMostSightings = 100'000;
/// Marks of one run, at most: each takes 100 bytes. Assumed, 200 000-5 000 000.
inline constexpr std::size_t kMostMarksOfRun = 1'000'000;

class ProgramBelief {
 public:
  explicit ProgramBelief(int camera_count) : camera_count_(camera_count) {
    belief_.phase = "external";
  }

  /// One message. A field that is there replaces the earlier one. Throws AnswerError.
  void Take(const Json& json);
  /// After the last message of an answer: its marks and its pose are one sighting. Throws
  /// AnswerError for too many in a run.
  void EndAnswer();

  const Belief& belief() const { return belief_; }

 private:
  int camera_count_;
  Belief belief_;
  SightingParts sighting_;             // of this answer
  std::set<std::string> value_names_;  // of the run so far
  std::size_t marks_ = 0;              // of the run so far
};

}  // namespace dockyard
