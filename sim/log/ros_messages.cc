#include "sim/log/ros_messages.h"

#include <Eigen/Geometry>

#include "sim/log/pose_numbers.h"

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

std::string TransformsMessage(Tick tick, const std::vector<BodyPose>& bodies,
                              const std::vector<NamedCamera>& cameras) {
  CdrWriter out;
  out.Count(bodies.size() + cameras.size());
  const auto put = [&](const std::string& parent, const std::string& name, const Pose3& X) {
    PutHeader(out, tick, parent);
    out.Text(name);
    PutPose(out, X);
  };
  for (const BodyPose& body : bodies) put(kWorldFrame, body.name, body.X_WO);
  for (const NamedCamera& camera : cameras) put(camera.body, camera.name, camera.X_OC);
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

std::string BeliefPoseMessage(Tick tick, const Pose3& X_DR) {
  CdrWriter out;
  PutHeader(out, tick, kDockFrame);
  PutPose(out, X_DR);
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
  for (const RobotPose* X : {&sighting.X_DR, &sighting.X_DR_measured}) {
    for (const double value : PoseNumbers(*X)) out.Double(value);
  }
  return out.Take();
}

}  // namespace dockyard
