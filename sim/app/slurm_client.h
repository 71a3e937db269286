// Slurm's own commands, as they are on this machine.
#pragma once

#include <string>

#include "sim/campaign/slurm_script.h"

namespace dockyard {

/// The highest number of an array's task. A machine without Slurm: Slurm's default.
int HighestTaskHere();

/// Numbers of the jobs, as sbatch says them: "17", or "17;CLUSTER".
struct SubmittedJobs {
  std::string tasks, merge;
};

/// Puts the scripts into the job's folder and hands them to Slurm. Throws IoError, also when there
/// is no Slurm or it refuses; the scripts stay.
SubmittedJobs Submit(const SlurmJob& job, const SlurmScripts& scripts);

/// The command that hands the scripts to Slurm.
std::string SubmitCommandText(const SlurmJob& job);

}  // namespace dockyard
