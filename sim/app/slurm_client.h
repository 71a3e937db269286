// Slurm's own commands, as they are on this machine.
#pragma once

#include "sim/campaign/slurm_script.h"

namespace dockyard {

/// The highest number of an array's task. A machine without Slurm: Slurm's default.
int HighestTaskHere();

/// Puts the scripts into the job's folder, hands them to Slurm, and prints what can be done next.
/// Throws IoError, also when there is no Slurm or it refuses; the scripts stay.
/// @param program  as it was called, for the printed command
void Submit(const SlurmJob& job, const SlurmScripts& scripts, const std::string& program);

}  // namespace dockyard
