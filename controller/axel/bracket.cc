#include "controller/axel/bracket.h"

#include <algorithm>

namespace dockyard::axel {
namespace {

enum class Square { kHeld, kDark, kBright };

Square Judge(const GrayImage& image, const PixelBox& box, const BracketOptions& options) {
  int lit = 0, saturated = 0;
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const int z = image.at(x, y);
      if (z >= options.dim) ++lit;
      if (z >= options.saturated) ++saturated;
    }
  }
  const double count = (box.right - box.left) * (box.bottom - box.top);
  if (saturated >= options.saturated_share * count) return Square::kBright;
  return lit < options.bright_share * count ? Square::kDark : Square::kHeld;
}

/// A camera that gives a picture without any light is dead, or it is night: no exposure helps.
bool AnyLight(const GrayImage& image, const BracketOptions& options) {
  return std::any_of(image.pixels.begin(), image.pixels.end(),
                     [&](std::uint8_t z) { return z >= options.dim; });
}

bool IsWhole(const GrayImage& image) {
  return image.width > 0 && image.height > 0 &&
         image.pixels.size() == static_cast<std::size_t>(image.width) * image.height;
}

}  // namespace

double NotHeldShare(const GrayImage& image, const PixelBox& box, int square_px,
                    const BracketOptions& options) {
  int squares = 0, not_held = 0;
  for (int y = box.top; y + square_px <= box.bottom; y += square_px) {
    for (int x = box.left; x + square_px <= box.right; x += square_px) {
      ++squares;
      const PixelBox square{x, y, x + square_px, y + square_px};
      if (Judge(image, square, options) != Square::kHeld) ++not_held;
    }
  }
  return squares == 0 ? 0.0 : static_cast<double>(not_held) / squares;
}

void Bracket::NewStop() {
  used_ = more_ = false;
  first_.reset();
  next_ = 0;
  pictures_ = {};
}

bool Bracket::Begins(const StereoImages& images, const LocateOutput& seen,
                     const LocateHints& hints) {
  if (used_ || nominal_.vision.bracket_stops <= 0.0) return false;
  if (seen.sighting && seen.sighting->stereo) return false;
  const std::optional<Pose3> X_RB =
      seen.sighting ? std::optional(seen.sighting->X_RB) : hints.X_RB_expected;
  const bool left = seen.report.method != "left" &&
                    NotHeld(images.left, nominal_.rig.left, nominal_.rig.X_RL, X_RB);
  const bool right = seen.report.method != "right" &&
                     NotHeld(images.right, nominal_.rig.right, nominal_.rig.X_RQ, X_RB);
  if (!left && !right) return false;
  used_ = true;
  first_ = seen;
  pictures_ = {std::vector{ExposedImage{images.left, 0.0}},
               std::vector{ExposedImage{images.right, 0.0}}};
  return true;
}

bool Bracket::NotHeld(const GrayImage& image, const Camera& camera, const Pose3& X_RC,
                      const std::optional<Pose3>& X_RB) const {
  const bool fits = image.width == camera.width && image.height == camera.height;
  if (!fits || !IsWhole(image) || !AnyLight(image, options_)) return false;
  const int square_px = std::max(4, static_cast<int>(options_.square_share * image.width));
  if (!X_RB) {
    const PixelBox whole{0, 0, image.width, image.height};
    return NotHeldShare(image, whole, square_px, options_) >= options_.share_of_picture;
  }
  const std::optional<PixelBox> box = BoardBox(camera, Inverse(X_RC) * *X_RB);
  if (!box) return false;
  const int board_px = static_cast<int>(options_.board_square_share * (box->right - box->left));
  return NotHeldShare(image, *box, std::max(4, board_px), options_) >= options_.share_at_board;
}

/// Where the image shows the board, with the margin; none if it does not show any of it.
std::optional<PixelBox> Bracket::BoardBox(const Camera& camera, const Pose3& X_CB) const {
  const double half_x = (0.5 + options_.margin) * nominal_.board.width_m;
  const double half_y = (0.5 + options_.margin) * nominal_.board.height_m;
  Eigen::Vector2d least(camera.width, camera.height), most(0.0, 0.0);
  for (const double x : {-half_x, half_x}) {
    for (const double y : {-half_y, half_y}) {
      const Eigen::Vector3d p_C = X_CB * Eigen::Vector3d(x, y, 0.0);
      const std::optional<Eigen::Vector2d> pixel = camera.Project(p_C);
      if (!pixel || !pixel->allFinite()) return std::nullopt;
      least = least.cwiseMin(*pixel);
      most = most.cwiseMax(*pixel);
    }
  }
  least = least.cwiseMax(0.0);
  most = most.cwiseMin(Eigen::Vector2d(camera.width, camera.height));
  if (most.x() <= least.x() || most.y() <= least.y()) return std::nullopt;
  return PixelBox{static_cast<int>(least.x()), static_cast<int>(least.y()),
                  static_cast<int>(most.x()), static_cast<int>(most.y())};
}

double Bracket::stops() const { return (next_ == 0 ? -1.0 : 1.0) * nominal_.vision.bracket_stops; }

void Bracket::Take(const GrayImage* left, const GrayImage* right) {
  if (!under_way()) return;
  const auto add = [&](std::vector<ExposedImage>& pictures, const GrayImage& image) {
    // The stand-in of a picture that did not come, or a dead camera's: it says nothing of the
    // light.
    if (!AnyLight(pictures.front().image, options_)) pictures.clear();
    pictures.push_back({image, stops()});
  };
  if (left) add(pictures_[0], *left);
  if (right) add(pictures_[1], *right);
  more_ = more_ || left || right;
  ++next_;
}

StereoImages Bracket::Merged() const {
  return {MergeExposures(pictures_[0]), MergeExposures(pictures_[1])};
}

LocateOutput Bracket::Better(const std::optional<LocateOutput>& merged) const {
  const bool more = merged && merged->sighting && (merged->sighting->stereo || !first_->sighting);
  return more ? *merged : *first_;
}

}  // namespace dockyard::axel
