#include "sim/log/ros_messages.h"

#include <Eigen/Geometry>
#include <cmath>

namespace dockyard {
namespace {

constexpr std::int64_t kTicksPerSecond = 1000;
constexpr std::int64_t kNanosecondsPerTick = 1'000'000;

void PutTime(CdrWriter& out, Tick tick) {
  out.I32(static_cast<std::int32_t>(tick / kTicksPerSecond));
  out.U32(static_cast<std::uint32_t>(tick % kTicksPerSecond * kNanosecondsPerTick));
}

void PutRotation(CdrWriter& out, const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  for (const double part : {q.x(), q.y(), q.z(), q.w()}) out.Double(part);
}

void PutZeros(CdrWriter& out, int count) {
  for (int i = 0; i < count; ++i) out.Double(0.0);
}

void PutMarks(CdrWriter& out, const std::vector<SightingReport::Mark>& marks) {
  out.Count(marks.size());
  for (const SightingReport::Mark& mark : marks) {
    out.I32(mark.id);
    out.I32(mark.camera);
    out.Double(mark.u_px);
    out.Double(mark.v_px);
  }
}

/// A lens as ROS has it: its name, coefficients, focal lengths and centre.
struct RosLens {
  const char* model = "";
  std::vector<double> d;
  double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;
};

RosLens LensOf(const Camera& camera) {
  if (const auto* fish = std::get_if<KannalaBrandt>(&camera.lens)) {
    return {"equidistant", {fish->k.begin(), fish->k.end()}, fish->fx, fish->fy, fish->cx,
            fish->cy};
  }
  if (const auto* brown = std::get_if<BrownPinhole>(&camera.lens)) {
    return {"plumb_bob", {brown->k1, brown->k2, brown->p1, brown->p2, brown->k3},
            brown->fx,   brown->fy,
            brown->cx,   brown->cy};
  }
  if (const auto* rational = std::get_if<RationalPinhole>(&camera.lens)) {
    const auto& k = rational->k;
    return {"rational_polynomial", {k[0], k[1], rational->p1, rational->p2, k[2], k[3], k[4], k[5]},
            rational->fx,          rational->fy,
            rational->cx,          rational->cy};
  }
  const Eigen::Vector2d focal = camera.focal_px(), centre = camera.centre_px();
  return {"", {}, focal.x(), focal.y(), centre.x(), centre.y()};
}

}  // namespace

std::uint64_t Nanoseconds(Tick tick) {
  return static_cast<std::uint64_t>(tick * kNanosecondsPerTick);
}

void PutHeader(CdrWriter& out, Tick tick, std::string_view frame) {
  PutTime(out, tick);
  out.Text(frame);
}

void PutVector(CdrWriter& out, const Eigen::Vector3d& v) {
  for (int i = 0; i < 3; ++i) out.Double(v(i));
}

void PutPose(CdrWriter& out, const Pose3& X) {
  PutVector(out, X.p);
  PutRotation(out, X.R);
}

std::string TransformsMessage(Tick tick, const std::string& parent,
                              const std::vector<BodyPose>& bodies) {
  CdrWriter out;
  out.Count(bodies.size());
  for (const BodyPose& body : bodies) {
    PutHeader(out, tick, parent);
    out.Text(body.name);
    PutPose(out, body.X_WO);
  }
  return out.Take();
}

std::string ImuMessage(Tick tick, const ImuSample& imu) {
  CdrWriter out;
  PutHeader(out, tick, kRobotFrame);
  PutRotation(out, ToRotation({imu.roll_rad, imu.pitch_rad, imu.yaw_rad}));
  PutZeros(out, 9);
  PutVector(out, imu.rate_R);
  PutZeros(out, 9);
  PutVector(out, imu.specific_force_R);
  PutZeros(out, 9);
  return out.Take();
}

std::string MotorsMessage(Tick tick, const std::vector<NamedMotor>& names,
                          const std::vector<MotorReading>& motors) {
  CdrWriter out;
  PutHeader(out, tick, "");
  out.Count(names.size());
  for (const NamedMotor& motor : names) out.Text(motor.name);
  out.Count(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    out.Double(names[i].rad_per_count * static_cast<double>(motors.at(i).encoder_counts));
  }
  out.Count(0);  // velocities
  out.Count(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) out.Double(motors.at(i).current_a);
  return out.Take();
}

std::string ImageMessage(Tick tick, const std::string& frame, const std::string& format,
                         std::string_view bytes) {
  CdrWriter out;
  PutHeader(out, tick, frame);
  out.Text(format);
  out.Bytes(bytes);
  return out.Take();
}

std::string CameraInfoMessage(Tick tick, const std::string& frame, const Camera& camera) {
  const RosLens lens = LensOf(camera);
  CdrWriter out;
  PutHeader(out, tick, frame);
  out.U32(static_cast<std::uint32_t>(camera.height));
  out.U32(static_cast<std::uint32_t>(camera.width));
  out.Text(lens.model);
  out.Doubles(lens.d);
  for (const double k : {lens.fx, 0.0, lens.cx, 0.0, lens.fy, lens.cy, 0.0, 0.0, 1.0}) {
    out.Double(k);
  }
  for (const double r : {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}) out.Double(r);
  for (const double p :
       {lens.fx, 0.0, lens.cx, 0.0, 0.0, lens.fy, lens.cy, 0.0, 0.0, 0.0, 1.0, 0.0}) {
    out.Double(p);
  }
  for (int i = 0; i < 6; ++i) out.U32(0);  // no binning, the whole image
  out.Bool(false);
  return out.Take();
}

std::string BeliefPoseMessage(Tick tick, const Pose2& X_DR) {
  CdrWriter out;
  PutHeader(out, tick, kDockFrame);
  PutPose(out, FromGround(X_DR, 0.0));
  PutZeros(out, 36);
  return out.Take();
}

std::string PathMessage(Tick tick, const std::vector<Pose2>& X_DP) {
  CdrWriter out;
  PutHeader(out, tick, kDockFrame);
  out.Count(X_DP.size());
  for (const Pose2& X : X_DP) {
    PutHeader(out, tick, kDockFrame);
    PutPose(out, FromGround(X, 0.0));
  }
  return out.Take();
}

std::string NoteMessage(Tick tick, const std::string& name, const std::string& text) {
  constexpr std::uint8_t kInfo = 20;
  CdrWriter out;
  PutTime(out, tick);
  out.U8(kInfo);
  out.Text(name);
  out.Text(text);
  out.Text("");
  out.Text("");
  out.U32(0);
  return out.Take();
}

std::string FrameMessage(Tick tick, std::string_view data) {
  CdrWriter out;
  PutTime(out, tick);
  out.Bytes(data);
  return out.Take();
}

std::string CommandsMessage(Tick tick, const Commands& commands) {
  CdrWriter out;
  PutTime(out, tick);
  out.Count(commands.motors.size());
  for (const MotorCommand& motor : commands.motors) {
    out.U8(static_cast<std::uint8_t>(motor.mode));
    out.Double(motor.target);
    out.Double(motor.speed_limit_rad_s);
    out.Double(motor.accel_rad_s2);
    out.Double(motor.current_limit_a);
  }
  out.Count(commands.take_images.size());
  for (const int camera : commands.take_images) out.I32(camera);
  out.Bytes({reinterpret_cast<const char*>(commands.switches.data()), commands.switches.size()});
  out.U8(static_cast<std::uint8_t>(commands.verdict));
  return out.Take();
}

std::string ScalarsMessage(Tick tick, const std::vector<std::string>& names,
                           const std::vector<double>& values) {
  CdrWriter out;
  PutTime(out, tick);
  out.Count(names.size());
  for (const std::string& name : names) out.Text(name);
  out.Doubles(values);
  return out.Take();
}

std::string SightingMessage(Tick tick, const SightingSample& sighting) {
  const SightingReport& report = sighting.report;
  CdrWriter out;
  PutTime(out, tick);
  out.Bool(report.accepted);
  out.Text(report.reason);
  out.Text(report.method);
  out.Count(report.detected.size());
  for (const int count : report.detected) out.I32(count);
  PutMarks(out, report.marks);
  PutMarks(out, report.predicted);
  out.Double(report.reprojection_px);
  PutPose(out, report.X_RB);
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) out.Double(report.covariance(row, column));
  }
  for (const Pose2& X : {sighting.X_DR, sighting.X_DR_measured}) {
    for (const double value : {X.x, X.y, X.heading}) out.Double(value);
  }
  return out.Take();
}

}  // namespace dockyard
