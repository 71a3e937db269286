// What `dockyard submit` prints.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/app/invocation.h"
#include "sim/app/slurm_client.h"

namespace dockyard {

/// The jobs and what can be done next; the scripts where nothing was submitted.
/// @param program  as it was called, for the commands to be pasted
void PrintSubmitText(const SlurmJob& job, const SlurmScripts& scripts,
                     const std::optional<SubmittedJobs>& jobs, const std::string& program);

/// The jobs' limits and scripts as JSON. Their numbers and what can be done next are null where
/// nothing was submitted.
void PrintSubmitJson(const SlurmJob& job, const SlurmScripts& scripts, std::int64_t runs,
                     const std::optional<SubmittedJobs>& jobs, const Invocation& call);

}  // namespace dockyard
