#include "sim/app/point_files.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <tuple>

#include "models/read/config_error.h"
#include "models/read/csv_table.h"
#include "models/read/near_names.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

const std::vector<std::string> kNeeded{"camera", "u_px", "v_px", "x_m", "y_m", "z_m"};
const std::vector<std::string> kOptional{"frame", "survey_error_m", "disc_diameter_m"};

/// The column's name that a strange one was meant to be; empty: it is one that we leave alone.
std::string MeantBy(const std::string& name, const YamlNode& row) {
  std::vector<std::string> missing;  // of those that a table needs
  for (const auto* names : {&kNeeded, &kOptional}) {
    for (const std::string& known : *names) {
      if (row.Find(known) != nullptr) continue;
      if (DiffersInCaseAlone(name, known)) return known;
      if (names == &kNeeded) missing.push_back(known);
    }
  }
  // `name` is no slip of `frame`: without a frame a sequence is refused anyway.
  const std::string near = NearestName(name, {"survey_error_m", "disc_diameter_m"});
  return near.empty() ? NearestName(name, missing) : near;
}

/// All columns' names: those that a row may have, and those that we leave alone.
std::vector<std::string> Columns(const YamlNode& row) {
  std::vector<std::string> all = kNeeded;
  all.insert(all.end(), kOptional.begin(), kOptional.end());
  const std::size_t known = all.size();
  for (const YamlNode::Key& key : row.keys) {
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(known);
    if (std::find(all.begin(), end, key.name) != end) continue;
    const std::string meant = MeantBy(key.name, row);
    if (!meant.empty()) {
      throw ConfigError(key.place.Text() + ": " + key.name + ": unknown column, did you mean '" +
                        meant + "'?");
    }
    all.push_back(key.name);
  }
  return all;
}

bool Given(const YamlNode& row, const char* column) {
  const YamlNode* cell = row.Find(column);
  return cell && cell->kind != YamlNode::Kind::kNull;
}

/// Trackers write NaN, or nothing, for a point that they did not find.
bool IsNoNumber(const YamlNode& row, const char* column) {
  const YamlNode* cell = row.Find(column);
  if (!cell) return false;
  if (cell->kind == YamlNode::Kind::kNull) return true;
  std::string text = cell->scalar;
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.erase(0, 1);
  return text == "nan" || text == "na" || text == "n/a" || text == "none" || text == "null";
}

/// The camera's image holds the pixel. A corner that is found by its edges may lie a little
/// outside.
void RequireInside(const YamlReader& in, const PointPixel& point, const StereoRig& rig) {
  constexpr double kOutside_px = 2.0;  // assumed, 1-5
  const Camera& camera = point.view == 0 ? rig.left : rig.right;
  if (camera.Sees(point.pixel, -kOutside_px)) return;
  const bool across =
      point.pixel.x() < -kOutside_px || point.pixel.x() > camera.width - 1.0 + kOutside_px;
  in.Refuse(across ? "u_px" : "v_px",
            std::string("a pixel of the ") + (point.view == 0 ? "left" : "right") +
                " camera's image of " + std::to_string(camera.width) + " x " +
                std::to_string(camera.height) +
                " px, it lies outside (are the pixels those of an image of another size or "
                "resolution? --width and --height state the images' size)");
}

PointPixel ReadPoint(const YamlNode& row, const YamlReader& in) {
  PointPixel point;
  point.view = in.Choice("camera", {"left", "right"});
  point.pixel = {in.Number("u_px", Between(-1e5, 1e5)), in.Number("v_px", Between(-1e5, 1e5))};
  point.p_B = {in.Number("x_m", Between(-1e4, 1e4)), in.Number("y_m", Between(-1e4, 1e4)),
               in.Number("z_m", Between(-1e4, 1e4))};
  if (Given(row, "survey_error_m")) point.survey_m = in.Number("survey_error_m", NonNegative(10.0));
  if (Given(row, "disc_diameter_m")) {
    point.disc_diameter_m = in.Number("disc_diameter_m", NonNegative(100.0));
  }
  return point;
}

}  // namespace

std::vector<PointFrame> LoadPointFrames(const std::string& file, bool sequence,
                                        const StereoRig* rig) {
  const YamlNode table = LoadCsv(file);
  std::vector<PointFrame> frames;
  if (table.items.empty()) {
    if (sequence) throw ConfigError(table.place.Text() + ": expected rows of points, found none");
    return {PointFrame{}};
  }
  const std::vector<std::string> columns = Columns(table.items[0]);
  std::map<std::string, std::size_t> by_name;
  // Frame and place of a point: its survey's error.
  std::map<std::tuple<std::size_t, double, double, double>, double> surveys;
  for (std::size_t i = 0; i < table.items.size(); ++i) {
    const YamlNode& row = table.items[i];
    const YamlReader in(row, "row " + std::to_string(i + 1), columns);
    std::string name;
    if (sequence || row.Find("frame")) name = in.Text("frame");
    const auto [at, is_new] = by_name.try_emplace(name, frames.size());
    if (is_new && !frames.empty() && !sequence) {
      in.Refuse("frame", "the same frame in every row (--sequence reads several)");
    }
    if (is_new) frames.push_back({.name = name, .points = {}, .rows = {}});
    if (IsNoNumber(row, "u_px") || IsNoNumber(row, "v_px")) {
      if (Given(row, "camera")) in.Choice("camera", {"left", "right"});
      ++frames[at->second].not_detected;
      continue;
    }
    const PointPixel point = ReadPoint(row, in);
    if (rig) RequireInside(in, point, *rig);
    const auto [known, first] = surveys.try_emplace(
        {at->second, point.p_B.x(), point.p_B.y(), point.p_B.z()}, point.survey_m);
    if (!first && known->second != point.survey_m) {
      const char* column = Given(row, "survey_error_m") ? "survey_error_m" : "x_m";
      in.Refuse(column, "the same survey_error_m in all rows of a point of a frame");
    }
    frames[at->second].points.push_back(point);
    frames[at->second].rows.push_back(static_cast<int>(i) + 1);
  }
  return frames;
}

double DefaultSurveyError(const std::vector<PointFrame>& frames) {
  // The error of a tape or a total station, and 1 cm in the room of 10 m of STAR-loc (Dumbgen et
  // al., arXiv 2309.05518). Assumed, 0.0002-0.003.
  constexpr double kRelative = 0.001;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
  for (const PointFrame& frame : frames) {
    for (const PointPixel& point : frame.points) {
      low = low.cwiseMin(point.p_B);
      high = high.cwiseMax(point.p_B);
    }
  }
  return kRelative * std::max(0.0, (high - low).maxCoeff());
}

}  // namespace dockyard
