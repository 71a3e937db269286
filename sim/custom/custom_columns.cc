#include "sim/custom/custom_columns.h"

#include "sim/custom/outcome.h"

namespace dockyard::custom {

std::vector<Column> Measures() {
  return WithMargins(MeasuresOf<CustomMeasures>(), LimitsOf({}, {}));
}

std::vector<Column> Beliefs() {
  return {{"retries", "", "new approaches so far"},
          {"dock_sigma_x_m", "m", "1 sigma of the dock's place along its axis, as believed"},
          {"dock_sigma_y_m", "m", "the same across"},
          {"dock_sigma_yaw_deg", "deg", "1 sigma of its heading, as believed"},
          {"tag_branches_open", "", "1 while both poses of a board explain the sightings"},
          {"contact_voltage_v", "V", "of the contact, as sensed"},
          {"contact_closed", "", "1 while the contact counts as closed"}};
}

}  // namespace dockyard::custom
