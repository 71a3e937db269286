// Motion blur: the image of a moving camera is the mean of views over its exposure. No GL. All rows
// are exposed at once; for those of a rolling shutter see rolling_shutter.h.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "controller/geometry/camera.h"
#include "render/motion_blur.h"
#include "render/stereo_renderer.h"

namespace dockyard {

/// Displacement in the image [px] of a thing at distance_m > 0 while the shutter is open, at most:
/// those by the camera's turning and by its travel add up. Of the middle of the image, in a
/// pinhole's small angles.
double MotionInExposure_px(const Camera& camera, double turn_rad_s, double speed_m_s,
                           double distance_m, double exposure_s);

/// How finely an exposure is divided. Of a sharp lens: a box of 0.25 px would widen the 0.6 px of
/// lens and pixel by 0.7 %.
struct ShutterSteps {
  double sharp_px = 0.25;  // below this motion one view is enough
  double step_px = 0.5;    // from view to view, at most
};
/// Of a lens that blurs by a Gauss law of sigma_px: no more than is needed under that blur. The
/// same share of it is sharp, and views 1.5 sigma apart leave a ripple of exp(-2 (pi / 1.5)^2),
/// 0.015 %. Never finer than those of a sharp lens.
ShutterSteps StepsUnderBlur(double sigma_px);

/// When views are taken whose mean stands for an exposure in which the image moves by motion_px:
/// times about the exposure's middle, as shares of it. They are evenly spaced, no further apart
/// than the step (16 at most), and their mean square is that of the exposure, 1/12: a spot is
/// widened by as much as by a box of motion_px.
std::vector<double> ExposureMoments(double motion_px, const ShutterSteps& steps = {});

/// A body's pose after some time at these speeds, of its origin and about it.
Pose3 MovedOn(const Pose3& X_WB, const Eigen::Vector3d& v_WB_W, const Eigen::Vector3d& w_WB_W,
              double seconds);

/// Where a camera is at these moments, for StereoRenderer::RenderThrough. X_WC: at the exposure's
/// middle; v_WC_W: of its origin [m/s]; w_WC_W: [rad/s].
std::vector<Pose3> PosesInExposure(const Pose3& X_WC, const Eigen::Vector3d& v_WC_W,
                                   const Eigen::Vector3d& w_WC_W, double exposure_s,
                                   double motion_px, const ShutterSteps& steps = {});

using StereoRadiance = std::array<RadianceImage, 2>;
/// A pair of views for OverExposure. share: when, as a share of the exposure after its middle.
using ViewAt = std::function<StereoRadiance(double share, bool with_depth)>;

/// The mean of both views over an exposure in which the image moves by motion_px at most: one view
/// if that is below 0.25 px. Otherwise the exposure is cut into equal parts of 0.85 px at most (16
/// parts at most), each with one view at its middle that BlurByMotion widens by the part's motion.
/// So a spot is widened by as much as by a box, d^2/12, and one view serves the slow motions of a
/// docking. `motion` is that of the rig's body. Nothing but the camera is taken to move within a
/// part. The depths, which a lens with a focus needs, are means, too.
StereoRadiance OverExposure(double motion_px, const StereoRig& rig, const ExposureMotion& motion,
                            const ViewAt& view);

/// The same of one camera, as StereoRenderer::RenderGrey draws it. `motion` is the camera's own.
using OneViewAt = std::function<RadianceImage(double share, bool with_depth)>;
RadianceImage OverExposure(double motion_px, const Camera& camera, const ExposureMotion& motion,
                           const OneViewAt& view);

}  // namespace dockyard
