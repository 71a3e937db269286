// Reads images from files, and marks the detections in them.
#pragma once

#include <string>
#include <vector>

#include "controller/geometry/image.h"
#include "controller/io/belief.h"

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
/// The images side by side, the marks ringed and numbered: measured green, predicted orange. Throws
/// IoError.
void DrawSighting(const std::string& file, const StereoImages& images,
                  const SightingReport& report);

}  // namespace dockyard
