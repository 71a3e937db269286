#include "sim/scenario/scenery_keys.h"

#include "models/read/config_error.h"
#include "models/read/yaml_reader.h"
#include "sim/scenario/key_path.h"

namespace dockyard {
namespace {

using Kind = SceneryItem::Kind;
using Colour = SceneryItem::Colour;

constexpr std::size_t kMostItems = 200;
constexpr int kMostInSet = 500;
// The renderer draws 2000 objects, of which the robot, its target and shade are some.
constexpr int kMostSolids = 1500;
constexpr Range kSide_m{0.01, 100.0}, kRoomSide_m{2.0, 30.0};
// Of a room's furniture and things; assumed, 0-0.4.
constexpr double kColoured = 0.3;
constexpr double kReddish_m = 2.5;  // all
// Walls, furniture and joints of the largest room; trees and the like outdoors.
constexpr int kMostOfRoom = 400, kMostOutdoors = 40;

/// How many solids it may become.
int SolidsOf(const SceneryItem& item) {
  switch (item.kind) {
    case Kind::kSet:
      return item.count;
    case Kind::kRoom:
      return kMostOfRoom + item.count;
    case Kind::kOutdoors:
      return kMostOutdoors + item.count;
    default:
      return 1;
  }
}

/// The keys of one kind, next to those of all.
std::vector<std::string> KeysOf(Kind kind) {
  std::vector<std::string> keys{"kind", "contact", "x_m", "y_m"};
  const auto add = [&](std::initializer_list<const char*> more) {
    keys.insert(keys.end(), more.begin(), more.end());
  };
  if (kind == Kind::kRoom) {
    add({"turn_deg", "length_m", "width_m", "things", "clear_m", "coloured", "reddish_m"});
    return keys;
  }
  if (kind == Kind::kOutdoors) {
    add({"turn_deg", "radius_m", "things", "clear_m"});
    return keys;
  }
  if (kind == Kind::kSet) {
    add({"count", "radius_m", "least_m", "largest_m", "clear_m", "colours"});
    return keys;
  }
  add({"up_m", "roll_deg", "pitch_deg", "turn_deg", "colour"});
  if (kind == Kind::kMesh) add({"file", "scale"});
  if (kind == Kind::kBox) add({"length_m", "width_m"});
  if (kind == Kind::kCylinder || kind == Kind::kCone || kind == Kind::kSphere) add({"diameter_m"});
  if (kind == Kind::kBox || kind == Kind::kCylinder || kind == Kind::kCone) add({"height_m"});
  return keys;
}

void ReadSet(const YamlReader& in, SceneryItem& item) {
  item.count = in.Integer("count", 1, kMostInSet);
  item.radius_m = in.Number("radius_m", Positive(100.0));
  item.least_m = in.NumberOr("least_m", item.least_m, Between(0.01, 10.0));
  item.largest_m = in.NumberOr("largest_m", item.largest_m, Between(0.01, 10.0));
  if (item.least_m > item.largest_m) in.Refuse("least_m", "at most largest_m");
  item.clear_m = in.NumberOr("clear_m", item.clear_m, NonNegative(50.0));
  if (!in.Has("colours")) {
    item.colours = {Colour::kGrey};
    return;
  }
  for (const YamlNode& name : in.List("colours", 1, SceneryColours().size()).items) {
    YamlNode one;
    one.kind = YamlNode::Kind::kMapping;
    one.place = name.place;
    one.keys.push_back({"colours", name.place});
    one.items.push_back(name);
    item.colours.push_back(static_cast<Colour>(
        YamlReader(one, in.PathOf("colours"), {"colours"}).Choice("colours", SceneryColours())));
  }
}

/// Of a room or the outdoors.
void ReadSurroundings(const YamlReader& in, SceneryItem& item) {
  item.X_DO.heading = in.DegreesOr("turn_deg", 0.0, Between(-180.0, 180.0));
  if (item.kind == Kind::kRoom) {
    item.size_m = {in.Number("length_m", kRoomSide_m), in.Number("width_m", kRoomSide_m), 0.0};
    item.count = 6;
    item.coloured = in.NumberOr("coloured", kColoured, Between(0.0, 1.0));
    item.reddish_m = in.NumberOr("reddish_m", kReddish_m, Between(0.01, 10.0));
  } else {
    item.radius_m = in.NumberOr("radius_m", 6.0, Between(1.0, 50.0));
    item.count = 40;
  }
  if (in.Has("things")) item.count = in.Integer("things", 0, kMostInSet);
  item.clear_m = in.NumberOr("clear_m", 0.8, NonNegative(50.0));
}

SceneryItem ReadItem(YamlNode& node, const std::string& path) {
  static const std::vector<std::string> kinds{"box",  "cylinder", "cone", "sphere",
                                              "mesh", "set",      "room", "outdoors"};
  std::vector<std::string> all;
  for (int kind = 0; kind < static_cast<int>(kinds.size()); ++kind) {
    for (const std::string& key : KeysOf(static_cast<Kind>(kind))) all.push_back(key);
  }
  SceneryItem item;
  item.kind = static_cast<Kind>(YamlReader(node, path, all).Choice("kind", kinds));
  const YamlReader in(node, path, KeysOf(item.kind));
  if (in.BoolOr("contact", false)) {
    in.Refuse("contact", "false, as nothing runs into scenery");
  }
  item.X_DO.x = in.Number("x_m", Between(-200.0, 200.0));
  item.X_DO.y = in.Number("y_m", Between(-200.0, 200.0));
  if (item.kind == Kind::kSet) {
    ReadSet(in, item);
    return item;
  }
  if (item.kind == Kind::kRoom || item.kind == Kind::kOutdoors) {
    ReadSurroundings(in, item);
    return item;
  }
  item.up_m = in.NumberOr("up_m", 0.0, Between(-100.0, 100.0));
  const Range turn{-180.0, 180.0};
  item.roll_rad = in.DegreesOr("roll_deg", 0.0, turn);
  item.pitch_rad = in.DegreesOr("pitch_deg", 0.0, turn);
  item.X_DO.heading = in.DegreesOr("turn_deg", 0.0, turn);
  item.colour = static_cast<Colour>(in.ChoiceOr("colour", 0, SceneryColours()));
  if (item.kind == Kind::kMesh) {
    item.file = AbsolutePath(in.File("file"));
    YamlNode& file = *FindPath(node, "file");
    file.scalar = item.file;
    file.quoted = true;
    item.scale = in.NumberOr("scale", 1.0, Positive(1000.0));
  } else if (item.kind == Kind::kBox) {
    item.size_m = {in.Number("length_m", kSide_m), in.Number("width_m", kSide_m),
                   in.Number("height_m", kSide_m)};
  } else {
    item.size_m.setConstant(in.Number("diameter_m", kSide_m));
    if (item.kind != Kind::kSphere) item.size_m.z() = in.Number("height_m", kSide_m);
  }
  return item;
}

}  // namespace

const std::vector<std::string>& SceneryColours() {
  static const std::vector<std::string> names{"grey",  "white",       "black",  "brick",
                                              "denim", "cone_orange", "orange", "blue",
                                              "grass", "soil",        "floor"};
  return names;
}

void ReadScenery(Scenario& s) {
  s.scenery.clear();
  std::vector<YamlNode>& items = s.given_scenery.items;
  if (items.size() > kMostItems) {
    throw ConfigError(s.given_scenery.place.Text() + ": scenery: expected at most " +
                      std::to_string(kMostItems) + " items, found " + std::to_string(items.size()));
  }
  int solids = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    s.scenery.push_back(ReadItem(items[i], YamlReader::PathOf("scenery", i)));
    solids += SolidsOf(s.scenery.back());
    if (solids <= kMostSolids) continue;
    throw ConfigError(items[i].place.Text() + ": " + YamlReader::PathOf("scenery", i) +
                      ": expected at most " + std::to_string(kMostSolids) +
                      " things in all, those of sets counted, found " + std::to_string(solids));
  }
}

}  // namespace dockyard
