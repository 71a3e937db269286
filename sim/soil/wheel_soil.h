// Forces of deformable soil on one rigid wheel with paddles. Independent of Bullet.
//
// The wheel's surface is divided into patches that turn with it: strips of the rim, the paddles'
// tips and faces, and the rim's two edges for the wheel's sides. Each patch in the soil carries
// * pressure on its own normal: elastic from the rut's floor, yielding at Bekker's k z^n, where z
//   is counted from the soil as it was and slip weakens it (slip_sinkage.h); bounded damping,
//   never suction; a resting wheel's small sliding along a patch's plane presses nothing, so that
//   the elastic soil gives back no more than it was given;
// * shear by the displacement of the patch since it entered (Janosi and Hanamoto 1961), kept at
//   rest, unloaded on reversal, gone when the patch leaves the soil;
// * on paddle faces passive earth pressure, on sides bulldozing resistance (Wong 2008).
// Nothing divides by a velocity, so a wheel at rest stays at rest.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "controller/geometry/pose.h"
#include "models/rover_model.h"
#include "models/soil_model.h"
#include "sim/soil/height_grid.h"
#include "sim/soil/rut.h"
#include "sim/soil/slip_sinkage.h"
#include "sim/soil/soil_laws.h"

namespace dockyard {

/// Where a wheel is and how it moves, in the site frame G. The wheel frame K turns with the wheel.
struct WheelMotion {
  Pose3 X_GK;
  Eigen::Vector3d v_GK_G = Eigen::Vector3d::Zero();  // of the wheel's centre [m/s]
  Eigen::Vector3d w_GK_G = Eigen::Vector3d::Zero();  // [rad/s], spin included
};

struct WheelLoad {
  Eigen::Vector3d force_G = Eigen::Vector3d::Zero();   // on the wheel [N]
  Eigen::Vector3d torque_G = Eigen::Vector3d::Zero();  // about the wheel's centre [N m]
  double sinkage_m = 0.0;  // of the lowest element below the soil as it was
  bool in_contact = false;
};

/// One wheel's contact state (shear displacement of every element) and the soil under it. Copyable
/// state, no globals; the same calls give the same bits.
class WheelSoil {
 public:
  WheelSoil(const WheelModel& wheel, const SoilModel& soil);

  /// Advances the contact by dt and returns the load; leaves the rut in the grid.
  WheelLoad Step(HeightGrid& grid, const WheelMotion& motion, double dt_s);

  /// Hash of the contact state, for bit-exact comparison of runs.
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  static constexpr int kLines = 3;  // across the width: right, middle, left
  static constexpr double kNoFloor_m = 1e9;
  /// What a patch remembers while it is in the soil.
  struct Patch {
    Mobilisation shear;
    double slid_t_m = 0.0, slid_a_m = 0.0;  // since it entered
    double ride_m = 0.0;          // change of the floor by sliding along the patch's plane
    double floor_m = kNoFloor_m;  // height at which the soil under this patch ends its rebound
  };
  /// A strip of the rim, or a paddle: its direction from the axle in K is (cos, 0, -sin).
  struct Spoke {
    double cos = 0.0, sin = 0.0;
    std::array<Patch, kLines> patches;          // rim strip, or the paddle's tip
    std::array<double, kLines> faces{0, 0, 0};  // paddles: mobilised passive pressure, -1..1
    double side = 0.0;                          // strips: mobilised bulldozing, -1..1
  };
  struct Frame;
  struct PatchPlace;
  struct PatchLoad;
  struct Sum;

  Frame MakeFrame(const HeightGrid& grid, const WheelMotion& motion, double dt_s) const;
  void FollowMotion(const Frame& frame);
  PatchLoad LoadPatch(const SoilLaws& laws, const PatchPlace& at, double area_m2, double dt_s,
                      Patch& patch) const;
  void AddRim(const HeightGrid& grid, const Frame& frame, Sum& sum);
  void MoveWindow(int first, int count);
  void AddStrip(const HeightGrid& grid, const Frame& frame, Spoke& strip, Sum& sum) const;
  void AddPaddles(const HeightGrid& grid, const Frame& frame, Sum& sum);
  void AddPaddle(const HeightGrid& grid, const Frame& frame, Spoke& paddle, Sum& sum) const;
  void LeaveRut(HeightGrid& grid, const Frame& frame);

  WheelModel wheel_;
  SoilLaws rim_, tip_;
  double n_ = 1.0, n_slip_ = 0.0;
  double strip_length_m_ = 0.0, line_width_m_ = 0.0, paddle_spacing_m_ = 0.0;
  std::vector<Spoke> strips_, paddles_;
  int first_strip_ = 0, strip_count_ = 0;  // the strips that may touch, of the last step
  SlipTrack slip_;
  Mobilisation going_;    // length 1: on its way ahead (t) or up (a); about 0 while it rocks
  double resting_ = 1.0;  // 1 - going^2
  SlipSinkage slip_sinkage_;
  double sinkage_m_ = 0.0, contact_length_m_ = 0.0;
  int steps_since_rut_ = 0;
  RutScratch scratch_;
};

}  // namespace dockyard
