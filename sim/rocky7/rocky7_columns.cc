#include "sim/rocky7/rocky7_columns.h"

namespace dockyard::rocky7 {

std::vector<Column> Beliefs() {
  return {
      {"target_x_m", "m", "the target in the rover's plan, as believed"},
      {"target_y_m", "m", "the same, to the left"},
      {"looks", "", "pairs of pictures so far"},
      {"grasps", "", "times that the arm was sent out so far"},
      {"target_z_m", "m", "the target over the ground, as believed"},
      {"normal_up_deg", "deg", "the face's normal over the horizontal, as believed"},
      {"normal_azimuth_deg", "deg", "the same in the rover's plan, to the left"},
      {"tool_off_deg", "deg", "the tool off the normal if it were placed from here, as believed"},
      {"placements", "", "times that the instrument was sent out so far"}};
}

}  // namespace dockyard::rocky7
