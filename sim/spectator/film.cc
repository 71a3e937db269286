#include "sim/spectator/film.h"

#include <algorithm>

#include "controller/base/number_text.h"
#include "sim/spectator/belief_words.h"
#include "sim/spectator/canvas.h"

namespace dockyard {
namespace {

constexpr double kRounding_s = 1e-6;

std::string PhaseAt(const LoggedRun& run, double time_s) {
  std::string phase;
  for (const Timed<LoggedNote>& note : run.notes) {
    if (note.time_s <= time_s + kRounding_s && note.value.name == "phase") phase = note.value.text;
  }
  return phase;
}

/// The outcome, and what the judge says of it.
std::string OutcomeOf(const LoggedRun& run) {
  if (!run.outcome.is_object()) return "the log is cut short";
  const auto text = [&](const char* key) {
    const auto found = run.outcome.find(key);
    return found != run.outcome.end() && found->is_string() ? found->get<std::string>() : "";
  };
  const std::string note = text("failure_note");
  return text("outcome") + (note.empty() ? "" : ": " + note);
}

}  // namespace

Film::Film(const LoggedRun& run, const StageShapes& shapes, const OutsideOptions& options,
           StereoRenderer& renderer)
    : run_(run),
      view_(run, shapes, options, 0, run.times_s.empty() ? 0 : run.times_s.size() - 1, renderer),
      looks_(LooksOf(run)) {}

std::vector<std::string> Film::Caption(std::size_t sample) const {
  const double time_s = run_.times_s[sample];
  std::vector<std::string> lines{Fixed(time_s, 1) + " s  " + PhaseAt(run_, time_s)};
  if (run_.truth.contains("x_m")) lines.push_back("true: " + PoseWords(run_.truth, sample));
  const std::string believed = BelievedWords(run_, sample);
  if (!believed.empty()) lines.push_back("believed: " + believed);
  if (sample + 1 == run_.times_s.size()) lines.push_back(OutcomeOf(run_));
  return lines;
}

void Film::AddInsets(double time_s, RgbImage& frame) {
  const auto later = std::find_if(looks_.begin(), looks_.end(), [&](const Look& look) {
    return look.time_s > time_s + kRounding_s;
  });
  if (later == looks_.begin()) return;
  const auto at = static_cast<std::size_t>(later - looks_.begin()) - 1;
  const Look& look = looks_[at];
  if (shown_ != at) {
    shown_ = at;
    insets_.clear();
    for (std::size_t camera = 0; camera < run_.cameras.size(); ++camera) {
      const std::optional<RgbImage> picture = PictureOf(look, camera);
      if (!picture) continue;
      const int width = frame.width / 4;
      RgbImage inset = Resized(*picture, width);
      if (look.sighting != nullptr) {
        DrawMarks(inset, look.sighting->report, static_cast<int>(camera),
                  static_cast<double>(width) / picture->width);
      }
      DrawWords(inset, {1, 1},
                {run_.cameras[camera].name + ", " + Fixed(look.time_s, 1) + " s: " + WordOf(look)},
                frame.height / 45.0);
      insets_.push_back(std::move(inset));
    }
  }
  int x = frame.width;
  for (auto inset = insets_.rbegin(); inset != insets_.rend(); ++inset) {
    x -= inset->width + 6;
    PutInset(frame, {x, frame.height - inset->height - 6}, *inset);
  }
}

RgbImage Film::Frame(std::size_t sample) {
  RgbImage frame = view_.Image(sample);
  AddInsets(run_.times_s[sample], frame);
  DrawWords(frame, {6, 6}, Caption(sample), frame.height / 28.0);
  return frame;
}

}  // namespace dockyard
