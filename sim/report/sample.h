// Whether a campaign's runs are a sample of one population: only then has their share of successes
// an interval, and a reliability a verdict.
#pragma once

#include <string>
#include <vector>

#include "sim/plan/campaign.h"
#include "sim/report/points.h"

namespace dockyard {

/// Why the runs of one arm are no sample of one population; empty if they are. Points of a grid,
/// rows of a table and values set alone are not drawn alike.
std::string WhyNoSample(const Campaign& campaign);

/// Why runs with the same settings are no sample either; empty if they are. Runs of a stratified
/// design depend on each other, so their count of failures is not binomial.
std::string WhyDependent(const Campaign& campaign);

/// The labels by which the campaign sets its runs apart: arm, columns of a table that are keys,
/// keys of the grid, the key changed alone. Neither draws, tags, points nor repeats.
std::vector<std::string> SettingLabels(const Campaign& campaign);

/// Those in which the rows differ.
std::vector<std::string> DifferingLabels(const std::vector<std::string>& labels,
                                         const RowColumns& columns, const Rows& rows);

}  // namespace dockyard
