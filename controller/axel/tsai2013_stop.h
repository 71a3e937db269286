// A stop of the published controller: the tether is drawn taut, the body levelled, an image pair
// taken (Tsai et al., II and IV-A).
#pragma once

#include <optional>

#include "controller/axel/leg.h"
#include "controller/axel/nominal/tsai2013_options.h"
#include "controller/axel/senses.h"
#include "controller/geometry/image.h"
#include "controller/imaging/image_request.h"

namespace dockyard::axel {

class Tsai2013Stop {
 public:
  explicit Tsai2013Stop(const Nominal& nominal);

  enum class Status { kTightening, kLooking, kImages, kNoImages };

  /// Sets the commands of wheels and spool. After kImages or kNoImages the next call asks anew.
  Status Step(const Senses& senses, const SensorFrame& sensed, ArmLevel* arm, Commands* commands);
  /// Of the last kImages.
  const StereoImages& images() const { return images_; }

 private:
  bool Taut(const Senses& senses, Tick since_stop, Commands* commands);
  bool Level(const Senses& senses, ArmLevel* arm, Commands* commands);
  Status Look(const Senses& senses, const SensorFrame& sensed, Commands* commands);

  Nominal nominal_;
  Tsai2013Options options_;
  StillWatch still_;
  enum class Part { kTighten, kLevel, kLook };
  Part part_ = Part::kTighten;
  std::optional<Tick> stopped_at_, levelling_since_, looking_since_;
  ImageRequest request_;
  StereoImages images_;
};

}  // namespace dockyard::axel
