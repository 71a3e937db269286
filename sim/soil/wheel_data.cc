#include "sim/soil/wheel_data.h"

#include <algorithm>
#include <cmath>

#include "models/read/config_error.h"
#include "models/read/csv_table.h"
#include "models/read/yaml_reader.h"
#include "sim/base/text.h"

namespace dockyard {

std::vector<MeasuredRow> LoadMeasuredRows(const std::string& file, const std::string& wheel) {
  const YamlNode table = LoadCsv(file);
  std::vector<MeasuredRow> rows;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < table.items.size(); ++i) {
    const YamlReader in(table.items[i], "row " + std::to_string(i + 1),
                        {"wheel", "beta_deg", "slip", "Fx_N", "Fy_N", "Fz_N", "sinkage_mm",
                         "torque_Nm", "v_mm_s", "rim_mm_s"});
    MeasuredRow row;
    row.beta_deg = in.NumberOr("beta_deg", 0.0, Between(0.0, 90.0));
    row.slip = in.Number("slip", Between(-1.0, 1.0));
    row.ahead_n = in.Number("Fx_N", Between(-1e6, 1e6));
    row.load_n = in.Number("Fz_N", Between(0.1, 1e6));
    row.sinkage_m = 1e-3 * in.NumberOr("sinkage_mm", std::nan(""), Between(-1e3, 1e4));
    row.torque_nm = in.NumberOr("torque_Nm", std::nan(""), Between(-1e6, 1e6));
    for (const char* unused : {"Fy_N", "v_mm_s", "rim_mm_s"}) {
      in.NumberOr(unused, 0.0, Between(-1e6, 1e6));
    }
    const std::string name = in.TextOr("wheel", "");
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    if (wheel.empty() || name == wheel) rows.push_back(row);
  }
  if (rows.empty()) {
    const std::string found = names.empty() ? "no rows" : Listed(names);
    throw ConfigError(file + ": wheel: expected rows" +
                      (wheel.empty() ? std::string() : " of '" + wheel + "'") + ", found " + found);
  }
  if (wheel.empty() && names.size() > 1) {
    throw ConfigError(file + ": wheel: expected one wheel, or its name by --data-wheel, found " +
                      Listed(names));
  }
  return rows;
}

}  // namespace dockyard
