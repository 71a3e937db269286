// Numbers of 16 bits from PNG files.
#pragma once

#include <optional>
#include <string_view>

#include "controller/geometry/image.h"

namespace dockyard {

/// A grey PNG of 8 or 16 bits, the numbers as stored; none for other bytes.
std::optional<DeepImage> DeepFromPng(std::string_view bytes);

}  // namespace dockyard
