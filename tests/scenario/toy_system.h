// A system for these tests alone: a point that drives to a flag.
#pragma once

#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "support/bad_files.h"

namespace dockyard {

/// "toy" with controllers "straight" and "wave", whose own key toy.flag names a file; and "other".
std::vector<KnownSystem> ToySystems();

/// A folder with a scenario of the toy, scenarios/toy.yaml, and the files that it names.
class ToyFolder : public ScratchFolder {
 public:
  ToyFolder();
  /// The scenario with one place of it changed, or lines after its end, in a file of its own.
  std::string With(const std::string& from, const std::string& to) const;
  std::string And(const std::string& lines) const;
  /// The message of the error when the file is loaded.
  std::string ScenarioMessage(const std::string& file) const;

  const std::string scenario_text;
  std::string scenario;  // its path
};

}  // namespace dockyard
