// A system as a value: one kind of robot with its target, controllers, judge and commands.
// The program uses systems through this struct alone (sim/app/systems.cc lists them).
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/geometry/camera.h"
#include "controller/io/controller.h"
#include "models/read/load_board.h"
#include "models/read/load_cameras.h"
#include "sim/base/json.h"
#include "sim/log/column.h"
#include "sim/log/record.h"
#include "sim/run/camera_faults.h"
#include "sim/run/judge.h"
#include "sim/run/plant.h"
#include "sim/run/stage_shapes.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

class Keys;  // sim/scenario/keys.h

/// All parts of one run except its controller.
struct ReadyRun {
  std::unique_ptr<Plant> plant;
  std::unique_ptr<Judge> judge;
  Json nominal;  // the nominal parameters that the controller gets; no truth
  Tick control_period = 20;
  std::string success_word;  // the outcome that the task asks for; empty: the first success
  int motor_count = 0, camera_count = 0, switch_count = 0;
  std::vector<NamedSensor> sensors{};       // in the order of SensorFrame::values
  std::vector<CameraTimes> camera_times{};  // by camera; empty: they answer each ask at once
  // Names for the log, in the controller's order; nominal numbers. May be empty.
  std::vector<NamedMotor> motors{};
  std::vector<NamedCamera> cameras{};
};

/// Makes a new controller from the nominal parameters. Throws ConfigError when they are those of
/// another system.
struct ControllerEntry {
  std::string name;
  std::function<std::unique_ptr<Controller>(const Json& nominal)> make;
  std::string former_name{};  // that scenarios of earlier versions give it; empty: none
};

/// The kind of a file and, in a line, its content. `left_out` counts what the reader passes over,
/// by name.
struct FileCheck {
  std::string kind, summary;
  std::vector<std::string> warnings = {};
  std::map<std::string, int> left_out = {};
};

/// Gets the program's name as it was called, for help, and the words after the command's name,
/// --help among them; returns the exit code and throws like the program's commands.
using CommandFunction =
    std::function<int(const std::string& program, const std::vector<std::string>& words)>;

/// An option of a command, for the shells that complete it.
struct CommandOption {
  std::string name;  // "--json"
  std::string meaning;
  bool takes_value = false;
};

/// A command of the system's own: `dockyard NAME ...`.
struct SystemCommand {
  std::string name, help;
  CommandFunction run;
  std::vector<CommandOption> options = {};
};

/// A published experiment that the system reproduces.
struct Reproduction {
  std::string name;     // of the paper and its year
  std::string file;     // what it says, and the campaigns (sim/plan/published.h)
  std::string meaning;  // a sentence: what is run, and where it differs from the paper
};

/// Files of the system's for the examples in the program's help, as written on the command line. A
/// line of help whose file is empty is left out. `dockyard doctor` draws the scenario's start.
struct ExampleFiles {
  std::string scenario, campaign, sweep, robot, target, cameras;
  std::string reproduction;  // a name of System::reproductions
  std::string start_images;  // StartImages() of the scenario on Debian 12; empty: not known
};

/// The outcomes of a system's runs, and the numbers that it states.
struct StatedColumns {
  std::vector<OutcomeName> outcomes;
  std::vector<Column> channels{}, beliefs{};
  std::vector<Column> measures{};  // of the judge, and last the limits' (WithMargins)
};

/// The keys of a kind of model files, for its schema.
struct ModelKeys {
  std::string kind;  // "robot"
  std::function<void(Keys&)> visit;
};

/// What the program asks of a system's model files. Each function returns none for a file of
/// another kind and throws ConfigError for a bad one. Empty: the system has no such files.
struct FileReaders {
  /// The kind of a robot's or a target's file.
  std::function<std::optional<FileCheck>(const std::string& yaml_file)> check{};
  /// The nominal stereo cameras of a robot's file, for images of that size (0: as in the file).
  std::function<std::optional<StereoRig>(const std::string& robot_file, int width, int height)>
      rig{};
  /// The nominal cameras of a robot's file by name, in the robot's frame with its joints at their
  /// starts, where they are no stereo pair.
  std::function<std::optional<std::vector<PlacedCamera>>(const std::string& robot_file)> cameras{};
  /// The fiducial board in a target's file.
  std::function<std::optional<NamedBoard>(const std::string& target_file)> board{};
  std::vector<ModelKeys> keys{};
};

struct System {
  std::string name;                          // the key `system` of a scenario
  std::vector<ControllerEntry> controllers;  // the first is the default
  KnownSystem scenario;  // what a scenario of it may have; name and controllers are those above
  StatedColumns columns;

  /// Reads the system's own keys and all models that the scenario names; returns a line that
  /// describes the system. Throws ConfigError.
  std::function<std::string(const Scenario&)> check;
  /// What is odd about the models that the scenario names, each with its place; `check` and `run`
  /// warn of it. Throws ConfigError. Empty: nothing is.
  std::function<std::vector<std::string>(const Scenario&)> doubts{};
  /// Throws ConfigError.
  std::function<ReadyRun(const Scenario&)> make_ready;
  /// Open-loop commands in place of a controller, from the scenario's `script`. Throws ConfigError.
  /// Empty: the system has none.
  std::function<std::unique_ptr<Controller>(const Json& nominal, const YamlNode& script)> play;
  /// What a spectator sees of a run. Throws ConfigError. Empty: it cannot be shown.
  std::function<StageShapes(const Scenario&)> shapes;
  /// The images at the start pose with the truth beside them, into a folder. Empty: it has none.
  std::function<void(const Scenario&, const std::filesystem::path& dir)> view;
  FileReaders files;
  /// `dockyard detect` for a robot or a scenario of this system, whose perception is its own.
  /// Without `run`: the program's own, which locates boards of discs.
  SystemCommand detect;
  /// Names the keys under the system's own name, for the schema of its scenarios. Empty: the
  /// schema leaves them open.
  std::function<void(Keys&)> keys;
  std::vector<SystemCommand> commands;
  std::vector<Reproduction> reproductions;
  ExampleFiles example_files;

  RowColumns Columns(std::vector<std::string> labels) const;
  /// Throws ConfigError that names all.
  const ControllerEntry& RequireController(const std::string& controller) const;
};

/// The system of that name. Throws ConfigError that names all.
const System& FindSystem(const std::vector<System>& systems, const std::string& name);
/// The part of the systems that a scenario's reader needs.
std::vector<KnownSystem> KnownSystems(const std::vector<System>& systems);

}  // namespace dockyard
