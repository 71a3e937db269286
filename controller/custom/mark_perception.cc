#include <utility>
#include <vector>

#include "controller/custom/sighting.h"

namespace dockyard::custom {
namespace {

/// Some of the dock's boards, as if the dock had no others.
struct SomeBoards {
  Nominal nominal;
  std::vector<int> numbers;  // of its boards among all
};

SomeBoards BoardsOf(const Nominal& nominal, bool of_discs) {
  SomeBoards some{nominal, {}};
  some.nominal.boards.clear();
  for (std::size_t i = 0; i < nominal.boards.size(); ++i) {
    const DockBoard& board = nominal.boards[i];
    if (board.board.fiducials.empty() == of_discs) continue;
    some.nominal.boards.push_back(board);
    some.numbers.push_back(static_cast<int>(i));
  }
  return some;
}

}  // namespace

Result<Perceive, Refusal> PerceiveMarks(const Nominal& nominal) {
  const SomeBoards discs = BoardsOf(nominal, true), tags = BoardsOf(nominal, false);
  if (tags.numbers.empty()) return PerceiveDiscs(nominal);
  if (discs.numbers.empty()) return PerceiveTags(nominal);
  const auto of_discs = PerceiveDiscs(discs.nominal), of_tags = PerceiveTags(tags.nominal);
  if (!of_discs) return of_discs.error();
  if (!of_tags) return of_tags.error();
  return Perceive([=, disc_numbers = discs.numbers, tag_numbers = tags.numbers](
                      const CameraImage& image, const Eigen::Vector3d& up_R) {
    std::vector<BoardSighting> sightings(disc_numbers.size() + tag_numbers.size());
    const auto take = [&](std::vector<BoardSighting> found, const std::vector<int>& numbers) {
      for (BoardSighting& sighting : found) {
        sighting.board = numbers[static_cast<std::size_t>(sighting.board)];
        sightings[static_cast<std::size_t>(sighting.board)] = std::move(sighting);
      }
    };
    take((*of_discs)(image, up_R), disc_numbers);
    take((*of_tags)(image, up_R), tag_numbers);
    return sightings;
  });
}

}  // namespace dockyard::custom
