#include "sim/axel/axel_columns.h"

namespace dockyard::axel {

std::vector<Column> Beliefs() {
  return {
      {"recoveries", "", "times that the controller backed up to try again"},
      {"rightings", "", "times that the controller turned body and arm back"},
      {"tether_length_m", "m", "exposed tether, arm tip to anchor, by the controller's estimate"}};
}

}  // namespace dockyard::axel
