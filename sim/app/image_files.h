// Reads images from files.
#pragma once

#include <string>
#include <vector>

#include "controller/geometry/image.h"

namespace dockyard {

/// PNG, JPEG, PGM, PPM or WebP, as 8-bit grey (sim/images/decode.h). Throws ConfigError, before it
/// decodes anything when the image has more than kMaxImagePixels.
GrayImage LoadGray(const std::string& file);
/// The image turned by 180 deg.
GrayImage UpsideDown(const GrayImage& image);
/// Whether a JPEG ends before its end mark; the decoder fills the rest with grey.
bool IsCutJpeg(const std::string& file);
/// The folder's image files by name, at least one. Throws ConfigError.
std::vector<std::string> ImageFilesIn(const std::string& folder);

}  // namespace dockyard
