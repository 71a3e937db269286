#include "sim/bridge/program_belief.h"

#include <utility>

#include "sim/bridge/answer_json.h"
#include "sim/log/value_table.h"

namespace dockyard {
namespace {

// Bytes of a phase or a note; assumed, 50-1000. Every sample of a history has its phase.
constexpr std::size_t kLongestPhase = 200;

/// On one line, and not too long: phases and notes go into logs, tables and onto terminals.
std::string ShortLine(const std::string& said) {
  std::string text = WithoutControls(said);
  if (text.size() <= kLongestPhase) return text;
  std::size_t end = kLongestPhase;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + " ...";
}

void TakeLine(const Json& json, const char* name, std::string& line) {
  const auto at = json.find(name);
  if (at == json.end()) return;
  if (!at->is_string()) throw AnswerError("a phase or note that is no text");
  line = ShortLine(at->get<std::string>());
}

void RequireAtMost(std::size_t count, std::size_t most, const char* what) {
  if (count <= most) return;
  throw AnswerError("more than " + std::to_string(most) + " " + what + " in one run");
}

}  // namespace

void ProgramBelief::Take(const Json& json) {
  TakeLine(json, "phase", belief_.phase);
  TakeLine(json, "note", belief_.note);
  TakeNumbers(json, belief_);
  TakeSightingParts(json, camera_count_, sighting_);
  if (!json.contains("values")) return;
  for (const NamedValue& each : belief_.values) value_names_.insert(each.name);
  RequireAtMost(value_names_.size(), kMostValueNames, "names of values");
}

void ProgramBelief::EndAnswer() {
  const SightingParts parts = std::exchange(sighting_, {});
  if (!parts.any()) return;
  belief_.last_sighting = ReportOf(parts, camera_count_);
  ++belief_.sighting_count;
  marks_ += belief_.last_sighting->marks.size();
  RequireAtMost(static_cast<std::size_t>(belief_.sighting_count), kMostSightings, "sightings");
  RequireAtMost(marks_, kMostMarksOfRun, "marks");
}

}  // namespace dockyard
