// Messages of a run's log in CDR; their fields are those of ros_schemas.h. Times are ticks of
// simulated time since power-on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "controller/io/belief.h"
#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "sim/log/record.h"
#include "sim/log/stage.h"
#include "sim/mcap/cdr.h"

namespace dockyard {

/// The nanoseconds of a tick.
std::uint64_t Nanoseconds(Tick tick);

// Frames of reference by name: the world, the target's frame D, the site's
// frame G, the robot's body R. A body of the
// stage is a frame of its own name, a camera one of its topic's.
inline constexpr const char* kWorldFrame = "world";
inline constexpr const char* kDockFrame = "dock";
inline constexpr const char* kGroundFrame = "ground";
inline constexpr const char* kRobotFrame = "robot";

// Parts of messages.

/// std_msgs/Header
void PutHeader(CdrWriter& out, Tick tick, std::string_view frame);
/// geometry_msgs/Vector3 or Point
void PutVector(CdrWriter& out, const Eigen::Vector3d& v);
/// geometry_msgs/Pose
void PutPose(CdrWriter& out, const Pose3& X);

// Whole messages.

/// tf2_msgs/TFMessage: the bodies in the world, and each camera in the body that carries it.
std::string TransformsMessage(Tick tick, const std::vector<BodyPose>& bodies,
                              const std::vector<NamedCamera>& cameras);
/// sensor_msgs/Imu; no covariances are known.
std::string ImuMessage(Tick tick, const ImuSample& imu);
/// sensor_msgs/JointState: angles [rad] since power-on, currents [A] as effort.
std::string MotorsMessage(Tick tick, const std::vector<NamedMotor>& names,
                          const std::vector<MotorReading>& motors);
/// sensor_msgs/CompressedImage
std::string ImageMessage(Tick tick, const std::string& frame, const std::string& format,
                         std::string_view bytes);
/// geometry_msgs/PoseWithCovarianceStamped in the frame `dock`; the covariance is not known.
std::string BeliefPoseMessage(Tick tick, const Pose3& X_DR);
/// nav_msgs/Path in the frame `dock`.
std::string PathMessage(Tick tick, const std::vector<Pose2>& X_DP);
/// rcl_interfaces/Log, level INFO. `name` is who says it.
std::string NoteMessage(Tick tick, const std::string& name, const std::string& text);
/// dockyard_msgs/Frame
std::string FrameMessage(Tick tick, std::string_view data);
/// dockyard_msgs/Commands
std::string CommandsMessage(Tick tick, const Commands& commands);
/// dockyard_msgs/Scalars
std::string ScalarsMessage(Tick tick, const std::vector<std::string>& names,
                           const std::vector<double>& values);
/// dockyard_msgs/Sighting; poses of the robot are their PoseNumbers.
std::string SightingMessage(Tick tick, const SightingSample& sighting);

}  // namespace dockyard
