// What a program's messages come to: values by their names, and a sighting of its marks and pose.
#include "sim/bridge/program_belief.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim/bridge/answer_json.h"

namespace dockyard {
namespace {

using testing::HasSubstr;

/// What is said of one message to a robot of two cameras; empty if it is taken.
std::string Refused(const std::string& text) {
  try {
    ProgramBelief belief(2);
    belief.Take(AnswerFrom(text));
    belief.EndAnswer();
    return "";
  } catch (const AnswerError& error) {
    return error.what();
  }
}

const char* const kMark = R"({"id": 3, "camera": 1, "u_px": 10.5, "v_px": -0.25})";
const char* const kTurned = R"({"R": [0, -1, 0, 1, 0, 0, 0, 0, 1], "p_m": [2, 0.5, -0.1]})";

TEST(ProgramBelief, MakesOneSightingOfTheMarksAndThePoseOfAnAnswer) {
  ProgramBelief belief(2);
  belief.Take(AnswerFrom(std::string(R"({"marks": [)") + kMark + "]}"));
  belief.Take(AnswerFrom(std::string(R"({"pose": )") + kTurned + "}"));
  EXPECT_EQ(belief.belief().sighting_count, 0);
  belief.EndAnswer();
  ASSERT_EQ(belief.belief().sighting_count, 1);
  const SightingReport& report = *belief.belief().last_sighting;
  EXPECT_TRUE(report.accepted);
  EXPECT_THAT(report.detected, testing::ElementsAre(0, 1));
  ASSERT_EQ(report.marks.size(), 1u);
  EXPECT_EQ(report.marks[0].id, 3);
  EXPECT_EQ(report.marks[0].camera, 1);
  EXPECT_EQ(report.marks[0].u_px, 10.5);
  EXPECT_EQ(report.marks[0].v_px, -0.25);
  EXPECT_TRUE(report.X_RB.R.isApprox(RotZ(kPi / 2.0), 1e-12));
  EXPECT_EQ(report.X_RB.p, Eigen::Vector3d(2.0, 0.5, -0.1));
  EXPECT_TRUE(std::isnan(report.reprojection_px));
}

TEST(ProgramBelief, HasNoNewSightingInAnAnswerWithoutMarksAndPose) {
  ProgramBelief belief(2);
  belief.Take(AnswerFrom(std::string(R"({"marks": [)") + kMark + "]}"));
  belief.EndAnswer();
  belief.Take(AnswerFrom(R"({"values": {"a": 1}})"));
  belief.EndAnswer();
  belief.EndAnswer();
  EXPECT_EQ(belief.belief().sighting_count, 1);
}

TEST(ProgramBelief, SaysWhyASightingWithoutAPoseIsNotAccepted) {
  for (const auto& [text, reason] :
       {std::pair{R"({"marks": []})", "nothing found"},
        {R"({"marks": [{"id":0,"camera":0,"u_px":1,"v_px":2}]})", "no pose"}}) {
    ProgramBelief belief(1);
    belief.Take(AnswerFrom(text));
    belief.EndAnswer();
    EXPECT_FALSE(belief.belief().last_sighting->accepted);
    EXPECT_EQ(belief.belief().last_sighting->reason, reason);
  }
}

TEST(ProgramBelief, RefusesMarksOfAnotherShape) {
  const auto with = [](const std::string& marks) { return Refused("{\"marks\": " + marks + "}"); };
  EXPECT_EQ(with(std::string("[") + kMark + "]"), "");
  EXPECT_EQ(with("3"), "marks that are no list");
  EXPECT_EQ(with("null"), "marks that are no list");
  EXPECT_EQ(with("[3]"), "a mark that is no object");
  EXPECT_EQ(with("[{}]"), "a mark without id");
  EXPECT_EQ(with(R"([{"id": 1, "camera": 0, "u_px": 1}])"), "a mark without v_px");
  for (const char* id : {"-1", "1.5", "1000000", "1e30", "\"a\"", "true"}) {
    EXPECT_THAT(with("[{\"id\": " + std::string(id) + R"(, "camera": 0, "u_px": 1, "v_px": 1}])"),
                HasSubstr("whose id is no whole number from 0 to 999999"))
        << id;
  }
  for (const char* camera : {"2", "-1", "18446744073709551615"}) {
    EXPECT_THAT(
        with("[{\"id\": 1, \"camera\": " + std::string(camera) + R"(, "u_px": 1, "v_px": 1}])"),
        HasSubstr("whose camera is no whole number from 0 to 1"))
        << camera;
  }
  EXPECT_EQ(with(R"([{"id": 1, "camera": 0, "u_px": 1e6, "v_px": 1}])"),
            "a mark's u_px that is too large");
  EXPECT_EQ(with(R"([{"id": 1, "camera": 0, "u_px": "1", "v_px": 1}])"),
            "a mark's u_px that is no number");
  std::string many = kMark;
  for (std::size_t i = 1; i < kMostMarks; ++i) many += std::string(",") + kMark;
  EXPECT_EQ(with("[" + many + "]"), "");
  EXPECT_EQ(with("[" + many + "," + kMark + "]"), "more than 256 marks");
}

TEST(ProgramBelief, RefusesMarksOfARobotWithoutCameras) {
  ProgramBelief belief(0);
  EXPECT_THROW(belief.Take(AnswerFrom(std::string(R"({"marks": [)") + kMark + "]}")), AnswerError);
}

TEST(ProgramBelief, RefusesAPoseOfAnotherShape) {
  const auto with = [](const std::string& pose) { return Refused("{\"pose\": " + pose + "}"); };
  EXPECT_EQ(with(kTurned), "");
  EXPECT_EQ(with("[]"), "a pose that is no object");
  EXPECT_EQ(with(R"({"p_m": [1, 2, 3]})"), "a pose without R");
  EXPECT_EQ(with(R"({"R": [1, 0, 0, 0, 1, 0, 0, 0, 1]})"), "a pose without p_m");
  EXPECT_EQ(with(R"({"R": [1, 0, 0, 0, 1, 0, 0, 0], "p_m": [1, 2, 3]})"),
            "a pose whose R is no list of 9 numbers");
  EXPECT_EQ(with(R"({"R": [1, 0, 0, 0, 1, 0, 0, 0, 1], "p_m": [1, 2, "3"]})"),
            "a number of a pose's p_m that is no number");
  EXPECT_EQ(with(R"({"R": [1, 0, 0, 0, 1, 0, 0, 0, 1], "p_m": [1, 2, 1e7]})"),
            "a number of a pose's p_m that is too large");
  for (const char* R : {"[1, 0, 0, 0, 1, 0, 0, 0, -1]", "[1, 0, 0, 0, 1, 0, 0, 0, 1.1]",
                        "[0, 0, 0, 0, 0, 0, 0, 0, 0]", "[1, 0.1, 0, 0, 1, 0, 0, 0, 1]"}) {
    EXPECT_EQ(with(std::string("{\"R\": ") + R + R"(, "p_m": [1, 2, 3]})"),
              "a pose whose R is no rotation")
        << R;
  }
}

TEST(ProgramBelief, BoundsTheSightingsAndMarksOfARun) {
  ProgramBelief belief(2);
  std::string marks = kMark;
  for (std::size_t i = 1; i < kMostMarks; ++i) marks += std::string(",") + kMark;
  const Json full = AnswerFrom("{\"marks\": [" + marks + "]}");
  const auto answer = [&] {
    belief.Take(full);
    belief.EndAnswer();
  };
  for (std::size_t i = 0; i < kMostMarksOfRun / kMostMarks; ++i) answer();
  EXPECT_THROW(answer(), AnswerError);
  ProgramBelief other(2);
  const Json none = AnswerFrom(R"({"marks": []})");
  for (int i = 0; i < kMostSightings; ++i) {
    other.Take(none);
    other.EndAnswer();
  }
  other.Take(none);
  EXPECT_THROW(other.EndAnswer(), AnswerError);
}

TEST(ProgramBelief, BoundsTheNamesOfValuesInARun) {
  ProgramBelief belief(2);
  for (int i = 0; i < 1024; ++i) belief.Take(Json{{"values", {{"v" + std::to_string(i), i}}}});
  belief.Take(Json{{"values", {{"v7", 1}}}});
  EXPECT_THROW(belief.Take(Json{{"values", {{"one more", 1}}}}), AnswerError);
}

TEST(ProgramBelief, OfAnyBytesIsTakenOrRefused) {
  std::mt19937 random(5);
  const std::string good = std::string(R"({"marks": [)") + kMark + R"(], "pose": )" + kTurned +
                           R"(, "values": {"a": 1}, "phase": "p"})";
  const std::string letters = "{}[]\",:0123456789.eE-null\xc3\xe2\x80\xae";
  int taken = 0;
  for (int i = 0; i < 5'000; ++i) {
    std::string text = good;
    for (int edits = 1 + static_cast<int>(random() % 3); edits > 0; --edits) {
      text[random() % text.size()] = letters[random() % letters.size()];
    }
    taken += Refused(text).empty();
  }
  EXPECT_GT(taken, 50);
  EXPECT_LT(taken, 4'950);
}

TEST(ProgramBelief, KeepsPhaseAndNoteOnOneLine) {
  ProgramBelief belief(2);
  EXPECT_EQ(belief.belief().phase, "external");
  belief.Take(Json{{"phase", "a\nb\x1b[2J"}});
  EXPECT_EQ(belief.belief().phase, "a?b?[2J");
  EXPECT_EQ(Refused(R"({"note": 3})"), "a phase or note that is no text");
}

}  // namespace
}  // namespace dockyard
