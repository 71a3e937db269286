// Drives RAPOSA onto its pyramid by what its images show: manoeuvres to the axis, drives in, closes
// the doors, feels whether they hold the guide, and tries again where they do not.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/io/belief.h"
#include "controller/motion/path_follower.h"
#include "controller/raposa/belt_reader.h"
#include "controller/raposa/door_feel.h"
#include "controller/raposa/gate_plan.h"
#include "controller/raposa/guide_track.h"
#include "controller/raposa/phases.h"
#include "controller/raposa/pyramid_filter.h"
#include "controller/raposa/search.h"

namespace dockyard::raposa {

/// What is known before the next image.
struct ImageHints {
  double pitch_rad = 0.0;             // of the camera, down positive
  std::optional<PyramidPrior> prior;  // what it should show, if anything is known
  std::vector<RefutedThing> refuted;  // things that were taken for the guide and are not
};

class Pilot {
 public:
  Pilot(const Nominal& nominal, const DockyardOptions& options);

  /// @param seen   what was found in the frame's image; null: no image
  /// @param age_s  of its exposure
  Commands Step(const SensorFrame& sensed, const PyramidSighting* sighting, double age_s);
  ImageHints Hints() const;
  const Belief& belief() const { return belief_; }
  Phase phase() const { return here_.phase; }
  const PyramidFilter& filter() const { return filter_; }

 private:
  /// The present phase.
  struct Here {
    Phase phase = Phase::kLook;
    Tick entered = 0;
    double driven_m = 0.0, turned_aside_rad = 0.0;
    double back_m = 0.0;   // to drive back, in kBack
    int fits = 0;          // images with a pose ...
    int agreed = 0;        // ... that is the believed one
    bool glanced = false;  // to the first side
    double For(Tick now) const { return kTickSeconds * static_cast<double>(now - entered); }
  };
  /// What was tried already.
  struct Tries {
    int passes = 0, backs = 0, nudges = 0, attempts = 0;
    int acrosses = 0, elsewheres = 0;
    bool low = false;          // it leaned back to find a low guide
    bool crossing = false;     // it drives across the line of sight
    bool all_refuted = false;  // it has been all round, and every thing was refuted
    // Since the last plan to the axis, or since it went elsewhere.
    double searched_rad = 0.0;
    double from_start_rad = 0.0;  // turned since power-on, to the left
  };
  /// Commands that stay until they are changed.
  struct Kept {
    double arm_rad = 0.0, door_open_m = 0.0;
    bool lamps = false;
    Twist twist{};
  };
  /// Round a guide without marks.
  struct Round {
    double side = 0.0;          // left 1, right -1
    bool other_side = false;    // it has changed the side
    bool hypothetical = false;  // no image shows where the pyramid is
    double skip_rad = 0.0;      // still to turn from a thing that was not there
    double glance_side = 0.0;   // where it puts the guide in the view: left 1, right -1
  };

  void ReadDrives(const SensorFrame& sensed);
  void TakeImage(const PyramidSighting& sighting, double age_s);
  Twist Act();
  Twist Look();
  Twist Search();
  Twist Creep();
  Twist Glance();
  Twist Back();
  Twist Turn();
  Twist DriveLeg();
  Twist Face();
  Twist Approach();
  Twist Brake();
  Twist Close();
  Twist Ajar();
  Twist Prove();
  Twist Retreat();
  Twist TurnToAside();
  void Decide();
  void BeginLeg();
  void Refute(const std::string& why);
  void GoRound();
  void TryAgain(const std::string& why);
  void Enter(Phase phase, const std::string& note);
  bool Looks() const;

  Nominal nominal_;
  DockyardOptions options_;
  BeltReader belts_;
  PyramidFilter filter_;
  GuideTrack guide_;
  DoorFeel doors_;
  WideningSearch search_;
  RefutedPlaces refuted_;
  Tick now_ = 0;
  double turned_rad_ = 0.0;  // by the belts, since the last call
  Here here_;
  Tries tries_;
  Kept kept_;
  Round round_;
  std::vector<Leg> legs_;
  std::optional<PathFollower> follower_;
  double nudge_m_ = 0.0;
  Belief belief_;
};

}  // namespace dockyard::raposa
