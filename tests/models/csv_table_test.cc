#include "models/read/csv_table.h"

#include <gmock/gmock.h>

#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

YamlNode TableOf(const std::string& text) {
  const ScratchFolder folder;
  return LoadCsv(folder.Write("t.csv", text));
}

std::string MessageFor(const std::string& text) {
  const ScratchFolder folder;
  const std::string file = folder.Write("t.csv", text);
  return MessageOf([&] { LoadCsv(file); }, folder);
}

TEST(CsvTable, ReadsTheSameWithAnyLineEndsAndBlankRows) {
  for (const char* text :
       {"run,x_m\n1,2.5\n3,4\n", "run,x_m\r\n1,2.5\r\n3,4\r\n", "run,x_m\r1,2.5\r3,4\r",
        "run,x_m\n\n1,2.5\n# a note\n3,4", "run,x_m\n1,2.5\n,\n3,4\n , \n,\n"}) {
    const YamlNode table = TableOf(text);
    ASSERT_EQ(table.items.size(), 2u) << text;
    EXPECT_EQ(table.items[0].Find("x_m")->scalar, "2.5");
    EXPECT_EQ(table.items[1].Find("run")->scalar, "3");
  }
}

TEST(CsvTable, CountsLinesOfEverySystemAlike) {
  for (const char* text : {"run,x_m\n1,2\n3\n", "run,x_m\r\n1,2\r\n3\r\n", "run,x_m\r1,2\r3\r"}) {
    EXPECT_EQ(MessageFor(text), "t.csv:3:1: expected 2 cells as in the header, found 1");
  }
}

TEST(CsvTable, WithOtherSeparatorsNamesThem) {
  const std::string rest = "; save the table with commas between the cells";
  EXPECT_EQ(MessageFor("run;x_m\n1;2\n"),
            "t.csv:1:4: expected cells separated by commas, found ';' (semicolons)" + rest);
  EXPECT_EQ(MessageFor("run\tx_m\n1\t2\n"),
            "t.csv:1:4: expected cells separated by commas, found tabs" + rest);
  EXPECT_EQ(MessageFor("run|x_m\n1|2\n"),
            "t.csv:1:4: expected cells separated by commas, found '|' (vertical bars)" + rest);
  EXPECT_EQ(MessageFor("  run x_m\n  1 2\n"),
            "t.csv:1:6: expected cells separated by commas, found spaces" + rest);
  EXPECT_EQ(MessageFor("\"run\";\"x_m\"\n1;2\n"),
            "t.csv:1:6: expected cells separated by commas, found ';' (semicolons)" + rest);
  EXPECT_EQ(MessageFor("run,x_m\n1;2\n"),
            "t.csv:2:2: expected cells separated by commas, found ';' (semicolons)" + rest);
}

TEST(CsvTable, WithDecimalCommasSaysSo) {
  EXPECT_EQ(MessageFor("run;x_m\n1;2,5\n"),
            "t.csv:1:4: expected cells separated by commas, found ';' (semicolons) and decimal "
            "commas; save the table with commas between the cells and decimal points");
  EXPECT_THAT(MessageFor("x_m,y_m\n1,5,2,5\n"),
              HasSubstr("found 4 (decimal commas? expected decimal points)"));
}

// A comma in a text is no decimal comma.
TEST(CsvTable, OfSemicolonsAndTextsIsNotSaidToHaveDecimalCommas) {
  EXPECT_THAT(MessageFor("run;note\n1;wet, cold\n"), testing::Not(HasSubstr("decimal")));
}

// Excel writes and reads "sep=X" as the first line.
TEST(CsvTable, MayNameItsSeparatorInTheFirstLine) {
  EXPECT_EQ(TableOf("sep=,\nrun,x_m\n1,2\n").items.size(), 1u);
  EXPECT_EQ(TableOf("\"sep=,\"\nrun,x_m\n1,2\n").items.size(), 1u);
  EXPECT_THAT(MessageFor("sep=;\nrun;x_m\n1;2\n"), HasSubstr("found ';' (semicolons)"));
}

TEST(CsvTable, OfOneColumnNeedsNoSeparator) {
  EXPECT_EQ(TableOf("note\nwet; cold\n").items[0].Find("note")->scalar, "wet; cold");
}

TEST(CsvTable, KeepsCommasInQuotations) {
  EXPECT_EQ(TableOf("run,note\n1,\"wet, \"\"cold\"\"\"\n").items[0].Find("note")->scalar,
            "wet, \"cold\"");
}

TEST(CsvTable, HasNoControlCharactersInItsCells) {
  EXPECT_EQ(MessageFor("run,note\n1,a\tb\n"),
            "t.csv:2:3: expected text without control characters, found U+0009 (a tab)");
  EXPECT_EQ(MessageFor("run,note\n1,a\xC2\x9B"
                       "31m\n"),
            "t.csv:2:3: expected text without control characters, found U+009B");
  EXPECT_EQ(MessageFor("run,a\xE2\x80\xA8"
                       "b\n1,2\n"),
            "t.csv:1:5: expected text without control characters, found U+2028");
}

}  // namespace
}  // namespace dockyard
