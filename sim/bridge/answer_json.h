// JSON from a controller's program, which may be anything: its shape is checked before it is read,
// and nothing of it is repeated in a message.
#pragma once

#include <stdexcept>
#include <string>

#include "controller/io/belief.h"
#include "sim/base/json.h"

namespace dockyard {

/// The message is a sentence without the program's own text.
class AnswerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Objects and lists within each other, at most: a belief needs 2. Assumed, 4-100.
inline constexpr int kDeepestAnswer = 16;
/// Values of one belief, at most. Assumed, 64-4096.
inline constexpr std::size_t kMostValues = 256;
/// Bytes of a value's name, at most. Assumed, 32-256.
inline constexpr std::size_t kLongestName = 64;

/// Beyond it a pose is no place in any yard. Assumed, 1e3-1e9.
inline constexpr double kFarthestPose_m = 1e6;

/// An object. Throws AnswerError for text that is no JSON in UTF-8, is nested too deeply, or is no
/// object.
Json AnswerFrom(const std::string& text);

/// The number. Throws AnswerError for what is none or is not finite.
double NumberOf(const Json& json, const std::string& what);

/// On one line and in one direction: control characters become '?'. The text is UTF-8, as JSON's
/// is.
std::string WithoutControls(const std::string& text);

/// The pose and the values of a belief, where they are there. Throws AnswerError for a field of
/// another type, a number that is not finite, and too many, too long, empty or equal names.
void TakeNumbers(const Json& answer, Belief& belief);

}  // namespace dockyard
