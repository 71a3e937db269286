// What the rover does next on its path to a face, from what it believes of it.
#pragma once

#include <string>
#include <vector>

#include "controller/rocky7/face_belief.h"
#include "controller/rocky7/odometry.h"

namespace dockyard::rocky7 {

struct FaceApproachOptions {
  FrontEnd front_end = FrontEnd::kSandAndStones;
  bool learns_slope = false;  // the ground ahead has the slope that the body had; else it is level
  double image_share = 0.1;   // of the distance that is left, then an image pair follows
  // The steps' bounds. The paper's are its share alone.
  double least_step_m = 0.03, most_step_m = 1e9;
  OdometryOptions odometry{};
  bool exposes_for_target = false;  // asks for more light where the target lies in the shade
  // Plans anew at each image pair of the last metre and corrects where it rests. Else the two arcs
  // are driven as planned from a metre away, and the mast does what it can from there, without a
  // new search (N, IV-B).
  bool corrects = false;
  int most_looks = 60, most_misses = 1;  // pairs in all; in a row without the target
  int blind_after = 1000;  // misses in a row; then it goes on by odometry while far away
};

/// How far the approach has come.
struct FaceProgress {
  bool near = false;        // within the last metre
  bool driven_all = false;  // the arcs that were planned there
  int near_pairs = 0;       // of images, taken so near that single arcs correct
};

struct FaceDecision {
  std::vector<Arc> arcs{};  // to drive; none: place the instrument from here,
  std::string why_not{};    // or give up
};

/// @param face          FaceNow
/// @param tool_off_rad  ToolOff it
FaceDecision DecideNext(const Nominal& nominal, const FaceApproachOptions& options,
                        const FaceBelief& belief, const FaceAt& face, double tool_off_rad,
                        FaceProgress& progress);

}  // namespace dockyard::rocky7
