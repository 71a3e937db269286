// Obstacles in plan, and areas, from YAML and CSV.
#pragma once

#include <string>

#include "controller/geometry/plan_shapes.h"
#include "models/read/keys.h"

namespace dockyard {

/// x_m and y_m of the mapping [m].
Eigen::Vector2d ReadPlace(const YamlReader& in);

/// Names them.
void VisitPlace(Keys& keys, Eigen::Vector2d& p);

/// The list of {x_m, y_m} under a key: 3 to 100 corners round an area.
Polygon ReadPolygon(const YamlReader& in, std::string_view key);

/// A YAML file with a list `obstacles` of discs, {x_m, y_m, radius_m}, and areas, {corners: [...]};
/// or a CSV file with the columns x_m, y_m, radius_m. Up to 100 000 discs (YAML: as many as 4 MiB
/// and 200 000 values hold) and 1000 areas. Throws ConfigError.
Obstacles LoadObstacles(const std::string& file);

/// Whether a CSV file has the columns of discs, in any case of letters (LoadObstacles says what is
/// wrong with it), and at least one row. Throws ConfigError.
bool IsDiscTable(const std::string& file);

}  // namespace dockyard
