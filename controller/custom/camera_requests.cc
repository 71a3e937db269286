#include "controller/custom/camera_requests.h"

#include <algorithm>
#include <cmath>

namespace dockyard::custom {
namespace {

// More images than ten a second tell little more, as the robot has hardly moved. Assumed, 5-30.
constexpr double kLeastPeriod_s = 0.1;
// A request is answered within its latency and this, or is repeated. Assumed, 0.3-2 s, 3-10 times.
constexpr double kWait_s = 0.5;
constexpr int kMostAsks = 6;

Tick Ticks(double seconds) { return static_cast<Tick>(std::llround(seconds / kTickSeconds)); }

}  // namespace

CameraRequests::CameraRequests(const Nominal& nominal, const std::vector<int>& cameras)
    : cameras_(cameras), requests_(cameras.size()), next_(cameras.size(), 0) {
  for (const int camera : cameras) {
    const RobotCamera& own = nominal.cameras[static_cast<std::size_t>(camera)];
    period_.push_back(Ticks(std::max(own.period_s, kLeastPeriod_s)));
    patience_.push_back(
        {.wait = Ticks(kWait_s + own.latency_s + own.period_s), .most_asks = kMostAsks});
  }
}

void CameraRequests::Read(const SensorFrame& sensed) {
  for (const CameraImage& image : sensed.images) {
    const auto found = std::find(cameras_.begin(), cameras_.end(), image.camera);
    if (found == cameras_.end()) continue;
    ImageRequest& request = requests_[static_cast<std::size_t>(found - cameras_.begin())];
    if (Answers(request, image.exposed)) request = {};
  }
}

void CameraRequests::AskDue(Tick now, Commands* commands) {
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    if (now < next_[i] || StateOf(requests_[i], patience_[i], now) != RequestState::kDue) continue;
    Commands one;
    Ask({cameras_[i]}, now, &requests_[i], &one);
    commands->take_images.push_back(cameras_[i]);
    next_[i] = now + period_[i];
  }
}

bool CameraRequests::unanswered(Tick now) const {
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    if (StateOf(requests_[i], patience_[i], now) != RequestState::kUnanswered) return false;
  }
  return true;
}

void CameraRequests::Restart() {
  for (ImageRequest& request : requests_) request = {};
}

}  // namespace dockyard::custom
