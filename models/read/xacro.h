// Macros of xacro, in which ROS writes its URDF files. Only the program of that name expands them.
#pragma once

#include <tinyxml.h>

#include <optional>
#include <string>

namespace dockyard {

/// Whether the name of the file says that it holds macros: it ends in .xacro.
bool IsXacroFile(const std::string& file);

/// The first macro or argument among what is read of a URDF: an element such as <xacro:wheel> or
/// the older <macro>, or an attribute with ${...} or $(...), as written; with its place
/// "line:column". None for an expanded file.
struct Macro {
  std::string text, place;
};
std::optional<Macro> FindMacro(const TiXmlElement& robot);

/// The sentence that says how to expand the file by hand.
std::string HowToExpand(const std::string& file);

/// What `xacro FILE` prints. Throws ConfigError: no such program on PATH, with the command to type
/// where there is one; what it says about the file; more than 60 s.
/// @param place  what the first message begins with: the macro's place, and what it is
std::string ExpandXacro(const std::string& file, const std::string& place);

}  // namespace dockyard
