// How a run can end, by the truth.
#pragma once

#include <string>
#include <vector>

#include "controller/io/commands.h"
#include "sim/custom/judge_keys.h"
#include "sim/custom/truth.h"
#include "sim/log/judged_limit.h"

namespace dockyard::custom {

enum class Outcome {
  kDocked,
  kPartlySeated,
  kContactLost,
  kCollided,
  kDockPushed,
  kTippedOver,
  kFalseDocked,
  kGaveUp,
  kTimeout
};

/// In the order of Outcome.
const std::vector<OutcomeName>& OutcomeNames();
const char* Name(Outcome outcome);

/// An electrical contact among the truth's, or null for an empty name.
const ContactTruth* Find(const Truth& truth, const std::vector<std::string>& names,
                         const std::string& name);

/// Whether a pose lies in a box; what the box does not name counts as in it.
bool Holds(const PoseBox& box, const Pose3& X_QP);
/// Whether the contact is as it is asked. contact: null where none is asked.
bool Holds(const ContactAsked& asked, const ContactTruth* contact);

/// What the truth says at the end.
struct EndOfRun {
  Verdict claimed = Verdict::kUnderWay;
  std::string phase, said;  // of the controller, and why it is in that phase; may be empty
  Truth truth;
  ContactTruth contact;  // that the judge asks for
  bool contact_asked = false;
  bool was_closed = false;           // at some time of the run
  bool held = false;                 // all conditions, for as long as is asked
  bool tried = false, kept = false;  // the trial, and what is asked in it
  std::string lost_in{};             // the first part of the trial in which it does not hold
};

struct Judged {
  Outcome outcome = Outcome::kTimeout;
  std::string note;
};

std::vector<JudgedLimit> LimitsOf(const EndOfRun& end, const JudgeKeys& keys);
Judged JudgeEnd(const EndOfRun& end, const JudgeKeys& keys);

}  // namespace dockyard::custom
