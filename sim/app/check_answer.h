// What `dockyard check` found in its files, as JSON.
#pragma once

#include <string>
#include <vector>

#include "sim/run/system.h"

namespace dockyard {

/// A message "file:line:col: text" in its parts. Without a line or a column these are 0.
struct PlacedFault {
  std::string file;
  int line = 0, column = 0;
  std::string text;
};

/// @param checked  the file to name for a message without one
PlacedFault PlaceOf(const std::string& message, const std::string& checked);

struct CheckedFile {
  std::string file;
  FileCheck check;                  // empty where there are faults
  std::vector<std::string> faults;  // messages
};

/// {files: [{file, kind, summary, faults, left_out, warnings}], faults, left_out, warnings}: the
/// last three over all files. A fault is {file, line, column, text}; line and column are null where
/// the message has none. Bytes that are no UTF-8, as in a file's name, are replaced.
std::string CheckAnswer(const std::vector<CheckedFile>& files,
                        const std::vector<std::string>& warnings);

}  // namespace dockyard
