// Options of sbatch that a user adds to those of the scripts.
#pragma once

#include <string>
#include <vector>

namespace dockyard {

/// Throws SlurmError unless each is one whole option of sbatch, such as --account=rover, that the
/// scripts leave to the user. They set some themselves, --array among them; others have an option
/// of `dockyard submit`.
void CheckFurtherOptions(const std::vector<std::string>& options);

}  // namespace dockyard
