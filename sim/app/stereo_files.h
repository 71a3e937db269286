// The files that `dockyard stereo` writes.
#pragma once

#include <string>

#include "controller/geometry/image.h"
#include "controller/stereo/elevation.h"

namespace dockyard {

/// Disparities by the name's ending: .png, 16 bits of 1/256 px, 0 for none; .pfm, floats, infinity
/// for none. Throws UsageError for another ending.
inline constexpr double kDisparityNumbers = 256.0;  // a px, as in Middlebury's and KITTI's files
enum class DisparityFormat { kPng, kPfm };
DisparityFormat DisparityFormatOf(const std::string& file);

/// Throws ConfigError where a PNG cannot hold a disparity, IoError.
void WriteDisparities(const std::string& file, const Disparities& disparities);

/// A row for each cell with points.
std::string HeightsCsv(const ElevationMap& map);

/// Every pixel with a disparity as a point in the rig's frame, its grey as red, green and blue; the
/// lower byte first. `left`: the rectified image.
std::string PointsPly(const RectifiedPair& pair, const Disparities& disparities,
                      const GrayImage& left);

}  // namespace dockyard
