// The tether as a cable with mass: it hangs, lies on the ground, on rocks, wheels, body and the
// station, and rubs there. Inside the cone, from the last mass before the mouth to the anchor, it
// is the massless tether over lip and throat; with the arm's tip in the mouth it is that alone.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/axel/rover_body.h"
#include "sim/axel/station_body.h"
#include "sim/axel/tether.h"
#include "sim/cable/cable.h"

namespace dockyard::axel {

/// Where and what the tether is tied to in this step.
struct TetherPlace {
  Pose3 X_GM;                                      // the cone's mouth
  Eigen::Vector3d p_GT{0, 0, 0}, v_GT_G{0, 0, 0};  // arm's tip
};

class CableTether {
 public:
  /// rocks: at rest, in the site frame.
  CableTether(const RoverModel& rover, const StationModel& station,
              const std::vector<ConvexBody>& rocks);

  /// Lays it from the tip to the anchor round all that is in the way, slack_m longer than its way,
  /// and lets it come to rest while rover and station stand still. Returns its unstretched length.
  double TieUp(const RoverBody& rover, const StationBody& station, const HeightGrid& ground,
               const Eigen::Vector3d& gravity_G, double slack_m);

  /// One step with free_m of unstretched tether outside the arm; adds its forces to rover and
  /// station and returns the tension at the tip [N].
  double Step(const HeightGrid& ground, const Eigen::Vector3d& gravity_G, double free_m,
              double free_rate_m_s, double step_s, RoverBody& rover, StationBody& station);

  double tension_n() const { return tension_n_; }
  double path_m(const RoverBody& rover) const;
  double fastest_m_s() const { return cable_.fastest_m_s(); }
  /// Tip first, anchor last.
  std::vector<Eigen::Vector3d> Line(const RoverBody& rover, const StationBody& station) const;
  /// For books that must close: all forces given to rover and station in the last step and the
  /// ground's on the tether [N], its momentum [kg m/s].
  const Eigen::Vector3d& force_given_G() const { return force_given_G_; }
  const Eigen::Vector3d& force_of_ground_G() const { return cable_.force_of_ground_G(); }
  const Eigen::Vector3d& force_of_air_G() const { return cable_.force_of_air_G(); }
  Eigen::Vector3d momentum_G() const { return cable_.momentum_G(); }
  double rest_m() const { return cable_.rest_m() + inner_.free_m(); }
  int masses() const { return cable_.masses(); }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  /// What carries a body of the cable's.
  enum class Carrier { kRover, kStation, kGround };
  struct Carried {
    Carrier by = Carrier::kGround;
    RoverLink link = RoverLink::kBody;
    Pose3 X_LB;
  };
  void AddBody(const CableBody& body, const Carried& carried);
  void AddShapes(const std::vector<Collision>& collisions, const Carried& carried, double friction);
  void PlaceBodies(const RoverBody& rover, const StationBody& station, bool still);
  void MoveEnds(const TetherPlace& place, const StationBody& station);
  double MouthAhead_m(const Eigen::Vector3d& p_M) const;
  CableStep MakeStep(const TetherPlace& place, const HeightGrid& ground,
                     const Eigen::Vector3d& gravity_G, double step_s) const;
  void Relax(const TetherPlace& place, const StationBody& station, const HeightGrid& ground);
  double PullDirectly(const TetherPlace& place, double free_m, double free_rate_m_s,
                      RoverBody& rover, StationBody& station);
  void GiveForces(const TetherPlace& place, const Eigen::Vector3d& gravity_G,
                  const TetherLoad& inner, RoverBody& rover, StationBody& station);
  void Give(RoverLink link, const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G,
            RoverBody& rover);
  void Give(const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G, StationBody& station);
  TetherPlace PlaceOf(const RoverBody& rover, const StationBody& station) const;

  TetherModel model_;
  double arm_length_m_ = 0.0, mouth_radius_m_ = 0.0, spacing_m_ = 0.0;
  Cable cable_;
  Tether inner_;
  std::vector<CableBody> bodies_;
  std::vector<Carried> carried_;  // by body
  double tension_n_ = 0.0;
  Eigen::Vector3d force_given_G_{0, 0, 0};
};

}  // namespace dockyard::axel
