// Numbers from TIFF files, as elevation models come.
#pragma once

#include <optional>
#include <string_view>

#include "sim/images/pfm.h"

namespace dockyard {

/// One number a pixel: 8 or 16 bits, with a sign or without, or a float of 32 bits; in strips or
/// tiles. None for other bytes, a file that ends early, or more than kMaxImagePixels.
std::optional<FloatImage> DecodeTiff(std::string_view bytes);

}  // namespace dockyard
