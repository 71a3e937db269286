// Options of sbatch that a user adds to those of the scripts.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace dockyard {

/// Something that cannot be written into a job's script. The message is a sentence.
class SlurmError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws SlurmError unless each is one whole option of sbatch, such as --account=rover, that the
/// scripts leave to the user. They set some themselves, --array among them; others have an option
/// of `dockyard submit`.
void CheckFurtherOptions(const std::vector<std::string>& options);

}  // namespace dockyard
