// Why a controller cannot be made for a robot and a dock.
#pragma once

#include <string>

namespace dockyard::custom {

struct Refusal {
  std::string reason;  // one sentence: which part, and what is expected
};

}  // namespace dockyard::custom
