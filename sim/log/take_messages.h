// Messages of a run's log, taken out of CDR: the inverse of ros_messages.h. All throw DataError for
// data that do not fit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/log/logged_run.h"
#include "sim/mcap/cdr.h"

namespace dockyard {

// The smallest size of an item, for lists that lie about their length.
inline constexpr std::size_t kSmallestText = 5, kSmallestStamped = 64;

/// std_msgs/Header
struct TakenHeader {
  double time_s = 0.0;
  std::string frame;
};
TakenHeader TakeHeader(CdrReader& in);
Pose3 TakePose(CdrReader& in);

/// @param version  of the log: before 6 a pose had three numbers
SightingSample TakeSighting(CdrReader in, std::uint32_t version);
Timed<std::vector<Pose2>> TakePlan(CdrReader in);
Timed<LoggedNote> TakeNote(CdrReader in);
Timed<LoggedImage> TakeImage(CdrReader in);
LoggedCamera TakeCamera(CdrReader in);
Timed<LoggedGround> TakeGround(CdrReader in);
/// The first marker of an array of lines; none if the array has solids.
std::optional<StageLine> TakeLine(CdrReader in);
/// A value for each name, at the end of its series.
void TakeScalars(CdrReader in, Series& series);

}  // namespace dockyard
