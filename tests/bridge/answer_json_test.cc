#include "sim/bridge/answer_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace dockyard {
namespace {

/// What is said of it; empty if it is taken.
std::string Refused(const std::string& text) {
  try {
    Belief belief;
    TakeNumbers(AnswerFrom(text), belief);
    return "";
  } catch (const AnswerError& error) {
    return error.what();
  }
}

std::string Nested(std::size_t levels, const std::string& open, const std::string& close) {
  std::string text;
  for (std::size_t i = 0; i < levels; ++i) text += open;
  text += "1";
  for (std::size_t i = 0; i < levels; ++i) text += close;
  return text;
}

TEST(AnswerJson, OfAnyDepthIsRefusedBeforeItIsParsed) {
  for (const std::size_t levels : {16u, 500u, 300'000u}) {
    EXPECT_EQ(Refused("{\"protocol\": " + Nested(levels, "[", "]") + "}"),
              "more than 16 levels of JSON");
    EXPECT_EQ(Refused(Nested(levels + 1, "{\"a\":", "}")), "more than 16 levels of JSON");
    EXPECT_EQ(Refused("{\"a\": " + std::string(levels + 1, '[')), "more than 16 levels of JSON");
  }
  EXPECT_EQ(Refused("{\"a\": " + Nested(15, "[", "]") + "}"), "");
}

TEST(AnswerJson, CountsNoBracketsInTexts) {
  EXPECT_EQ(Refused(R"({"phase": "[[[[[[[[[[[[[[[[[[[[[[[[\"[{", "b": "\\"})"), "");
}

TEST(AnswerJson, OfAnotherShapeIsRefusedWithoutItsText) {
  for (const char* text :
       {"", "x", "[]", "3", "null", "\"hello\"", "{\"a\": NaN}", "{\"values\": {\"v\": 1e999}}",
        "{\"phase\": \"\xff\xfe\"}", "{\"phase\": \"\xed\xa0\x80\"}", "{\"values\": [1]}",
        "{\"values\": {\"v\": \"1\"}}", "{\"values\": {\"v\": true}}",
        "{\"values\": {\"v\": null}}", "{\"x_m\": 1}",
        "{\"x_m\": 1, \"y_m\": 2, \"heading_rad\": \"3\"}",
        "{\"x_m\": true, \"y_m\": 2, \"heading_rad\": 3}",
        "{\"x_m\": 1e300, \"y_m\": 2, \"heading_rad\": 3}",
        "{\"x_m\": 1, \"y_m\": 2, \"heading_rad\": -1e18}"}) {
    const std::string said = Refused(text);
    EXPECT_FALSE(said.empty()) << text;
    EXPECT_THAT(said, testing::Not(testing::HasSubstr("json.exception"))) << text;
    EXPECT_LT(said.size(), 80u);
  }
}

TEST(AnswerJson, HasABoundedNumberOfValuesWithShortNames) {
  Json values = Json::object();
  for (std::size_t i = 0; i < kMostValues; ++i) values["v" + std::to_string(i)] = i;
  Belief belief;
  TakeNumbers(Json{{"values", values}}, belief);
  EXPECT_EQ(belief.values.size(), kMostValues);
  values["one more"] = 1;
  EXPECT_EQ(Refused(Json{{"values", values}}.dump()), "more than 256 values");
  EXPECT_EQ(Refused("{\"values\": {\"" + std::string(65, 'a') + "\": 1}}"),
            "a value's name of more than 64 bytes");
}

TEST(AnswerJson, HasNamesOfValuesWithoutControlCharacters) {
  Belief belief;
  TakeNumbers(
      Json{{"values",
            {{"a\n\x1b[2J\u009b<b>", 1}, {"\u202ex\u2069\u2028", 2}, {"=1+\u00e9\u20ac", 3}}}},
      belief);
  ASSERT_EQ(belief.values.size(), 3u);
  EXPECT_EQ(belief.values[0].name, "a??[2J?<b>");
  EXPECT_EQ(belief.values[1].name, "?x??");
  EXPECT_EQ(belief.values[2].name, "=1+\u00e9\u20ac");
}

TEST(AnswerJson, RefusesValuesThatNoNameTellsApart) {
  EXPECT_EQ(Refused(R"({"values": {"": 1}})"), "a value without a name");
  EXPECT_EQ(Refused(R"({"values": {"a\n": 1, "a\t": 2}})"),
            "two values of one name, once control characters are '?'");
}

TEST(AnswerJson, LeavesTheBeliefAsItWasWherePoseIsBad) {
  Belief belief;
  belief.X_DR = {1.0, 2.0, 0.5};
  EXPECT_THROW(TakeNumbers(Json{{"x_m", 9}, {"y_m", 9}}, belief), AnswerError);
  EXPECT_FALSE(belief.located);
  EXPECT_EQ(belief.X_DR.x, 1.0);
}

TEST(AnswerJson, TakesAPoseInSpace) {
  Belief belief;
  TakeNumbers(Json{{"x_m", 1}, {"y_m", 2}, {"heading_rad", 0.5}, {"z_m", -3}, {"pitch_rad", 0.25}},
              belief);
  EXPECT_EQ(belief.X_DR.heading, 0.5);
  EXPECT_EQ(belief.X_DR.X.p, Eigen::Vector3d(1.0, 2.0, -3.0));
  EXPECT_LT((belief.X_DR.X.R - RotZ(0.5) * RotY(0.25)).norm(), 1e-15);
  EXPECT_THROW(TakeNumbers(Json{{"z_m", -3}}, belief), AnswerError);  // a depth alone is no pose
}

TEST(AnswerJson, OfAnyBytesIsTakenOrRefused) {
  std::mt19937 random(3);
  const std::string letters =
      "{}[]\",:0123456789.eE-+truefalsn \\u\xc3\xa4\xff x_myheading_radvalues";
  for (int i = 0; i < 20'000; ++i) {
    std::string text(random() % 40, ' ');
    for (char& c : text) c = letters[random() % letters.size()];
    Refused(text);
  }
}

}  // namespace
}  // namespace dockyard
