#include "models/read/text_file.h"

#include <gmock/gmock.h>

#include "models/read/csv_table.h"
#include "models/read/load_obstacles.h"
#include "models/read/urdf.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using namespace std::string_view_literals;

constexpr std::string_view kMark = "\xEF\xBB\xBF";

std::string ReadingOf(std::string_view bytes) {
  const ScratchFolder folder;
  const std::string file = folder.Write("a.csv", std::string(bytes));
  return MessageOf([&] { ReadText(file); }, folder);
}

TEST(TextFile, MayBeginWithAByteOrderMark) {
  const ScratchFolder folder;
  EXPECT_EQ(ReadText(folder.Write("a", std::string(kMark) + "x,y\n1,2\n")), "x,y\n1,2\n");
  EXPECT_EQ(ReadText(folder.Write("b", "x,y\n1,2\n")), "x,y\n1,2\n");
}

TEST(TextFile, OfAByteOrderMarkAloneIsEmpty) {
  EXPECT_EQ(ReadingOf(kMark), "a.csv:1:1: the file is empty");
}

TEST(TextFile, CountsColumnsBehindTheByteOrderMark) {
  EXPECT_EQ(ReadingOf("\xEF\xBB\xBF"
                      "ab\x1b\n"),
            "a.csv:1:3: expected text in UTF-8, found byte 27");
}

TEST(TextFile, OfEveryKindMayBeginWithAByteOrderMark) {
  const ScratchFolder folder;
  const auto marked = [&](const std::string& name, const std::string& text) {
    return folder.Write(name, std::string(kMark) + text);
  };
  EXPECT_EQ(LoadCsv(marked("t.csv", "run,x_m\n1,2\n")).items.at(0).keys.at(0).name, "run");
  EXPECT_EQ(LoadYaml(marked("y.yaml", "run: 1\n")).keys.at(0).name, "run");
  EXPECT_EQ(LoadUrdf(marked("u.urdf",
                            "<?xml version=\"1.0\"?><robot name=\"r\"><link name=\"a\"/>"
                            "</robot>"))
                .name,
            "r");
  EXPECT_EQ(
      LoadObstacles(marked("o.yaml", "obstacles: [{x_m: 1, y_m: 2, radius_m: 3}]\n")).discs.size(),
      1u);
}

TEST(TextFile, InUnitsOfTwoBytesIsRefusedWithTheStepsToUtf8) {
  for (const std::string_view bytes :
       {"\xFF\xFEr\0u\0n\0"sv, "\xFE\xFF\0r\0u\0n"sv, "r\0u\0n\0,\0"sv, "\0r\0u\0n\0,"sv}) {
    EXPECT_THAT(ReadingOf(bytes),
                StartsWith("a.csv:1:1: expected text in UTF-8, found UTF-16; save it as UTF-8"));
    EXPECT_THAT(ReadingOf(bytes), HasSubstr("CSV UTF-8"));
    EXPECT_THAT(ReadingOf(bytes), HasSubstr("iconv -f UTF-16 -t UTF-8"));
  }
  EXPECT_THAT(ReadingOf("\xFF\xFE\0\0r\0\0\0"sv), HasSubstr("found UTF-32;"));
}

TEST(TextFile, OfABinaryKindIsNotCalledUtf16) {
  EXPECT_EQ(ReadingOf("\x7f\x45LF\x02\x01\x01\0\0"sv),
            "a.csv:1:1: expected text in UTF-8, found byte 127");
  EXPECT_EQ(ReadingOf("\0\0\0\0\0\0"sv), "a.csv:1:1: expected text in UTF-8, found byte 0");
}

// Unicode 15, categories Cc, Zl and Zp, and U+FEFF.
TEST(ControlCharacters, AreThoseThatMoveATerminalOrEndALine) {
  EXPECT_EQ(FirstControl("r\xC3\xB6ver \xE6\x9C\x88 \xF0\x9F\x9A\x80 ~"), std::nullopt);
  EXPECT_EQ(FirstControl("\x1b[32m"), U'\x1b');
  EXPECT_EQ(FirstControl("a\tb"), U'\t');
  EXPECT_EQ(FirstControl("a\x7f"), U'\x7f');
  EXPECT_EQ(FirstControl("a\xC2\x85"), U'\x85');        // NEL
  EXPECT_EQ(FirstControl("a\xC2\x9B"), U'\x9b');        // CSI in one character
  EXPECT_EQ(FirstControl("a\xC2\xA0"), std::nullopt);   // a space that does not break
  EXPECT_EQ(FirstControl("a\xE2\x80\xA8"), U'\x2028');  // LINE SEPARATOR
  EXPECT_EQ(FirstControl("\xEF\xBB\xBF"
                         "a"),
            U'\xFEFF');
  EXPECT_EQ(FirstControl("a\xE9"), U'\xE9');  // Latin-1: no UTF-8
  EXPECT_EQ(CharacterName(U'\x1b'), "U+001B");
}

TEST(WithControlsShown, EscapesWhatMovesATerminalAndLeavesTheRest) {
  const std::string plain = "r\xC3\xB6ver \xE6\x9C\x88 \xF0\x9F\x9A\x80 C:\\x\tb\n";
  EXPECT_EQ(WithControlsShown(plain), plain);
  EXPECT_EQ(WithControlsShown("a\x1b[31mz\r\x7f"), "a\\x1b[31mz\\x0d\\x7f");
  EXPECT_EQ(WithControlsShown("a\xC2\x85z\xC2\x9B\xE2\x80\xA8"), "a\\u0085z\\u009b\\u2028");
  EXPECT_EQ(WithControlsShown("a\xE9 \xC2"), "a\\xe9 \\xc2");  // no UTF-8
  const std::string shown = WithControlsShown("\x1b\xE9\xC2\x85");
  EXPECT_EQ(WithControlsShown(shown), shown);
}

}  // namespace
}  // namespace dockyard
