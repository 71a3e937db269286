#include "sim/drives/imu_clock.h"

#include <algorithm>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

// Of sums of spans of readings against a frame's time. Numerical.
constexpr double kRounding_s = 1e-6;

ImuSample Between(const ImuSample& a, const ImuSample& b, double share) {
  const auto turn = [](const ImuSample& of) {
    return Eigen::Quaterniond(ToRotation({of.roll_rad, of.pitch_rad, of.yaw_rad}));
  };
  const RollPitchYaw attitude = ToRollPitchYaw(turn(a).slerp(share, turn(b)).toRotationMatrix());
  return {attitude.roll, attitude.pitch, attitude.yaw, (1.0 - share) * a.rate_R + share * b.rate_R,
          (1.0 - share) * a.specific_force_R + share * b.specific_force_R};
}

}  // namespace

double ImuClock::age_s(double now_s) const { return std::max(0.0, offset_s_ + drift_ * now_s); }

ImuSample ImuClock::At(double time_s) const {
  if (time_s <= past_.front().first) return past_.front().second;
  for (std::size_t i = past_.size() - 1; i > 0; --i) {
    const auto& [before_s, before] = past_[i - 1];
    const auto& [after_s, after] = past_[i];
    if (time_s >= after_s) return after;
    if (time_s > before_s) {
      return Between(before, after, (time_s - before_s) / (after_s - before_s));
    }
  }
  return past_.front().second;
}

TrueImu ImuClock::Pass(const TrueImu& now, double now_s) {
  if (offset_s_ == 0.0 && drift_ == 0.0) return now;
  const double then_s = now_s - age_s(now_s);
  past_.emplace_back(now_s, now.sample);
  for (const InertialMean& reading : now.readings) {
    read_s_ += reading.span_s;
    waiting_.emplace_back(read_s_, reading);
  }
  TrueImu then(At(then_s));
  while (!waiting_.empty() && waiting_.front().first <= then_s + kRounding_s) {
    then.readings.push_back(waiting_.front().second);
    waiting_.pop_front();
  }
  while (past_.size() > 2 && past_[1].first <= then_s) past_.pop_front();
  return then;
}

}  // namespace dockyard
