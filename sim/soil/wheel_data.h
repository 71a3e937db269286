// Measured rows that `dockyard wheel` draws over its curves.
#pragma once

#include <string>
#include <vector>

namespace dockyard {

/// NaN: not measured.
struct MeasuredRow {
  double beta_deg = 0.0, slip = 0.0;
  double ahead_n = 0.0, load_n = 0.0, sinkage_m = 0.0, torque_nm = 0.0;
};

/// Rows of a CSV table with the columns slip, Fx_N, Fz_N and, if given, wheel, beta_deg (0 where it
/// is not), sinkage_mm, torque_Nm, Fy_N, v_mm_s and rim_mm_s; only those of this wheel, unless its
/// name is empty. Throws ConfigError for a bad row, when no row is of this wheel, and when it must
/// be named because there are several.
std::vector<MeasuredRow> LoadMeasuredRows(const std::string& file, const std::string& wheel);

}  // namespace dockyard
