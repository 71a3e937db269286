#include "sim/raposa/ferreira_keys.h"

#include <cmath>
#include <string>
#include <vector>

#include "models/read/yaml_reader.h"
#include "sim/raposa/ferreira_members.h"

namespace dockyard::raposa {
namespace {

constexpr int kMostHue = 179, kMostLevel = 255;
constexpr double kMostNumber =
    1e5;  // of motion; nor of vision; no speed, time or limit is as large

void ReadEnds(const YamlReader& in, const char* key, int most, bool around, std::uint8_t& from,
              std::uint8_t& to) {
  const YamlNode& list = in.List(key, 2, 2);
  double ends[2] = {0.0, 0.0};
  for (std::size_t i = 0; i < 2; ++i) {
    const bool whole = ParseNumber(list.items[i].scalar, ends[i]) && ends[i] >= 0.0 &&
                       ends[i] <= most && ends[i] == std::floor(ends[i]);
    if (!whole) in.Refuse(key, "two whole numbers from 0 to " + std::to_string(most));
  }
  // Hues go round.
  if (!around && ends[0] > ends[1]) in.Refuse(key, "two numbers in ascending order");
  from = static_cast<std::uint8_t>(ends[0]);
  to = static_cast<std::uint8_t>(ends[1]);
}

void ReadBand(const YamlReader& root, const char* key, HsvBand& band) {
  if (!root.Has(key)) return;
  const YamlReader in(root.Child(key), root.PathOf(key), {"hue", "saturation", "value"});
  ReadEnds(in, "hue", kMostHue, true, band.hue_from, band.hue_to);
  ReadEnds(in, "saturation", kMostLevel, false, band.saturation_from, band.saturation_to);
  ReadEnds(in, "value", kMostLevel, false, band.value_from, band.value_to);
}

/// As people write it.
std::string InDegrees(std::string name) {
  const std::size_t at = name.find("_rad");
  return at == std::string::npos ? name : name.replace(at, 4, "_deg");
}

/// Adds the names of members, as people write them.
struct MemberNames {
  std::vector<std::string>& names;

  void operator()(const char* name, const auto&) const { names.push_back(InDegrees(name)); }
};

/// Reads the members that a mapping has.
struct MemberReader {
  YamlReader in;

  void operator()(const char* name, bool& value) const { value = in.BoolOr(name, value); }
  void operator()(const char* name, int& value) const {
    if (in.Has(name)) value = in.Integer(name, 1, 1000);
  }
  void operator()(const char* name, double& value) const {
    const std::string key = InDegrees(name);
    // The arm's angles alone have a sign.
    const bool arm = key == "level_arm_deg" || key == "least_arm_deg";
    const Range range = arm ? Between(-90.0, 90.0) : NonNegative(kMostNumber);
    value = key == name ? in.NumberOr(key, value, range) : in.DegreesOr(key, value, range);
  }
};

}  // namespace

void PutMotion(const RaposaKeys& keys, FerreiraMotion& motion) {
  if (keys.motion.kind == YamlNode::Kind::kNull) return;
  std::vector<std::string> names;
  VisitMotion(motion, MemberNames{names});
  VisitMotion(motion, MemberReader{YamlReader(keys.motion, "raposa.motion", names)});
}

void PutVision(const RaposaKeys& keys, FerreiraVision& vision) {
  if (keys.vision.kind == YamlNode::Kind::kNull) return;
  std::vector<std::string> names;
  VisitVision(vision, MemberNames{names});
  VisitVision(vision, MemberReader{YamlReader(keys.vision, "raposa.vision", names)});
}

void PutBands(const RaposaKeys& keys, FerreiraVision& vision) {
  if (keys.bands.kind != YamlNode::Kind::kNull) {
    const YamlReader in(keys.bands, "raposa.bands", {"orange", "blue"});
    ReadBand(in, "orange", vision.orange);
    ReadBand(in, "blue", vision.blue);
  }
  BandChange last{0.0, vision.orange, vision.blue};
  for (std::size_t i = 0; i < keys.band_changes.items.size(); ++i) {
    const YamlReader in(keys.band_changes.items[i],
                        YamlReader::PathOf(std::string("raposa.band_changes"), i),
                        {"at_s", "orange", "blue"});
    const double at_s = in.Number("at_s", NonNegative(1e5));
    if (at_s < last.at_s) in.Refuse("at_s", "times in ascending order");
    last.at_s = at_s;
    ReadBand(in, "orange", last.orange);
    ReadBand(in, "blue", last.blue);
    vision.band_changes.push_back(last);
  }
}

}  // namespace dockyard::raposa
