// Image files of any allowed format as grey or colour images.
#pragma once

#include <optional>
#include <string_view>

#include "controller/geometry/image.h"

namespace dockyard {

/// The image as 8-bit grey, upright (exif.h); none for bytes that are no whole image of an
/// ImageFormat, or one of more than kMaxImagePixels. A JPEG that ends early is filled with grey.
/// Grey is 0.299 R + 0.587 G + 0.114 B (ITU-R BT.601) of the file's numbers; a JPEG's is its own
/// luminance. Of 16 bits the upper 8 count. Alpha is left out. JPEGs of four inks are refused.
std::optional<GrayImage> DecodeGray(std::string_view bytes);
/// The same as red, green and blue by the file's numbers; a grey file has three equal ones.
std::optional<RgbImage> DecodeColour(std::string_view bytes);

}  // namespace dockyard
