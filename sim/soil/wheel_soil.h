// Forces of deformable soil on one rigid wheel with paddles. Independent of Bullet.
//
// The wheel's surface is divided into patches that turn with it: strips of the rim, the paddles'
// tips and faces, and the rim's two sides. Each patch in the soil carries
// * pressure on its own normal: elastic from the rut's floor, yielding at Bekker's k z^n, where z
//   is counted from the soil as it was, times the share that a patch moving in this direction can
//   press on (soil_laws.h); bounded damping, never suction; a resting wheel's small sliding along a
//   patch's plane presses nothing, so that the elastic soil gives back no more than it was given;
// * shear by the displacement of the patch since it entered (Janosi and Hanamoto 1961), kept at
//   rest, unloaded on reversal, gone when the patch leaves the soil;
// * on paddle faces passive earth pressure; on sides bulldozing resistance and its friction.
// Nothing divides by a velocity, so a wheel at rest stays at rest. docs/reference/soil.md has the
// equations.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "models/parts/soil_model.h"
#include "models/parts/wheel.h"
#include "sim/soil/envelope.h"
#include "sim/soil/height_grid.h"
#include "sim/soil/paddle_print.h"
#include "sim/soil/patch.h"
#include "sim/soil/rut.h"
#include "sim/soil/side_wall.h"
#include "sim/soil/soil_laws.h"
#include "sim/soil/wheel_frame.h"
#include "sim/soil/wheel_travel.h"

namespace dockyard {

struct WheelLoad {
  Eigen::Vector3d force_G = Eigen::Vector3d::Zero();   // on the wheel [N]
  Eigen::Vector3d torque_G = Eigen::Vector3d::Zero();  // about the wheel's centre [N m]
  double sinkage_m = 0.0;  // of the lowest element below the soil as it was
};

/// One wheel's contact state (shear displacement of every element) and the soil under it. Copyable
/// state, no globals; the same calls give the same bits.
class WheelSoil {
 public:
  WheelSoil(const WheelModel& wheel, const SoilModel& soil);
  /// The soil of the grid's next number: each wheel is on that below its centre.
  void AddSoil(const SoilModel& soil) { laws_.push_back(LawsOf(soil)); }
  /// From now on the rut has a print of each paddle that has been in the soil.
  void PrintPaddles() { prints_ = true; }

  /// Advances the contact by dt and returns the load; leaves the rut in the grid.
  WheelLoad Step(HeightGrid& grid, const WheelMotion& motion, double dt_s);

  /// Hash of the contact state, for bit-exact comparison of runs.
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  static constexpr int kLines = 3;  // across the width: right, middle, left
  template <typename Real>
  using Row = std::array<SpokeLoadOf<Real>, kLines>;
  struct Strips {   // four neighbours on the rim
    Four cos, sin;  // directions from the axle in K: (cos, 0, -sin)
    std::array<PatchOf<Four>, kLines> patches;
    SideWalls sides;
    bool in_soil = false;  // any of them; else patches and sides are as made
  };
  /// Its three patches and faces across the width, and the left ones once more.
  struct Paddle {
    double cos = 0.0, sin = 0.0;
    PatchOf<Four> tips;
    MobilisationOf<Four> faces;  // of the passive pressure, along t
    Row<double> face_loads;      // of this step, as far as the soil behind them holds
    bool pushes = false;
    PaddlePrint print{};     // of the place where it was deepest
    double deepest_m = 0.0;  // there, below the soil as it was
  };
  /// The wheel and the ground below it in one step.
  struct Place {
    WheelFrame frame;
    GroundUnder ground;
  };

  struct Laws {
    SoilLaws rim{}, tip{};
    double bearing_radius_m = 0.0;  // of the rim with the soil caught between the paddles
    double strip_length_m = 0.0;
  };
  Laws LawsOf(const SoilModel& soil) const;
  void Use(const Laws& laws);
  void FindTop(const HeightGrid& grid, WheelFrame& frame) const;
  void FollowMotion(const WheelFrame& frame);
  template <typename Real>
  void AddRow(const SpokeAxesOf<Real>& axes, double radius_m, const Row<Real>& row,
              LoadSumOf<Real>& sum) const;
  template <typename Real>
  void AddToEnvelope(const Row<Real>& row);
  static void Forget(Strips& strips);
  void MoveWindow(int first, int count);
  void AddRim(const Place& at, LoadSum& sum);
  void AddStrips(const Place& at, Strips& strips, LoadSumOf<Four>& sum);
  void AddFaces(const WheelFrame& frame, LoadSum& sum) const;
  void AddPaddles(const Place& at, LoadSum& sum);
  void AddPaddle(const Place& at, Paddle& paddle, LoadSum& sum);
  /// The faces' thrusts.
  Four LoadFaces(const PatchPlaceOf<Four>& tip, const SpokeVelocityOf<Four>& v, double rise_m,
                 double dt_s, MobilisationOf<Four>& faces) const;
  void LeaveRut(HeightGrid& grid, const WheelFrame& frame);
  void FollowPrint(const Place& at, Paddle& paddle) const;
  void LeavePrints(HeightGrid& grid, const WheelFrame& frame);

  WheelModel wheel_;
  std::vector<Laws> laws_;  // by the soil's number
  SoilLaws rim_, tip_;      // those in use, and the next two
  double bearing_radius_m_ = 0.0, strip_length_m_ = 0.0;
  double line_width_m_ = 0.0, paddle_spacing_m_ = 0.0;
  double rim_share_ = 1.0;  // of the rim's area that paddles leave free
  std::vector<Strips> strips_;
  std::vector<Paddle> paddles_;
  int first_four_ = 0, four_count_ = 0;  // of strips_, those that may touch, of the last step
  double half_angle_ = 0.0;              // of the strips that may touch
  Envelope envelope_;
  WheelTravel travel_;
  double contact_depth_m_ = 0.0;  // of the last step
  double sinkage_m_ = 0.0;
  double since_rut_s_ = 0.0;
  bool prints_ = false;
  RutScratch scratch_;
};

/// Adds the loads of one row across the width, the outer two first, so that a mirrored wheel adds
/// the same numbers.
template <typename Real>
void WheelSoil::AddRow(const SpokeAxesOf<Real>& axes, double radius_m, const Row<Real>& row,
                       LoadSumOf<Real>& sum) const {
  const SpokeLoadOf<Real> load{(row[0].r + row[2].r) + row[1].r, (row[0].t + row[2].t) + row[1].t,
                               (row[0].a + row[2].a) + row[1].a};
  sum.Add(axes, radius_m, load, -line_width_m_ * (row[2].t - row[0].t),
          line_width_m_ * (row[2].r - row[0].r));
}

template <typename Real>
void WheelSoil::AddToEnvelope(const Row<Real>& row) {
  envelope_.pressed_n -= Sum((row[0].r + row[2].r) + row[1].r);
  envelope_.rim_and_tips_n += Sum((row[0].t + row[2].t) + row[1].t);
}

}  // namespace dockyard
