// Reading, writing and comparing keys, on a struct of the tests.
#include "sim/scenario/keys.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "controller/geometry/pose.h"
#include "sim/scenario/key_path.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

enum class Cloth { kRed, kBlue };

struct Flag {
  double x_m = 2.0, turn_rad = 0.0;
  double weight_kg = std::numeric_limits<double>::quiet_NaN();
  int threads = 0;
  std::uint64_t seed = 7;
  bool waves = false;
  std::string owner, wind = "calm", cloth_file;
  std::vector<std::string> gusts, sponsors;
  Cloth cloth = Cloth::kBlue;
  YamlNode notes, moves;
};

void VisitFlag(Keys& keys, Flag& flag) {
  using enum Presence;
  keys.Number({"x_m", "m", "where it stands"}, flag.x_m, Positive(10.0));
  keys.Mapping({"pole", "", ""}, [&](Keys& in) {
    in.Degrees({"turn_deg", "deg", "of the pole"}, flag.turn_rad, Between(-90.0, 90.0));
    in.Number({"weight_kg", "kg", "of the pole", kUnset}, flag.weight_kg, Between(1.0, 5.0));
  });
  keys.Integer({"threads", "", "of the cloth", kUnset}, flag.threads, 1, 9);
  keys.Seed({"seed", "", "of the wind"}, flag.seed);
  keys.Bool({"waves", "", "in the wind"}, flag.waves);
  keys.Text({"owner", "", "whose it is", kRequired}, flag.owner);
  keys.RefusedWord("wind", "calme", "'calm', as it is called now");
  keys.WordOrMapping({"wind", "", "how it blows"}, flag.wind, {"calm", "storm"}, "gusts",
                     [&](Keys& in) {
                       in.Texts({"gusts", "", "one after the other", kRequired}, flag.gusts, 3);
                     });
  keys.File({"cloth_file", "", "on it", kUnset}, flag.cloth_file);
  keys.Texts({"sponsors", "", "who paid", kUnset}, flag.sponsors, 2);
  keys.Choice({"cloth", "", "its colour"}, flag.cloth, {"red", "blue"});
  keys.Tree({"notes", "", "anything", kUnset}, flag.notes, YamlNode::Kind::kMapping);
  keys.Tree({"moves", "", "anything in order", kUnset}, flag.moves, YamlNode::Kind::kSequence);
  keys.Refused("color", "the key 'cloth' instead");
}

Flag ReadFlag(const std::string& text, const std::string& file = "flag.yaml") {
  Flag flag;
  ReadKeys(ParseYaml(text, file), "", [&](Keys& keys) { VisitFlag(keys, flag); });
  return flag;
}
YamlNode Written(Flag flag) {
  return WriteKeys([&](Keys& keys) { VisitFlag(keys, flag); });
}
std::string Message(const std::string& text) {
  const ScratchFolder folder;
  return MessageOf([&] { ReadFlag(text); }, folder);
}

/// With every key given.
constexpr const char* kWhole = R"(x_m: 3.5
pole: {turn_deg: -12.5, weight_kg: 2}
threads: 4
seed: 18446744073709551615
waves: true
owner: 'a "b" \ : c'
wind: {gusts: [north, "west: 3"]}
cloth_file: cloth.txt
sponsors: [x]
cloth: red
notes: {a: {b: [1, two]}}
moves: [{up: 1}, down]
)";

TEST(ReadKeys, TakesDefaultsFromTheVariables) {
  const Flag flag = ReadFlag("owner: me");
  EXPECT_EQ(flag.x_m, 2.0);
  EXPECT_EQ(flag.seed, 7u);
  EXPECT_EQ(flag.wind, "calm");
  EXPECT_EQ(flag.cloth, Cloth::kBlue);
  EXPECT_TRUE(std::isnan(flag.weight_kg));
}

TEST(ReadKeys, TurnsDegreesIntoRadians) {
  EXPECT_EQ(ReadFlag("owner: me\npole: {turn_deg: 30}").turn_rad, Radians(30.0));
}

TEST(ReadKeys, FaultsAreToldByPlaceAndPath) {
  EXPECT_EQ(Message("x_m: 3"), "flag.yaml:1:1: missing key 'owner'");
  EXPECT_EQ(Message("ownr: me"), "flag.yaml:1:1: ownr: unknown key, did you mean 'owner'?");
  EXPECT_EQ(Message("owner: me\nx_m: 11"),
            "flag.yaml:2:6: x_m: expected a number > 0 and <= 10, found '11'");
  EXPECT_EQ(Message("owner: me\npole: {turn_deg: 91}"),
            "flag.yaml:2:18: pole.turn_deg: expected a number from -90 to 90, found '91'");
  EXPECT_EQ(Message("owner: me\npole: {turn_dg: 9}"),
            "flag.yaml:2:8: pole.turn_dg: unknown key, did you mean 'turn_deg'?");
  EXPECT_EQ(Message("owner: me\ncloth: green"),
            "flag.yaml:2:8: cloth: expected one of red, blue, found 'green'");
  EXPECT_EQ(Message("owner: me\nwind: {}"), "flag.yaml:2:7: wind: missing key 'gusts'");
  EXPECT_EQ(Message("owner: me\nwind: mild"),
            "flag.yaml:2:7: wind: expected one of calm, storm, found 'mild'");
  EXPECT_EQ(Message("owner: me\nsponsors: [a, [b]]"),
            "flag.yaml:2:15: sponsors: expected a list of texts, found a list in it");
  EXPECT_EQ(Message("owner: me\nnotes: [1]"),
            "flag.yaml:2:8: notes: expected a mapping (key: value), found a list");
  EXPECT_EQ(Message("owner: me\nmoves: {a: 1}"),
            "flag.yaml:2:8: moves: expected a list, found a mapping");
}

TEST(ReadKeys, RefusedKeyBringsItsHintBeforeAnyOtherFault) {
  EXPECT_EQ(Message("color: red\nx_m: ten"),
            "flag.yaml:1:1: color: expected the key 'cloth' instead");
}

TEST(ReadKeys, FormerWordBringsItsHint) {
  EXPECT_EQ(Message("owner: Ann\nwind: calme"),
            "flag.yaml:2:7: wind: expected 'calm', as it is called now, found 'calme'");
}

TEST(ReadKeys, MissingMappingIsOneWithoutKeys) {
  Flag flag;
  YamlNode none;
  none.place = {std::make_shared<const std::string>("s.yaml"), 3, 1};
  const ScratchFolder folder;
  EXPECT_EQ(
      MessageOf([&] { ReadKeys(none, "toy", [&](Keys& keys) { VisitFlag(keys, flag); }); }, folder),
      "s.yaml:3:1: toy: missing key 'owner'");
}

TEST(ReadSomeKeys, DemandsNoneAndChecksThoseThatAreThere) {
  Flag flag;
  const auto visit = [&](Keys& keys) { VisitFlag(keys, flag); };
  ReadSomeKeys(ParseYaml("x_m: 5", "f"), "", visit);
  EXPECT_EQ(flag.x_m, 5.0);
  EXPECT_THROW(ReadSomeKeys(ParseYaml("x_m: 50", "f"), "", visit), ConfigError);
}

TEST(WriteKeys, EveryKeyThatTheVisitorNamesIsWrittenAndReadBack) {
  const ScratchFolder folder;
  folder.Write("cloth.txt", "x");
  const std::string file = (folder.path() / "flag.yaml").string();
  const YamlNode written = Written(ReadFlag(std::string(kWhole), file));
  Flag flag;
  for (const KeyRow& row : DocumentKeys([&](Keys& keys) { VisitFlag(keys, flag); })) {
    EXPECT_NE(FindPath(written, row.key), nullptr) << row.key;
  }
  const YamlNode again = Written(ReadFlag(BlockText(written), "/elsewhere/flag.yaml"));
  EXPECT_THAT(DifferingKeys(written, again), ElementsAre());
  EXPECT_EQ(BlockText(written), BlockText(again));
}

TEST(WriteKeys, LeavesOutWhatIsUnsetAndWritesDefaults) {
  const YamlNode written = Written({});
  EXPECT_EQ(FindPath(written, "pole.weight_kg"), nullptr);
  EXPECT_EQ(written.Find("threads"), nullptr);
  EXPECT_EQ(written.Find("cloth_file"), nullptr);
  EXPECT_EQ(written.Find("notes"), nullptr);
  EXPECT_EQ(written.Find("x_m")->scalar, "2");
  EXPECT_EQ(written.Find("cloth")->scalar, "blue");
}

TEST(WriteKeys, DegreesReadBackToTheSameBits) {
  Flag flag;
  flag.owner = "me";
  for (int i = 0; i < 2000; ++i) {
    flag.turn_rad = Radians(-89.9 + 0.0899 * i + 1e-9 * i);
    EXPECT_EQ(ReadFlag(BlockText(Written(flag))).turn_rad, flag.turn_rad);
  }
}

TEST(DifferingKeys, NamesWhatChangedAndNothingElse) {
  const auto differing = [](const std::string& from, const std::string& to) {
    const ScratchFolder folder;
    folder.Write("cloth.txt", "x");
    const std::string file = (folder.path() / "flag.yaml").string();
    return DifferingKeys(Written(ReadFlag(std::string(kWhole), file)),
                         Written(ReadFlag(Replaced(std::string(kWhole), from, to), file)));
  };
  EXPECT_THAT(differing("x_m: 3.5", "x_m: 3.5000000000000004"), ElementsAre("x_m"));
  EXPECT_THAT(differing("turn_deg: -12.5", "turn_deg: 12.5"), ElementsAre("pole.turn_deg"));
  EXPECT_THAT(differing(", weight_kg: 2", ""), ElementsAre("pole.weight_kg"));
  EXPECT_THAT(differing("[1, two]", "[1, 2]"), ElementsAre("notes.a.b"));
  EXPECT_THAT(differing("wind: {gusts: [north, \"west: 3\"]}", "wind: storm"), ElementsAre("wind"));
  EXPECT_THAT(differing("notes: {a: {b: [1, two]}}\n", ""), ElementsAre("notes.a.b"));
  EXPECT_THAT(differing("x_m", "x_m"), ElementsAre());
}

TEST(DocumentKeys, SaysKindRangeUnitDefaultAndMeaning) {
  Flag flag;
  const std::string table = KeyTable(DocumentKeys([&](Keys& keys) { VisitFlag(keys, flag); }));
  for (const char* line :
       {"| `x_m` | number | above 0 to 10 | m | 2 | where it stands |\n",
        "| `pole.turn_deg` | number | -90 to 90 | deg | 0 | of the pole |\n",
        "| `pole.weight_kg` | number | 1 to 5 | kg | none | of the pole |\n",
        "| `threads` | whole number | 1 to 9 |  | none | of the cloth |\n",
        "| `waves` | true or false |  |  | false | in the wind |\n",
        "| `owner` | text |  |  | required | whose it is |\n",
        "| `wind` | word | calm, storm, or a mapping |  | calm | how it blows |\n",
        "| `wind.gusts` | list of texts | 1 to 3 |  | required | one after the other |\n",
        "| `cloth_file` | file |  |  | none | on it |\n",
        "| `cloth` | word | red, blue |  | blue | its colour |\n",
        "| `moves` | list |  |  | none | anything in order |\n"}) {
    EXPECT_THAT(table, HasSubstr(line));
  }
}

struct Cart {
  int kind = 0;
  double length_m = 0.0, play_m = 0.0;
  Eigen::Vector3d seat_m{0, 0, 0};
  std::vector<double> wheels_m;
};

void VisitCart(Keys& keys, Cart& cart) {
  keys.Choice(Optional("kind"), cart.kind, {"plain", "long"});
  keys.Allow("length_m", cart.kind == 1, "none of a plain cart");
  keys.Number(keys.NeededIf(cart.kind == 1, "length_m"), cart.length_m, Positive(10.0));
  keys.Number(Optional("play_m"), cart.play_m,
              keys.Limits(NonNegative(0.1 * cart.length_m), NonNegative(1.0)));
  keys.Vector3("seat_m", cart.seat_m, Between(-1.0, 1.0));
  keys.Items("wheels", cart.wheels_m, 1, 4,
             [](Keys& in, double& x_m) { in.Number("x_m", x_m, Between(-5.0, 5.0)); });
  keys.Check("wheels", cart.wheels_m.size() != 3, "no tricycle");
}

std::string CartMessage(const std::string& text) {
  const ScratchFolder folder;
  Cart cart;
  return MessageOf(
      [&] { ReadKeys(ParseYaml(text, "c.yaml"), "", [&](Keys& k) { VisitCart(k, cart); }); },
      folder);
}

TEST(DependentKeys, AreRefusedAtTheirPlaceByWhatWasReadBefore) {
  const std::string rest = ", seat_m: [0, 0.5, 1], wheels: [{x_m: 1}, {x_m: -1}]}";
  EXPECT_EQ(CartMessage("{kind: long, length_m: 2, play_m: 0.2" + rest), "(no error)");
  EXPECT_EQ(CartMessage("{play_m: 0" + rest), "(no error)");
  EXPECT_EQ(CartMessage("{length_m: 2" + rest),
            "c.yaml:1:12: length_m: expected none of a plain cart, found '2'");
  EXPECT_EQ(CartMessage("{kind: long" + rest), "c.yaml:1:1: missing key 'length_m'");
  EXPECT_THAT(CartMessage("{kind: long, length_m: 2, play_m: 0.3" + rest),
              HasSubstr("play_m: expected a number >= 0 and <= 0.2, found '0.3'"));
  EXPECT_THAT(CartMessage("{seat_m: [0, 2, 0], wheels: [{x_m: 1}]}"),
              HasSubstr("seat_m[1]: expected a number from -1 to 1, found '2'"));
  EXPECT_THAT(CartMessage("{seat_m: [0, 0, 0], wheels: [{x_m: 1}, {y_m: 1}]}"),
              HasSubstr("wheels[1].y_m: unknown key"));
  EXPECT_THAT(CartMessage("{seat_m: [0, 0, 0], wheels: []}"),
              HasSubstr("wheels: expected a list of 1 to 4, found a list of 0"));
  EXPECT_THAT(CartMessage("{seat_m: [0, 0, 0], wheels: [{x_m: 1}, {x_m: 2}, {x_m: 3}]}"),
              HasSubstr("wheels: expected no tricycle, found a list"));
}

TEST(DependentKeys, AreAllNamedWhereNoFileIsRead) {
  Cart cart;
  std::vector<std::string> keys;
  for (const KeyRow& row : DocumentKeys([&](Keys& k) { VisitCart(k, cart); })) {
    keys.push_back(row.key + " " + row.range);
  }
  EXPECT_THAT(keys,
              ElementsAre("kind plain, long", "length_m above 0 to 10", "play_m 0 to 1",
                          "seat_m 3 numbers, -1 to 1", "wheels 1 to 4", "wheels[].x_m -5 to 5"));
}

TEST(DependentKeys, ReadBackAsTheyAreWritten) {
  Cart cart{.kind = 1, .length_m = 3.0, .seat_m = {0.1, 0.2, 0.3}, .wheels_m = {1.5, -1.5}}, back;
  const YamlNode written = WriteKeys([&](Keys& k) { VisitCart(k, cart); });
  ReadKeys(written, "", [&](Keys& k) { VisitCart(k, back); });
  EXPECT_EQ(back.seat_m, cart.seat_m);
  EXPECT_EQ(back.wheels_m, cart.wheels_m);
  EXPECT_EQ(back.length_m, 3.0);
}

}  // namespace
}  // namespace dockyard
