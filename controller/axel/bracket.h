// More exposures of one sight, where a single one does not hold the board.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/options.h"
#include "controller/vision/board/exposure_merge.h"
#include "controller/vision/board/locate.h"

namespace dockyard::axel {

/// A part of an image, in whole pixels; the ends are not in it.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// Share of the box's squares that are too dark or too bright for a mark; 0 for an empty box.
double NotHeldShare(const GrayImage& image, const PixelBox& box, int square_px,
                    const BracketOptions& options);

/// One bracket a stop, at most: the pair that was taken first, one with less and one with more
/// light. It begins when a pair does not show the board, or by one camera only, and a camera that
/// does not see it has areas that its exposure does not hold.
class Bracket {
 public:
  Bracket(const BracketOptions& options, const Nominal& nominal)
      : options_(options), nominal_(nominal) {}

  /// A new stop: what was under way is dropped.
  void NewStop();
  /// Whether the pair, as seen, begins a bracket; keeps it then.
  bool Begins(const StereoImages& images, const LocateOutput& seen, const LocateHints& hints);
  bool under_way() const { return first_.has_value() && next_ < kExposures; }
  /// The exposure to ask for [stops].
  double stops() const;
  /// The pictures that came for that; null for a camera that gave none.
  void Take(const GrayImage* left, const GrayImage* right);
  /// No more pictures are waited for.
  void Stop() { next_ = kExposures; }
  /// Whether any picture came beside the first pair.
  bool HasMore() const { return more_; }
  StereoImages Merged() const;
  /// The first pair as seen, or the merged one, if there is one and it shows more.
  LocateOutput Better(const std::optional<LocateOutput>& merged) const;

 private:
  static constexpr std::size_t kExposures = 2;  // beside the first

  bool NotHeld(const GrayImage& image, const Camera& camera, const Pose3& X_RC,
               const std::optional<Pose3>& X_RB) const;
  std::optional<PixelBox> BoardBox(const Camera& camera, const Pose3& X_CB) const;

  BracketOptions options_;
  Nominal nominal_;
  bool used_ = false, more_ = false;
  std::optional<LocateOutput> first_;
  std::size_t next_ = 0;
  std::array<std::vector<ExposedImage>, 2> pictures_;  // left, right
};

}  // namespace dockyard::axel
