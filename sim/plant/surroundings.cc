#include "sim/plant/surroundings.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "sim/base/random.h"
#include "sim/plant/placement.h"

namespace dockyard {
namespace {

using Kind = SceneryItem::Kind;
using Colour = SceneryItem::Colour;

// All sizes are those of usual rooms, furniture and gardens; assumed, half to twice.
constexpr double kWallThick_m = 0.1, kWallHigh_m = 2.7;
constexpr double kSkirtingHigh_m = 0.08, kSkirtingDeep_m = 0.015;
constexpr double kDoorWide_m = 0.9, kDoorHigh_m = 2.0, kDoorDeep_m = 0.04;
constexpr double kJointWide_m = 0.005, kJointHigh_m = 0.002;
constexpr double kTableHigh_m = 0.72, kTableTop_m = 0.03, kLeg_m = 0.04;
// Places along a wall, of at most one thing each.
constexpr double kPlace_m = 2.0, kDeepest_m = 0.9;
constexpr double kBeforeTarget_m = 1.0;  // where a robot arrives

/// Draws one after the other. Never two in the arguments of one call: compilers differ in which
/// they evaluate first.
class Hand {
 public:
  explicit Hand(std::uint64_t stream) : random_(stream) {}

  double Between(double low, double high) { return random_.Uniform(low, high); }
  int Count(int low, int high) {
    return std::min(high, low + static_cast<int>((high - low + 1) * random_.Uniform()));
  }
  Colour Of(std::initializer_list<Colour> colours) {
    return colours.begin()[Count(0, static_cast<int>(colours.size()) - 1)];
  }
  RandomStream& random() { return random_; }

 private:
  RandomStream random_;
};

SceneryItem Solid(Kind kind, Colour colour, const Eigen::Vector3d& size_m, const Pose2& X_DO,
                  double up_m = 0.0) {
  SceneryItem item;
  item.kind = kind;
  item.colour = colour;
  item.size_m = size_m;
  item.X_DO = X_DO;
  item.up_m = up_m;
  return item;
}

/// One of a room's walls: its frame has x along the wall, y into the room, its middle on the floor
/// of the inner face.
struct Wall {
  Pose2 X_DW;
  double long_m = 0.0;

  SceneryItem Box(Colour colour, double along_m, double into_m, const Eigen::Vector3d& size_m,
                  double up_m = 0.0) const {
    return Solid(Kind::kBox, colour, size_m, X_DW * Pose2{along_m, into_m, 0.0}, up_m);
  }
};

std::vector<Wall> WallsOf(const SceneryItem& room) {
  std::vector<Wall> walls;
  for (int side = 0; side < 4; ++side) {
    const bool across = side % 2 == 0;
    const double off_m = 0.5 * (across ? room.size_m.y() : room.size_m.x());
    const double turn = side * 0.5 * kPi;
    const Pose2 X_OW{off_m * std::sin(turn), -off_m * std::cos(turn), turn};
    walls.push_back({room.X_DO * X_OW, across ? room.size_m.x() : room.size_m.y()});
  }
  return walls;
}

void AddTable(const Wall& wall, double along_m, Hand& hand, std::vector<SceneryItem>& out) {
  using enum Colour;
  const double long_m = hand.Between(1.2, 1.8), deep_m = hand.Between(0.6, 0.8);
  const Colour legs = hand.Of({kBlack, kGrey}), top = hand.Of({kFloor, kWhite, kGrey});
  for (const double x : {-0.45, 0.45}) {
    for (const double y : {0.08, 0.92}) {
      const Pose2 X_WO{along_m + x * long_m, 0.05 + y * deep_m, 0.0};
      out.push_back(Solid(Kind::kCylinder, legs, {kLeg_m, kLeg_m, kTableHigh_m}, wall.X_DW * X_WO));
    }
  }
  out.push_back(
      wall.Box(top, along_m, 0.05 + 0.5 * deep_m, {long_m, deep_m, kTableTop_m}, kTableHigh_m));
}

/// At a place along a wall: a door, a cupboard, a table, or nothing.
void AddFurniture(const Wall& wall, double along_m, const SceneryItem& room, Hand& hand,
                  std::vector<SceneryItem>& out) {
  using enum Colour;
  const int what = hand.Count(0, 4);
  const bool coloured = hand.Between(0.0, 1.0) < room.coloured;
  Colour colour = coloured ? hand.Of({kDenim, kBrick}) : hand.Of({kFloor, kGrey, kWhite});
  if (colour == kBrick && room.reddish_m < kDoorHigh_m) colour = kDenim;
  if (what == 0) {
    out.push_back(
        wall.Box(colour, along_m, 0.5 * kDoorDeep_m, {kDoorWide_m, kDoorDeep_m, kDoorHigh_m}));
  } else if (what == 1) {
    const Eigen::Vector3d size_m{hand.Between(0.6, 1.2), hand.Between(0.35, 0.6),
                                 hand.Between(0.6, 2.0)};
    out.push_back(wall.Box(colour, along_m, 0.02 + 0.5 * size_m.y(), size_m));
  } else if (what <= 3) {
    AddTable(wall, along_m, hand, out);
  }
}

/// A wall with its skirting.
void AddWall(const Wall& wall, Colour paint, Colour skirting, std::vector<SceneryItem>& out) {
  out.push_back(wall.Box(paint, 0.0, -0.5 * kWallThick_m,
                         {wall.long_m + 2.0 * kWallThick_m, kWallThick_m, kWallHigh_m}));
  out.push_back(wall.Box(skirting, 0.0, 0.5 * kSkirtingDeep_m,
                         {wall.long_m, kSkirtingDeep_m, kSkirtingHigh_m}));
}

void AddFloorJoints(const SceneryItem& room, Hand& hand, std::vector<SceneryItem>& out) {
  const double apart_m = hand.Between(0.6, 1.2);
  for (const bool along : {true, false}) {
    const double long_m = along ? room.size_m.x() : room.size_m.y();
    const double wide_m = along ? room.size_m.y() : room.size_m.x();
    for (double at_m = hand.Between(0.0, apart_m); at_m < wide_m; at_m += apart_m) {
      const double off_m = at_m - 0.5 * wide_m;
      const Pose2 X_OJ = along ? Pose2{0.0, off_m, 0.0} : Pose2{off_m, 0.0, 0.5 * kPi};
      out.push_back(Solid(Kind::kBox, Colour::kBlack, {long_m, kJointWide_m, kJointHigh_m},
                          room.X_DO * X_OJ));
    }
  }
}

/// Whether a place is clear of the robot's paths.
bool IsClear(const Eigen::Vector2d& p, double clear_m, const Eigen::Vector2d& start_D) {
  const Eigen::Vector2d target(0.0, 0.0), before(kBeforeTarget_m, 0.0);
  return DistanceTo(p, target, start_D) >= clear_m && DistanceTo(p, target, before) >= clear_m;
}

SceneryItem LooseThing(const SceneryItem& room, Hand& hand) {
  using enum Colour;
  const Kind kind = hand.Count(0, 3) == 0   ? Kind::kCylinder
                    : hand.Count(0, 3) == 0 ? Kind::kSphere
                                            : Kind::kBox;
  const bool coloured = hand.Between(0.0, 1.0) < room.coloured;
  const Colour colour = coloured ? hand.Of({kDenim, kBrick, kConeOrange})
                                 : hand.Of({kFloor, kFloor, kBlack, kBlack, kGrey, kWhite});
  Eigen::Vector3d size_m{hand.Between(0.1, 0.45), hand.Between(0.1, 0.45), hand.Between(0.1, 0.5)};
  if (kind != Kind::kBox) size_m.y() = size_m.x();
  if (kind == Kind::kSphere) size_m.setConstant(0.6 * size_m.x());
  const bool reddish = colour == kBrick || colour == kConeOrange;
  if (reddish) size_m *= std::min(1.0, room.reddish_m / size_m.maxCoeff());
  return Solid(kind, colour, size_m, {});
}

SceneryItem TuftStoneOrLeaf(Hand& hand) {
  using enum Colour;
  const int what = hand.Count(0, 3);
  if (what == 0) {
    const double side_m = hand.Between(0.04, 0.3);
    return Solid(Kind::kSphere, kGrey, {side_m, side_m, side_m}, {}, -0.3 * side_m);
  }
  if (what == 1) {
    const double side_m = hand.Between(0.03, 0.10);
    const Colour colour = hand.Of({kSoil, kBrick, kConeOrange, kGrass});
    return Solid(Kind::kBox, colour, {side_m, 0.6 * side_m, 0.004}, {});
  }
  const double side_m = hand.Between(0.08, 0.35), high_m = hand.Between(0.05, 0.3);
  return Solid(Kind::kCone, hand.Of({kGrass, kGrass, kSoil}), {side_m, side_m, high_m}, {});
}

}  // namespace

std::vector<SceneryItem> DrawRoom(const SceneryItem& room, const Eigen::Vector2d& start_D,
                                  std::uint64_t stream) {
  using enum Colour;
  std::vector<SceneryItem> out;
  Hand walls(WorldSeed(stream, 0, 0)), joints(WorldSeed(stream, 1, 0));
  const Colour paint = walls.Of({kWhite, kWhite, kGrey, kFloor});
  const Colour skirting = walls.Of({kBlack, kGrey, kFloor, kWhite});
  for (const Wall& wall : WallsOf(room)) {
    AddWall(wall, paint, skirting, out);
    const int places = static_cast<int>(wall.long_m / kPlace_m);
    for (int i = 0; i < places; ++i) {
      const double along_m = (i + 0.5 - 0.5 * places) * kPlace_m + walls.Between(-0.1, 0.1);
      const Pose2 middle = wall.X_DW * Pose2{along_m, 0.5 * kDeepest_m, 0.0};
      std::vector<SceneryItem> furniture;
      AddFurniture(wall, along_m, room, walls, furniture);
      const double reach_m = 0.5 * std::hypot(kPlace_m, kDeepest_m);
      if (!IsClear({middle.x, middle.y}, room.clear_m + reach_m, start_D)) continue;
      out.insert(out.end(), furniture.begin(), furniture.end());
    }
  }
  AddFloorJoints(room, joints, out);
  const double reach_m = 0.5 * room.size_m.head<2>().norm();
  for (int i = 0; i < room.count; ++i) {
    Hand hand(WorldSeed(stream, 2, static_cast<std::uint64_t>(i)));
    SceneryItem thing = LooseThing(room, hand);
    const double radius_m = RadiusOf(thing);
    const auto is_free = [&](const Eigen::Vector2d& p_O) {
      const Eigen::Vector2d from_wall = 0.5 * room.size_m.head<2>() - p_O.cwiseAbs();
      const Pose2 at = room.X_DO * Pose2{p_O.x(), p_O.y(), 0.0};
      return from_wall.minCoeff() >= radius_m &&
             IsClear({at.x, at.y}, room.clear_m + radius_m, start_D);
    };
    if (!PlaceInDisc(hand.random(), reach_m, is_free, thing)) continue;
    thing.X_DO = room.X_DO * thing.X_DO;
    out.push_back(thing);
  }
  return out;
}

namespace {

/// Everything round an outdoor scene, from its radius on.
std::vector<SceneryItem> RoundAbout(const SceneryItem& outdoors, Hand& hand) {
  using enum Colour;
  std::vector<SceneryItem> out;
  const auto ring = [&](double from, double to) {
    const double r_m = outdoors.radius_m * hand.Between(from, to);
    const double angle = hand.Between(-kPi, kPi);
    return outdoors.X_DO * Pose2{r_m * std::cos(angle), r_m * std::sin(angle), angle + 0.5 * kPi};
  };
  for (int i = hand.Count(8, 14); i > 0; --i) {  // hedges and bushes
    const Pose2 X_DO = ring(1.2, 1.8);
    const double side_m = hand.Between(0.8, 2.5);
    out.push_back(Solid(Kind::kSphere, kGrass, {side_m, side_m, side_m}, X_DO, -0.2 * side_m));
  }
  for (int i = hand.Count(3, 7); i > 0; --i) {  // trees
    const Pose2 X_DO = ring(1.1, 2.0);
    const double trunk_m = hand.Between(0.15, 0.4), crown_m = hand.Between(1.5, 3.5);
    out.push_back(Solid(Kind::kCylinder, kSoil, {trunk_m, trunk_m, 3.0}, X_DO));
    out.push_back(Solid(Kind::kSphere, kGrass, {crown_m, crown_m, crown_m}, X_DO, 2.0));
  }
  const Pose2 house = ring(1.8, 2.2), kerb = ring(1.05, 1.1), car = ring(1.5, 1.7);
  const Colour bricks = hand.Of({kBrick, kWhite, kGrey});
  const Colour paint = hand.Of({kDenim, kConeOrange, kWhite, kBlack});
  const double house_m = hand.Between(6.0, 10.0), high_m = hand.Between(2.5, 5.0);
  out.push_back(Solid(Kind::kBox, bricks, {house_m, 0.3, high_m}, house));
  out.push_back(Solid(Kind::kBox, kGrey, {hand.Between(4.0, 9.0), 0.15, 0.15}, kerb));
  out.push_back(Solid(Kind::kBox, paint, {4.0, 1.7, 1.3}, car, 0.15));
  for (int i = hand.Count(2, 5); i > 0; --i) {  // posts
    const Pose2 X_DO = ring(0.9, 1.3);
    out.push_back(
        Solid(Kind::kCylinder, hand.Of({kGrey, kFloor, kConeOrange}), {0.08, 0.08, 1.0}, X_DO));
  }
  return out;
}

}  // namespace

std::vector<SceneryItem> DrawOutdoors(const SceneryItem& outdoors, const Eigen::Vector2d& start_D,
                                      std::uint64_t stream) {
  Hand far(WorldSeed(stream, 0, 0));
  std::vector<SceneryItem> out = RoundAbout(outdoors, far);
  for (int i = 0; i < outdoors.count; ++i) {
    Hand hand(WorldSeed(stream, 1, static_cast<std::uint64_t>(i)));
    SceneryItem thing = TuftStoneOrLeaf(hand);
    const auto is_free = [&](const Eigen::Vector2d& p_O) {
      const Pose2 at = outdoors.X_DO * Pose2{p_O.x(), p_O.y(), 0.0};
      return IsClear({at.x, at.y}, outdoors.clear_m + RadiusOf(thing), start_D);
    };
    if (!PlaceInDisc(hand.random(), outdoors.radius_m, is_free, thing)) continue;
    thing.X_DO = outdoors.X_DO * thing.X_DO;
    out.push_back(thing);
  }
  return out;
}

}  // namespace dockyard
