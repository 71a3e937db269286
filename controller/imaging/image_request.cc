#include "controller/imaging/image_request.h"

#include "controller/base/check.h"

namespace dockyard {

Tick WaitOf(const ImageRequest& request, const ImagePatience& patience) {
  DOCKYARD_CHECK(patience.wait > 0);
  return patience.doubles && request.asks > 1 ? patience.wait << (request.asks - 1) : patience.wait;
}

RequestState StateOf(const ImageRequest& request, const ImagePatience& patience, Tick now) {
  if (request.asked && now - *request.asked < WaitOf(request, patience))
    return RequestState::kAwaited;
  return request.asks < patience.most_asks ? RequestState::kDue : RequestState::kUnanswered;
}

void Ask(const std::vector<int>& cameras, Tick now, ImageRequest* request, Commands* commands) {
  commands->take_images = cameras;
  request->asked = now;
  ++request->asks;
}

bool Answers(const ImageRequest& request, Tick exposed) {
  return request.asked && exposed >= *request.asked - kMostStampError;
}

bool IsAnswered(const ImageRequest& request, const SensorFrame& sensed) {
  return !sensed.images.empty() && Answers(request, sensed.images.front().exposed);
}

}  // namespace dockyard
