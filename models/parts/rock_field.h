// Rocks in the ground, as a scenario describes them.
#pragma once

#include <vector>

namespace dockyard {

/// A rock at a given place in the target's frame D.
struct GivenRock {
  double x_m = 0.0, y_m = 0.0;
  double diameter_m = 0.1;  // mean of length and width
  double height_m = 0.04;   // above the ground at its place
  double turn_rad = 0.0;    // about the vertical
};

/// A field of rocks whose sizes obey Golombek and Rapp (JGR 102, 1997), and given ones. They are
/// fixed in the ground. None by default.
struct RockField {
  // k, the share of the ground under rocks of any size. At the landing sites of Viking 1 and 2 and
  // Pathfinder 0.07-0.19, at those of Spirit 0.05 and InSight 0.03 (Golombek et al. 2003, 2021).
  double cover = 0.0;
  double least_m = 0.05;    // smaller ones sink under a wheel; assumed, 0.03-0.10 m
  double largest_m = 0.30;  // larger ones an operator drives round; assumed, 0.15-1 m
  double clear_m = 1.5;     // radius about start and target without a rock of the field
  // Height over diameter: from 3/8, as measured at Viking 1, to 1/2, at Viking 2 (Golombek and Rapp
  // 1997).
  double flattest = 0.375, steepest = 0.5;
  double buried = 0.3;    // share of a rock's height below the ground; assumed, 0.1-0.5
  double friction = 0.6;  // of the robot's metal on rock; assumed, 0.3-0.8
  std::vector<GivenRock> given;
};

}  // namespace dockyard
