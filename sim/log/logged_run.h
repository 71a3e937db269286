// A run's log as a spectator needs it: truth, belief, sightings and images over time. It is read
// for pictures and reports; the controller's frames are read by RunLogReader.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "controller/io/belief.h"
#include "sim/base/json.h"
#include "sim/log/run_log.h"
#include "sim/log/stage.h"

namespace dockyard {

/// Times are seconds since power-on, and do not fall.
template <class T>
struct Timed {
  double time_s = 0.0;
  T value;
};

/// Values of one name, over the samples.
using Series = std::map<std::string, std::vector<double>>;

/// The bytes of a PNG; of a log that keeps some of the images alone of a WebP, for people.
struct LoggedImage {
  std::string camera, bytes;
};

/// All heights of the ground, or those that changed.
struct LoggedGround {
  double x0_m = 0.0, y0_m = 0.0, cell_m = 0.0, step_m = 0.0;
  std::uint32_t nx = 0, ny = 0;
  std::vector<std::uint32_t> cells;   // places of the heights; empty: all, row by row
  std::vector<std::int16_t> heights;  // [step_m]
};

/// As its nominal parameters have it; the frame is its name.
struct LoggedCamera {
  std::string name;
  std::uint32_t width = 0, height = 0;
};

struct LoggedNote {
  std::string name, text;
};

struct LoggedRun {
  RunLogHeader header;
  Json outcome;  // null: the run was cut short
  bool complete = false;
  std::vector<double> times_s;                          // of the samples
  std::vector<std::string> body_names;                  // the robot's body first
  std::vector<std::vector<Pose3>> X_WO;                 // by body, by sample
  std::vector<Pose3> X_WD, X_WG;                        // target's frame, site; by sample
  std::map<std::string, std::vector<StageLine>> lines;  // by name, by sample
  Series truth, belief, sensors;                        // sensors as the controller got them
  Series currents_a;                                    // by motor, as read
  Series values;                                        // of a belief, NaN where there is none
  std::vector<SightingSample> sightings;                // without the camera's turn
  std::vector<Timed<std::vector<Pose2>>> plans;         // poses along the way, in D
  std::vector<Timed<LoggedNote>> notes;
  std::vector<LoggedCamera> cameras;  // by index
  std::vector<Timed<LoggedImage>> images;
  std::vector<Timed<LoggedGround>> ground;

  /// The first sample at or after a time, else the last. There must be one.
  std::size_t SampleAt(double time_s) const;
  /// What a camera took at that time; null: there is no such image in the log.
  const LoggedImage* ImageAt(const std::string& camera, double time_s) const;
};

/// Throws IoError, and DataError for a damaged log. One that is cut short gives what it has.
LoggedRun ReadLoggedRun(const Folder& dir);

}  // namespace dockyard
