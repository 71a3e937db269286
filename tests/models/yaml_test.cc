#include <gmock/gmock.h>

#include "models/read/yaml_reader.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string MessageFor(const std::string& text) {
  const ScratchFolder folder;
  return MessageOf([&] { ParseYaml(text, "a.yaml"); }, folder);
}

std::string NumberMessage(const std::string& text, const Range& range) {
  const ScratchFolder folder;
  return MessageOf(
      [&] {
        const YamlNode root = ParseYaml(text, "axel.yaml");
        const YamlReader in(root, "", {"wheels"});
        const YamlReader wheels(in.Child("wheels"), "wheels", {"radius_m", "width_m"});
        wheels.Number("radius_m", range);
      },
      folder);
}

TEST(YamlNumber, ThatIsNoneIsToldWithFileLineColumnAndPath) {
  EXPECT_EQ(NumberMessage("\n\nwheels:\n  radius_m: ten\n", Positive(2.0)),
            "axel.yaml:4:13: wheels.radius_m: expected a number > 0, found 'ten'");
}

TEST(YamlNumber, IsNeitherNanNorInfiniteNorHexadecimalNorQuoted) {
  for (const char* bad : {".nan", "nan", "NaN", ".inf", "-.inf", "inf", "1e999", "0x10", "1_000",
                          "1 2", "'0.3'", "+1", "", "~", "[1]", "{a: 1}", "true"}) {
    EXPECT_THAT(NumberMessage("wheels: {radius_m: " + std::string(bad) + "}", Positive(2.0)),
                HasSubstr("wheels.radius_m: expected a number > 0, found "))
        << bad;
  }
}

TEST(YamlNumber, BeyondItsRangeIsRefusedOnBothSides) {
  EXPECT_EQ(NumberMessage("wheels: {radius_m: 0}", Positive(2.0)),
            "axel.yaml:1:20: wheels.radius_m: expected a number > 0, found '0'");
  EXPECT_EQ(NumberMessage("wheels: {radius_m: 1e7}", Positive(2.0)),
            "axel.yaml:1:20: wheels.radius_m: expected a number > 0 and <= 2, found '1e7'");
  EXPECT_EQ(NumberMessage("wheels: {radius_m: -91}", Between(-90.0, 90.0)),
            "axel.yaml:1:20: wheels.radius_m: expected a number from -90 to 90, found '-91'");
  EXPECT_EQ(NumberMessage("wheels: {radius_m: -1}", NonNegative(5.0)),
            "axel.yaml:1:20: wheels.radius_m: expected a number >= 0, found '-1'");
}

TEST(YamlNumber, OnTheEdgeOfItsRangeIsTaken) {
  EXPECT_EQ(NumberMessage("wheels: {radius_m: 2}", Positive(2.0)), "(no error)");
  EXPECT_EQ(NumberMessage("wheels: {radius_m: 0}", NonNegative(2.0)), "(no error)");
}

TEST(YamlKey, ThatIsUnknownNamesTheNearest) {
  EXPECT_EQ(NumberMessage("wheels:\n  radios_m: 0.3\n", Positive(2.0)),
            "axel.yaml:2:3: wheels.radios_m: unknown key, did you mean 'radius_m'?");
}

TEST(YamlKey, ThatIsLikeNoneListsThoseThatAre) {
  EXPECT_EQ(NumberMessage("wheels:\n  radius_m: 0.3\n  colour: red\n", Positive(2.0)),
            "axel.yaml:3:3: wheels.colour: unknown key, known are: radius_m, width_m");
}

TEST(YamlKey, ThatIsMissingPointsAtItsParent) {
  EXPECT_EQ(NumberMessage("wheels:\n  width_m: 0.1\n", Positive(2.0)),
            "axel.yaml:2:3: wheels: missing key 'radius_m'");
  EXPECT_EQ(NumberMessage("{}", Positive(2.0)), "axel.yaml:1:1: missing key 'wheels'");
}

TEST(YamlKey, GivenTwiceIsRefusedWithBothLines) {
  EXPECT_EQ(MessageFor("a:\n  b: 1\n  c: 2\n  b: 3\n"),
            "a.yaml:4:3: a.b: given twice, first in line 2");
}

TEST(YamlKey, IsComparedWithAllOthersOfItsMapping) {
  std::string text;
  for (int i = 0; i < 99000; ++i) text += "k" + std::to_string(i) + ": 1\n";
  EXPECT_EQ(MessageFor(text), "(no error)");
  EXPECT_EQ(MessageFor(text + "k7: 2\n"), "a.yaml:99001:1: k7: given twice, first in line 8");
}

TEST(YamlMapping, WhereAScalarStandsIsRefused) {
  EXPECT_EQ(NumberMessage("wheels: 4\n", Positive(2.0)),
            "axel.yaml:1:9: wheels: expected a mapping (key: value), found '4'");
  EXPECT_EQ(NumberMessage("- 1\n", Positive(2.0)),
            "axel.yaml:1:1: expected a mapping (key: value), found a list");
}

TEST(YamlSyntax, ErrorsTellTheirPlace) {
  EXPECT_THAT(MessageFor("a: [1, 2\nb: 3\n"), StartsWith("a.yaml:"));
  EXPECT_THAT(MessageFor("a: [1, 2\nb: 3\n"), HasSubstr("not valid YAML"));
  EXPECT_THAT(MessageFor("a: b: c\n"), HasSubstr("not valid YAML"));
}

TEST(YamlSyntax, AnchorsAliasesAndTagsAreNotRead) {
  EXPECT_THAT(MessageFor("a: &x [1]\nb: *x\n"), HasSubstr("anchors (&name) are not read"));
  EXPECT_THAT(MessageFor("a: *x\n"), testing::AnyOf(HasSubstr("aliases"), HasSubstr("not valid")));
  EXPECT_THAT(MessageFor("a: !!binary AAAA\n"), HasSubstr("tags (!name) are not read"));
}

TEST(YamlSyntax, HasOneDocument) {
  EXPECT_THAT(MessageFor("a: 1\n---\nb: 2\n"), HasSubstr("expected one document"));
}

TEST(YamlSyntax, IsNotNestedWithoutBound) {
  EXPECT_THAT(MessageFor(std::string(40, '[') + std::string(40, ']')),
              HasSubstr("nested deeper than 32 levels"));
  EXPECT_THAT(MessageFor(std::string(200000, '[')), StartsWith("a.yaml:"));
}

TEST(YamlSyntax, DoesNotBearBinaryJunk) {
  EXPECT_EQ(MessageFor(std::string("a: 1\nb: \0\n", 10)),
            "a.yaml:2:4: expected text in UTF-8, found byte 0");
  EXPECT_EQ(MessageFor("\x7f\x45LF\x02\x01"), "a.yaml:1:1: expected text in UTF-8, found byte 127");
  EXPECT_EQ(MessageFor("a: \xc3\x28"), "a.yaml:1:4: expected text in UTF-8, found byte 195");
}

TEST(YamlText, HoldsNoControlCharacterHoweverItIsWritten) {
  const auto refused = [](const std::string& at, const std::string& name) {
    return "a.yaml:" + at + ": expected text without control characters, found " + name;
  };
  EXPECT_EQ(MessageFor("a: \"\\x1b[32m\"\n"), refused("1:4", "U+001B"));
  EXPECT_EQ(MessageFor("a: \"x\\e[0m\"\n"), refused("1:4", "U+001B"));
  EXPECT_EQ(MessageFor("a:\n  - \"\\0\"\n"), refused("2:5", "U+0000"));
  EXPECT_EQ(MessageFor("a: [x, \"\\a\"]\n"), refused("1:8", "U+0007"));
  EXPECT_EQ(MessageFor("a: \"\\r\"\n"), refused("1:4", "U+000D"));
  EXPECT_EQ(MessageFor("a: \"\\x7f\"\n"), refused("1:4", "U+007F"));
  EXPECT_EQ(MessageFor("a: \"\\N\"\n"), refused("1:4", "U+0085"));
  EXPECT_EQ(MessageFor("a: \"\\u009b\"\n"), refused("1:4", "U+009B"));
  EXPECT_EQ(MessageFor("a: x\xC2\x9By\n"), refused("1:4", "U+009B"));
  EXPECT_EQ(MessageFor("a: \"\\L\"\n"), refused("1:4", "U+2028"));
  EXPECT_EQ(MessageFor("{\"a\\x1b\": 1}\n"), refused("1:2", "U+001B"));
  EXPECT_EQ(MessageFor("\"a\\nb\": 1\n"), refused("1:1", "U+000A"));
}

TEST(YamlText, OfAnOptionHoldsNoControlCharacter) {
  const ScratchFolder folder;
  const auto set = [&](const std::string& assignment) {
    YamlNode root = ParseYaml("a: 1", "a.yaml");
    return MessageOf([&] { SetYaml(root, assignment); }, folder);
  };
  EXPECT_THAT(set("a=\"\\e[0m\""), HasSubstr("without control characters, found U+001B"));
  EXPECT_THAT(set("a=x\x1b"), HasSubstr("expected text in UTF-8, found byte 27"));
  EXPECT_THAT(set("a\nb=1"), HasSubstr("a key without control characters, found U+000A"));
  EXPECT_EQ(set("a=\"caf\xC3\xA9\""), "(no error)");
}

TEST(YamlText, OfSeveralLinesIsWrittenInOneAndReadBack) {
  const YamlNode text = ParseYaml("a: |\n  for x in y:\n  \tprint(\"x\\n\")\n", "a.yaml");
  const std::string written = FlowText(text);
  EXPECT_EQ(written.find('\n'), std::string::npos);
  EXPECT_EQ(ParseYaml(written, "b.yaml").Find("a")->scalar, "for x in y:\n\tprint(\"x\\n\")\n");
}

TEST(YamlFile, ThatIsEmptyMissingOrHugeIsRefused) {
  const ScratchFolder folder;
  const auto load = [&](const std::string& name) {
    return MessageOf([&] { LoadYaml(folder.path() / name); }, folder);
  };
  folder.Write("empty.yaml", "");
  folder.Write("blank.yaml", " \n\n");
  folder.Write("comment.yaml", "# nothing\n");
  folder.Write("huge.yaml", std::string((4u << 20) + 1, ' '));
  EXPECT_EQ(load("empty.yaml"), "empty.yaml:1:1: the file is empty");
  EXPECT_EQ(load("blank.yaml"), "blank.yaml:1:1: the file is empty");
  EXPECT_EQ(load("comment.yaml"), "comment.yaml:1:1: the file is empty");
  EXPECT_EQ(load("huge.yaml"),
            "huge.yaml: larger than 4 MiB, which is more than this kind of file may have");
  EXPECT_EQ(load("none.yaml"), "none.yaml: no such file");
  EXPECT_EQ(MessageOf([&] { LoadYaml(folder.path()); }, folder),
            folder.path().string() + ": not a regular file");
}

TEST(NumberText, ReadsBackToTheSameBits) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, 6.02214076e23, -0.0325}) {
    double back = 0.0;
    ASSERT_TRUE(ParseNumber(NumberText(value), back));
    EXPECT_EQ(back, value);
  }
}

}  // namespace
}  // namespace dockyard
