#include "sim/raposa/band_keys.h"

#include <cmath>

#include "models/read/yaml_reader.h"

namespace dockyard::raposa {
namespace {

constexpr int kMostHue = 179, kMostLevel = 255;

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

}  // namespace

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
