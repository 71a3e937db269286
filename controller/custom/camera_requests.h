// Images of the cameras that show the dock, each as often as it can give them.
#pragma once

#include <vector>

#include "controller/custom/nominal/nominal.h"
#include "controller/imaging/image_request.h"

namespace dockyard::custom {

class CameraRequests {
 public:
  CameraRequests(const Nominal& nominal, const std::vector<int>& cameras);

  /// Takes note of the frame's images.
  void Read(const SensorFrame& sensed);
  /// Asks every camera whose image is due.
  void AskDue(Tick now, Commands* commands);
  /// Whether all cameras left all requests unanswered.
  bool unanswered(Tick now) const;
  /// New requests may be asked for again.
  void Restart();
  const std::vector<int>& cameras() const { return cameras_; }

 private:
  std::vector<int> cameras_;
  std::vector<Tick> period_;             // of each of them
  std::vector<ImagePatience> patience_;  // with each of them
  std::vector<ImageRequest> requests_;   // of each of them
  std::vector<Tick> next_;               // earliest next request to each of them
};

}  // namespace dockyard::custom
