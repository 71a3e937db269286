// Names the outcome of a run from the truth alone. A judge is made on its own system's plant.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "controller/io/belief.h"
#include "controller/io/commands.h"
#include "sim/log/judged_limit.h"

namespace dockyard {

struct Conclusion {
  std::string outcome;                   // one of the system's
  std::string note;                      // a sentence on the truth
  std::vector<double> measures;          // by StatedColumns::measures, without margins
  std::vector<JudgedLimit> limits = {};  // in the order of their margins
};

/// Called every control period while a judge steps the plant to try a claim. phase: what it does.
using TrialWatch = std::function<void(const char* phase)>;

class Judge {
 public:
  virtual ~Judge() = default;
  /// Called every control period, before the commands take effect.
  virtual void Observe() = 0;
  /// Called for every sighting that the controller reports, after Observe.
  virtual void ObserveSighting(const SightingReport& report) = 0;
  /// Called every control period with what the controller believes, after ObserveSighting.
  /// Neither is called for a controller that is a program.
  virtual void ObserveBelief(const Belief&) {}
  /// Called when pictures that the controller asked for are lost.
  virtual void ObserveLostImages() {}
  /// Whether the run cannot go on.
  virtual bool fatal() const = 0;
  /// Called once, at the end. May step the plant further, to test a claim.
  virtual Conclusion Conclude(const Commands& last, const Belief& belief,
                              const TrialWatch& watch) = 0;
};

}  // namespace dockyard
