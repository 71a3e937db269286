// Where the robot stands before the pyramid: sightings and belts in one estimate, with what both do
// not tell (gauge, turning centre, errors of the belts' readings, scale of the pictures' ranges) as
// states.
//
// Frame N: the robot's origin, turned half round: x out of the back. D, V: pyramid_finder.h.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <vector>

#include "controller/raposa/dockyard_options.h"
#include "controller/raposa/pyramid_finder.h"

namespace dockyard::raposa {

/// What the belts' readings say of one control period.
struct BeltSteps {
  double left_m = 0.0, right_m = 0.0;  // counting up drives towards the arm, along -x_N
  bool driven = false;                 // readings of driven belts are off
  double gauge_m = 0.0;                // as told, for the arm's angle
  double arm_m = 0.0;                  // that the arm's belts rolled about its joint, either way
  double dt_s = 0.0;
};

/// Several poses are kept while the pictures allow several; each has an extended Kalman filter. The
/// log-likelihoods of what they foretold choose.
class PyramidFilter {
 public:
  PyramidFilter(const Nominal& nominal, const DockyardOptions& options);

  void Drive(const BeltSteps& steps);
  /// @param age_s  of the picture's exposure, before the last Drive's end
  void See(const PyramidSighting& sighting, double age_s);
  /// The pyramid may be elsewhere now. The lessons of belts and images stay.
  void Forget() { kept_.clear(); }
  /// Takes the camera to be at this angle about the axis of a guide that shows no marks, so that
  /// belts lead round it. 1 sigma of 30 deg.
  void Hypothesise(const GuideSighting& guide, double alpha_rad);

  bool located() const { return !kept_.empty(); }
  /// Whether the last image has a pose that agrees with the likeliest one.
  bool agrees() const { return !kept_.empty() && kept_.front().agrees; }
  /// Whether no other angle is almost as likely, such as that of the mirrored pose; located() must
  /// hold.
  bool one_angle() const;
  /// Of the likeliest; located() must hold.
  Pose2 X_DN() const;
  Eigen::Matrix3d covariance() const;  // of X_DN's x, y [m] and heading [rad]
  double gauge_share() const;          // turns by the told gauge that come about
  /// X_DN by one fit of a picture that was exposed age_s ago, carried to now by the belts.
  Pose2 PlacedBy(const PyramidFit& fit, double age_s) const;
  /// What the next picture should show.
  PyramidPrior Prior() const;
  /// The camera about the guide's axis, and its distance in plan.
  double alpha_rad() const;
  double range_m() const;
  /// Of the guide, left of the camera's axis.
  double bearing_rad() const;

 private:
  static constexpr int kStates = 8;
  using State = Eigen::Matrix<double, kStates, 1>;
  using StateMatrix = Eigen::Matrix<double, kStates, kStates>;
  struct Kept {
    State mean = State::Zero();
    StateMatrix P = StateMatrix::Zero();
    double score = 0.0;
    bool agrees = false;  // with the last image
  };

  State Moved(const State& state, const BeltSteps& steps, double share) const;
  Pose2 CameraIn(const State& state, double age_s) const;
  Eigen::Vector3d Foretold(const State& state, double age_s) const;
  Kept Born(const PyramidFit& fit, double age_s) const;
  template <int Rows, class Model>
  double Update(Kept& kept, const Eigen::Matrix<double, Rows, 1>& measured,
                const Eigen::Matrix<double, Rows, Rows>& R, const Model& model, double gate) const;
  void Doubt(Kept* kept) const;
  void SeeFits(const PyramidSighting& sighting, double age_s);
  void SeeGuide(const GuideSighting& guide, double age_s);
  void Order();

  Nominal nominal_;
  DockyardOptions options_;
  Pose2 X_NV_;                    // the camera in plan
  std::vector<Kept> kept_;        // the likeliest first
  Kept learned_;                  // gauge, centre, biases and scale, as last known
  std::deque<BeltSteps> recent_;  // newest first
};

/// Whether one angle is likely alone, and to a sigma of sure_heading_rad.
bool SureOfAngle(const PyramidFilter& filter, const DockyardOptions& options);

}  // namespace dockyard::raposa
