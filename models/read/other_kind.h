// Refusals of a robot, a target or a ground that is of another kind: where to go on.
#pragma once

#include <string>
#include <type_traits>

#include "models/read/config_error.h"

namespace dockyard {

/// The message with advice at its end, if it names a key or a link that things of this kind do
/// not have; else as it is. A misspelt name, for which the message has a likely one, gets no
/// advice.
/// @param what  "robot", "target", "ground"
std::string WithOtherKind(const std::string& message, const std::string& what);
/// The same with advice of one's own.
std::string WithAdvice(const std::string& message, const std::string& advice);

/// Calls `read`; its ConfigErrors have the advice.
template <class Read>
std::invoke_result_t<Read> AdvisingOtherKinds(const std::string& what, const Read& read) {
  try {
    return read();
  } catch (const ConfigError& error) {
    throw ConfigError(WithOtherKind(error.what(), what));
  }
}
template <class Read>
std::invoke_result_t<Read> Advising(const std::string& advice, const Read& read) {
  try {
    return read();
  } catch (const ConfigError& error) {
    throw ConfigError(WithAdvice(error.what(), advice));
  }
}

}  // namespace dockyard
