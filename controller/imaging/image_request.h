// Asking cameras for images. Cameras may be slow or fail, so a request is awaited and repeated.
#pragma once

#include <optional>
#include <vector>

#include "controller/io/commands.h"

namespace dockyard {

/// By which an image's stamp may be off the controller's clock. Assumed, 20-100 ms.
inline constexpr Tick kMostStampError = 50;

/// How long an answer is awaited, and how often cameras are asked for one.
struct ImagePatience {
  Tick wait = 0;         // then they are asked again; > 0
  int most_asks = 1;     // in a row without an answer
  bool doubles = false;  // each wait is twice as long as the one before
};

/// Images that are awaited, if any.
struct ImageRequest {
  std::optional<Tick> asked{};  // the last time, if an answer is awaited
  int asks = 0;                 // in a row without an answer
};

/// Of the present ask.
Tick WaitOf(const ImageRequest& request, const ImagePatience& patience);

enum class RequestState {
  kDue,  // ask now
  kAwaited,
  kUnanswered,  // asked as often as allowed, and the last wait is over
};
RequestState StateOf(const ImageRequest& request, const ImagePatience& patience, Tick now);

void Ask(const std::vector<int>& cameras, Tick now, ImageRequest* request, Commands* commands);

/// Whether an image with that stamp was exposed since the last ask, as far as its clock is right.
bool Answers(const ImageRequest& request, Tick exposed);
/// Whether the frame's first image does.
bool IsAnswered(const ImageRequest& request, const SensorFrame& sensed);

}  // namespace dockyard
