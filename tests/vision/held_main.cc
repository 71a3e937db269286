// vision_held [image pairs]: rates and errors for boards of other kinds than the station's, as a
// table.
#include <cstdio>
#include <cstdlib>
#include <map>

#include "vision/held_board.h"

using namespace dockyard;

namespace {

void Row(const char* name, const HeldOptions& options, int count, int in_view) {
  const HeldScore s = ScoreHeld(options, count, in_view);
  std::printf(
      "%-44s %3d of %3d accepted, %d wrong; %d marks, %d wrong; worst %.4f of the range, %.2f "
      "deg\n",
      name, s.accepted, s.pairs, s.wrong_poses, s.marks, s.wrong_marks, s.worst_place,
      Degrees(s.worst_turn_rad));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 20;
  const Camera wide = PinholeCamera(720, 540, Radians(110.0), -0.03);
  const Camera normal = EquidistantCamera(640, 480, Radians(90.0));
  HeldOptions photo{.board = PlainGrid(4, 3, 0.09, 0.06, Radians(80.0)), .camera = wide};
  photo.baseline_m = 0.097;
  photo.r_min_m = 0.22;
  photo.r_max_m = 0.45;
  photo.left_only = true;
  Row("plain 4x3, 110 deg lens, 0.22-0.45 m, one camera", photo, count, 12);
  photo.left_only = false;
  Row("the same, pair", photo, count, 12);
  HeldOptions far{.board = PlainGrid(4, 3, 0.09, 0.05, Radians(80.0)), .camera = normal};
  far.r_max_m = 1.5;
  far.roll_rad = Radians(60.0);
  far.left_only = true;
  Row("plain 4x3, 0.5-1.5 m, roll 60 deg, one camera", far, count, 12);
  far.left_only = false;
  Row("the same, pair", far, count, 12);
  far.covered_share = 0.2;
  Row("the same, a column covered", far, count, 9);
  far.covered_share = 0.0;
  far.clutter = 12;
  Row("the same, 12 more discs", far, count, 12);
  far.noise_dn = 6.0;
  Row("the same, noise 6 DN", far, count, 12);
  for (const int marks : {4, 5, 6, 7}) {
    HeldOptions bars{.board = BarBoard(marks, 0.06), .camera = normal};
    bars.tilt_rad = Radians(28.0);
    bars.r_min_m = 0.7;
    bars.r_max_m = 2.0;
    const std::string name = std::to_string(marks) + " bars, 0.7-2 m, ";
    bars.left_only = true;
    Row((name + "one camera").c_str(), bars, count, marks);
    bars.left_only = false;
    Row((name + "pair").c_str(), bars, count, marks);
  }
  return 0;
}
