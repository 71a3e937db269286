#include "models/read/xacro.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

#include "models/read/config_error.h"
#include "models/read/run_program.h"
#include "models/read/text_file.h"
#include "models/read/urdf_rules.h"

namespace dockyard {
namespace {

// xacro is a Python program: 0.3 s and 40 MiB for a robot of 200 links.
constexpr WorkLimits kXacroLimits{.cpu_s = 60,
                                  .wall_s = 60.0,
                                  .memory_bytes = std::size_t{4} << 30,
                                  .answer_bytes = kMaxTextBytes};

std::string PlaceOf(const TiXmlElement& at) {
  return std::to_string(at.Row()) + ":" + std::to_string(at.Column());
}

/// Elements of files before xacro had a namespace.
bool IsOldMacro(const std::string& parent, const std::string& name) {
  static const std::set<std::string> old{"macro", "property", "include"};
  return parent == "robot" && old.count(name) > 0;
}

/// The last lines of what the program says, in which Python names the fault.
std::string EndOf(const std::string& text) {
  constexpr std::size_t kMost = 400;
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string::npos) return "it says nothing";
  return text.substr(end + 1 > kMost ? end + 1 - kMost : 0, std::min(kMost, end + 1));
}

}  // namespace

bool IsXacroFile(const std::string& file) {
  return std::filesystem::path(file).extension() == ".xacro";
}

std::optional<Macro> FindMacro(const TiXmlElement& element) {
  for (const TiXmlAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
    const std::string value = a->Value();
    const std::size_t at = std::min(value.find("${"), value.find("$("));
    if (at != std::string::npos) return Macro{value.substr(at, 60), PlaceOf(element)};
  }
  const std::string parent = element.Value();
  for (const TiXmlElement* e = element.FirstChildElement(); e; e = e->NextSiblingElement()) {
    if (IsLeftOutOfUrdf(parent, *e)) continue;
    const std::string name = e->Value();
    if (name.rfind("xacro:", 0) == 0 || IsOldMacro(parent, name)) {
      return Macro{"<" + name + ">", PlaceOf(*e)};
    }
    if (const auto inner = FindMacro(*e)) return inner;
  }
  return std::nullopt;
}

std::string HowToExpand(const std::string& file) {
  const std::filesystem::path path(file);
  std::filesystem::path expanded = path.stem();
  if (!IsXacroFile(file)) expanded += "_expanded";
  if (expanded.extension() != ".urdf") expanded += ".urdf";
  return "expand the file by hand: xacro " + file + " > " +
         (path.parent_path() / expanded).string();
}

std::string ExpandXacro(const std::string& file, const std::string& place) {
  ReadText(file);  // a file that is missing or no text is not xacro's to explain
  const auto program = FindProgram("xacro");
  if (!program) {
    throw ConfigError(
        place +
        "only the program xacro expands it, and none is on PATH; install it (with ROS: "
        "package xacro; without: pip install xacro), or " +
        HowToExpand(file) + " where it is");
  }
  ProgramEnd end;
  try {
    // Before an argument it would take "-o" or "a:=1" for one of its own.
    const std::string written = std::filesystem::absolute(file).string();
    end = RunProgram(*program, {written}, kXacroLimits);
  } catch (const std::system_error& error) {
    throw ConfigError(file + ": xacro " + error.what());
  }
  if (!end.failure.empty()) {
    throw ConfigError(file + ": xacro " + end.failure + ": " + EndOf(end.err));
  }
  if (end.out.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw ConfigError(file + ": xacro printed no URDF: " + EndOf(end.err));
  }
  CheckIsText(end.out, file + " (expanded)");
  return end.out;
}

}  // namespace dockyard
