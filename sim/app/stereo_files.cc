#include "sim/app/stereo_files.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>

#include "models/read/config_error.h"
#include "sim/app/commands.h"
#include "sim/base/files.h"
#include "sim/images/pfm.h"
#include "sim/images/png.h"

namespace dockyard {
namespace {

constexpr double kMostNumber = 65535.0;

DeepImage DeepOf(const std::string& file, const Disparities& disparities) {
  DeepImage image{disparities.width, disparities.height, 16, {}};
  double most_px = 0.0;
  for (const float px : disparities.px) {
    const double number = px > 0.0F ? std::round(kDisparityNumbers * static_cast<double>(px)) : 0.0;
    most_px = std::max(most_px, number / kDisparityNumbers);
    image.pixels.push_back(static_cast<std::uint16_t>(std::min(number, kMostNumber)));
  }
  if (kDisparityNumbers * most_px <= kMostNumber) return image;
  const std::string other = std::filesystem::path(file).replace_extension(".pfm").string();
  char text[200];
  std::snprintf(
      text, sizeof text,
      ": expected disparities up to 255.99 px, which 16 bits of 1/256 px hold, found %.2f "
      "px; write floats instead: --disparity ",
      most_px);
  throw ConfigError(file + text + other);
}

void PutFloat(std::string& bytes, double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(bits >> (8 * i));
}

}  // namespace

DisparityFormat DisparityFormatOf(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".png") return DisparityFormat::kPng;
  if (ending == ".pfm") return DisparityFormat::kPfm;
  throw UsageError("--disparity: expected a file .png or .pfm, found '" + file + "'");
}

void WriteDisparities(const std::string& file, const Disparities& disparities) {
  if (DisparityFormatOf(file) == DisparityFormat::kPfm) {
    WriteWhole(file, EncodePfm({disparities.width, disparities.height, disparities.px}));
  } else {
    WriteWhole(file, EncodePng(DeepOf(file, disparities)));
  }
}

std::string HeightsCsv(const ElevationMap& map) {
  std::string text = "x_m,y_m,height_m,sigma_m,points\n";
  char row[128];
  for (int iy = 0; iy < map.ny; ++iy) {
    for (int ix = 0; ix < map.nx; ++ix) {
      const auto cell = static_cast<std::size_t>(iy * map.nx + ix);
      if (map.points[cell] == 0) continue;
      std::snprintf(row, sizeof row, "%.5f,%.5f,%.5f,%.5f,%d\n", map.x0_m + ix * map.cell_m,
                    map.y0_m + iy * map.cell_m, static_cast<double>(map.height_m[cell]),
                    static_cast<double>(map.sigma_m[cell]), map.points[cell]);
      text += row;
    }
  }
  return text;
}

std::string PointsPly(const RectifiedPair& pair, const Disparities& disparities,
                      const GrayImage& left) {
  std::string points;
  std::size_t count = 0;
  for (int v = 0; v < disparities.height; ++v) {
    for (int u = 0; u < disparities.width; ++u) {
      const double px = static_cast<double>(disparities.at(u, v));
      if (!(px + pair.doffs_px > 0.0)) continue;
      const Eigen::Vector3d p_R = pair.X_RC * pair.Point(u, v, px);
      for (const double value : {p_R.x(), p_R.y(), p_R.z()}) PutFloat(points, value);
      points.append(3, static_cast<char>(left.at(u, v)));
      ++count;
    }
  }
  return "ply\nformat binary_little_endian 1.0\ncomment metres, in the frame of the rig\n"
         "element vertex " +
         std::to_string(count) +
         "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
         "property uchar green\nproperty uchar blue\nend_header\n" +
         points;
}

}  // namespace dockyard
