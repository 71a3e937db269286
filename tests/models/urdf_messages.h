// What the reader says about short URDF files.
#pragma once

#include <string>

#include "models/read/urdf.h"
#include "support/bad_files.h"

namespace dockyard {

/// About a file m.urdf of this text, next to a good mesh.obj.
inline std::string UrdfMessage(const std::string& text) {
  const ScratchFolder folder;
  folder.Write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string file = folder.Write("m.urdf", text);
  return MessageOf([&] { LoadUrdf(file); }, folder);
}

/// A robot of one link with this inside.
inline std::string LinkUrdf(const std::string& inside) {
  return "<robot name=\"m\">\n <link name=\"a\">" + inside + "</link>\n</robot>\n";
}

inline std::string VisualUrdf(const std::string& geometry) {
  return LinkUrdf("<visual><geometry>" + geometry + "</geometry></visual>");
}

/// About a robot of these elements, in line 2.
inline std::string RobotMessage(const std::string& inside) {
  return UrdfMessage("<robot name=\"m\">\n" + inside + "\n</robot>\n");
}

}  // namespace dockyard
