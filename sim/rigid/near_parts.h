// Which of many convex parts are near each other: Bullet's collision world sorts their boxes, and
// GJK measures how far apart two are. Contacts between near parts are found elsewhere, exactly.
#pragma once

#include <memory>
#include <vector>

#include "sim/rigid/convex_body.h"

namespace dockyard {

/// Two parts by their numbers, the lower one first.
struct NearPair {
  int a = 0, b = 0;
};

/// Which parts may meet: `group` is a bit of this part, `meets` has the bits of the others. Both
/// must want to meet.
struct PartGroups {
  int group = 1, meets = 1;
};

class NearParts {
 public:
  /// within_m: pairs that are nearer than this count as near; > 0.
  explicit NearParts(double within_m);
  ~NearParts();

  /// Returns the number.
  int Add(const ConvexBody& body_L, const Pose3& X_GL, const PartGroups& groups);
  /// Where a part is now.
  void Place(int part, const Pose3& X_GL);
  /// All pairs that touch, and others that are near, in order. They are searched anew once two
  /// parts may have come nearer by within_m since the last search.
  const std::vector<NearPair>& Find();
  long searches() const { return searches_; }

 private:
  struct Part;
  struct BulletSide;
  void Search();

  double within_m_ = 0.0;
  std::unique_ptr<BulletSide> bullet_;
  std::vector<std::unique_ptr<Part>> parts_;
  std::vector<NearPair> pairs_;
  bool searched_ = false;
  long searches_ = 0;
};

}  // namespace dockyard
