// A file of another kind than a command takes, such as a robot's where a campaign's is expected.
#pragma once

#include <string>
#include <vector>

#include "sim/run/system.h"
#include "sim/scenario/other_file_kind.h"

namespace dockyard {

/// The kind of file that a command takes.
struct WantedFile {
  std::string kind;               // as CheckFile names it
  std::vector<std::string> keys;  // a file with one of them is of this kind, however faulty
  std::string made_of;            // what it holds and where to read on, for people
};
extern const WantedFile kWantedScenario, kWantedCampaign;

/// For a file that could not be read: throws ConfigError where it is a good one of another kind.
void RefuseMisplaced(const std::string& file, const WantedFile& wanted,
                     const std::vector<System>& systems);

/// What `load` returns. Throws ConfigError: for a file of another kind that says so, else load's.
template <class Load>
auto LoadAs(const WantedFile& wanted, const std::string& file, const std::vector<System>& systems,
            const Load& load) {
  try {
    return load();
  } catch (const OtherFileKind&) {
    throw;
  } catch (const ConfigError&) {
    RefuseMisplaced(file, wanted, systems);
    throw;
  }
}

}  // namespace dockyard
