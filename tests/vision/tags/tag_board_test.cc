// Boards of tags as files.
#include <gmock/gmock.h>

#include "controller/geometry/pose.h"
#include "models/read/load_board.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kHead =
    "name: t\nwidth_m: 0.4\nheight_m: 0.2\ntags:\n  family: tag36h11\n  marks:\n";

NamedBoard Loaded(const std::string& text) {
  const ScratchFolder folder;
  return LoadBoard(folder.Write("b.yaml", text));
}

std::string Message(const std::string& text) {
  const ScratchFolder folder;
  const std::string file = folder.Write("b.yaml", text);
  return MessageOf([&] { LoadBoard(file); }, folder);
}

std::string Mark(int id, double x, double y, double size, const std::string& more = "") {
  return "    - {id: " + std::to_string(id) + ", x_m: " + std::to_string(x) +
         ", y_m: " + std::to_string(y) + ", size_m: " + std::to_string(size) + more + "}\n";
}

TEST(TagBoard, HasWhatItsFileSays) {
  const FiducialBoard board =
      Loaded(kHead + Mark(3, -0.1, 0, 0.1) + Mark(4, 0.1, 0.01, 0.08, ", rotation_deg: -90")).board;
  EXPECT_TRUE(board.fiducials.empty());
  ASSERT_EQ(board.tags.size(), 2u);
  EXPECT_EQ(board.tags[1].family, "tag36h11");
  EXPECT_EQ(board.tags[1].id, 4);
  EXPECT_EQ(board.tags[1].p_BT, Eigen::Vector2d(0.1, 0.01));
  EXPECT_EQ(board.tags[1].size_m, 0.08);
  EXPECT_NEAR(board.tags[1].rotation, -kPi / 2, 1e-12);
  EXPECT_EQ(board.tags[1].cells.across, 10);
  EXPECT_NE(board.tags[0].cells.black, board.tags[1].cells.black);
  EXPECT_NEAR(board.tags[0].printed_m(), 0.125, 1e-12);
}

TEST(TagBoard, FilesOfTheTreeAreRead) {
  EXPECT_EQ(LoadBoard(SourceFile("models/boards/charger_tag.yaml")).board.tags.size(), 1u);
  EXPECT_EQ(LoadBoard(SourceFile("models/boards/four_tags.yaml")).board.tags.size(), 4u);
}

TEST(TagBoard, RefusesTagsThatCannotBeRead) {
  const std::string one = Mark(3, 0, 0, 0.1);
  EXPECT_THAT(Message(kHead + Mark(587, 0, 0, 0.1)),
              AllOf(StartsWith("b.yaml:7:12: tags.marks[0].id: expected "), HasSubstr("586")));
  EXPECT_THAT(Message(Replaced(kHead, "tag36h11", "tag36h12") + one),
              HasSubstr("tags.family: expected one of tag16h5, "));
  EXPECT_THAT(Message(kHead + Mark(3, 0, 0, 0.0)), HasSubstr("size_m: expected a number > 0"));
  EXPECT_EQ(Message(kHead + Mark(3, 0.16, 0, 0.1)),
            "b.yaml:7:7: tags.marks[0]: expected a tag inside the board, it sticks out");
  // 0.16 m with its margin of a tenth on either side would need 0.2 m of height; 0.165 m more.
  EXPECT_EQ(Loaded(kHead + Mark(3, 0, 0, 0.16)).board.tags.size(), 1u);
  EXPECT_EQ(Message(kHead + Mark(3, 0, 0, 0.168)),
            "b.yaml:7:7: tags.marks[0]: expected a white margin of 21 mm, one square, about the "
            "tag; the board ends before");
  EXPECT_THAT(Message(kHead + one + Mark(4, 0.05, 0, 0.05)),
              StartsWith("b.yaml:8:7: tags.marks[1]: expected a tag clear of the others, it "
                         "overlaps number 0"));
  EXPECT_THAT(Message(kHead + one + Mark(4, 0.105, 0, 0.1)),
              HasSubstr("tags.marks[1]: expected a white margin of 12.5 mm, one square, between "
                        "tags, it is nearer to number 0"));
  EXPECT_EQ(Loaded(kHead + one + Mark(4, 0.1126, 0, 0.1)).board.tags.size(), 2u);
  EXPECT_THAT(Message(kHead + one + Mark(3, 0.13, 0, 0.05)),
              HasSubstr("expected an id that no other tag has, it is that of number 0"));
  // Turned by 45 deg the corners reach out by half a diagonal.
  EXPECT_THAT(Message(kHead + Mark(3, 0, 0, 0.16, ", rotation_deg: 45")), HasSubstr("sticks out"));
}

TEST(TagBoard, RefusesDiscsWithTags) {
  EXPECT_THAT(Message("disc_diameter_m: 0.05\n" + kHead + Mark(3, 0, 0, 0.1)),
              StartsWith("b.yaml:1:18: disc_diameter_m: expected no such key with tags: a board "
                         "has either discs or tags"));
  EXPECT_THAT(Message(Replaced(kHead, "  marks:\n", "")), HasSubstr("missing key 'marks'"));
}

}  // namespace
}  // namespace dockyard
