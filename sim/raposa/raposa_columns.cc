#include "sim/raposa/raposa_columns.h"

namespace dockyard::raposa {

std::vector<Column> Beliefs() {
  return {{"state", "", "number of the state; of ferreira2009 as its authors count them"},
          {"alpha_deg", "deg", "the camera's place about the pyramid's axis, as believed"},
          {"r_m", "m", "camera to guide, as believed"},
          {"passes", "", "times that it manoeuvred to the pyramid's axis"},
          {"gauge_share", "", "turns by the told gauge that come about, as believed"}};
}

}  // namespace dockyard::raposa
