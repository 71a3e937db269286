#include "controller/motion/extreme_arcs.h"

#include <cmath>

namespace dockyard {
namespace {

using Eigen::Vector2d;

constexpr double kLeft = 1.0, kRight = -1.0;

Vector2d Along(double heading) { return {std::cos(heading), std::sin(heading)}; }
Vector2d LeftOf(double heading) { return {-std::sin(heading), std::cos(heading)}; }
double HeadingOf(const Vector2d& along) { return std::atan2(along.y(), along.x()); }

/// The words of arcs to one goal. A side says where the centre of a circle is.
class Words {
 public:
  Words(const Pose2& X_RG, double radius_m, Travel travel)
      : goal_(X_RG), radius_m_(radius_m), travel_(travel) {}

  std::vector<ArcTriple> All() {
    for (const double first : {kLeft, kRight}) {
      AddRoundThree(first);
      AddSameSides(first);
      AddOtherSides(first);
    }
    return std::move(words_);
  }

 private:
  Vector2d StartCentre(double side) const { return {0.0, side * radius_m_}; }
  Vector2d GoalCentre(double side) const {
    return Vector2d(goal_.x, goal_.y) + side * radius_m_ * LeftOf(goal_.heading);
  }

  Arc Round(double side, double from_heading, double to_heading) const {
    double turn = WrapPi(to_heading - from_heading);
    const bool forward = side * turn >= 0.0;
    if (travel_ == Travel::kForward && !forward) turn += side * 2.0 * kPi;
    if (travel_ == Travel::kBackward && forward && turn != 0.0) turn -= side * 2.0 * kPi;
    return {side * radius_m_ * turn, turn};
  }

  // The middle circle touches the other two.
  void AddRoundThree(double side) {
    const Vector2d from = StartCentre(side), to = GoalCentre(side), way = to - from;
    const double squared = 4.0 * radius_m_ * radius_m_ - 0.25 * way.squaredNorm();
    if (squared < 0.0 || radius_m_ == 0.0 || way.norm() == 0.0) return;
    const Vector2d aside = std::sqrt(squared) * Vector2d(-way.y(), way.x()) / way.norm();
    for (const double sign : {-1.0, 1.0}) {
      const Vector2d middle = 0.5 * (from + to) + sign * aside;
      // A centre on the left lies a quarter turn to the left of the heading.
      const double first = HeadingOf(side * (from - middle)) - 0.5 * kPi;
      const double second = HeadingOf(side * (to - middle)) - 0.5 * kPi;
      words_.push_back({Round(side, 0.0, first), Round(-side, first, second),
                        Round(side, second, goal_.heading)});
    }
  }

  void AddSameSides(double side) {
    const Vector2d way = GoalCentre(side) - StartCentre(side);
    if (way.norm() == 0.0) return;
    AddStraight(side, side, HeadingOf(way), way.norm());
    AddStraight(side, side, HeadingOf(-way), -way.norm());
  }

  void AddOtherSides(double side) {
    const Vector2d way = GoalCentre(-side) - StartCentre(side);
    const double distance = way.norm();
    if (distance < 2.0 * radius_m_ || distance == 0.0) return;
    const double across = std::asin(2.0 * radius_m_ / distance);
    for (const double heading :
         {HeadingOf(way) + side * across, HeadingOf(way) + kPi - side * across}) {
      AddStraight(side, -side, heading, way.dot(Along(heading)));
    }
  }

  void AddStraight(double first_side, double last_side, double heading, double length_m) {
    if (travel_ == Travel::kForward && length_m < 0.0) return;
    if (travel_ == Travel::kBackward && length_m > 0.0) return;
    words_.push_back({Round(first_side, 0.0, heading), Arc{length_m, 0.0},
                      Round(last_side, heading, goal_.heading)});
  }

  Pose2 goal_;
  double radius_m_;
  Travel travel_;
  std::vector<ArcTriple> words_;
};

}  // namespace

std::vector<ArcTriple> ExtremeTriples(const Pose2& X_RG, double radius_m, Travel travel) {
  return Words(X_RG, radius_m, travel).All();
}

}  // namespace dockyard
