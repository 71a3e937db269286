// What the program says to people, whatever the words are that it quotes.
#include <gmock/gmock.h>

#include <algorithm>

#include "app/program.h"
#include "sim/base/json.h"
#include "support/fake_runs.h"
#include "support/program_path.h"

namespace dockyard {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

bool HasControl(const std::string& text) {
  const bool c0 = std::any_of(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f;
  });
  return c0 || text.find("\xC2\x85") != text.npos || text.find("\xC2\x9B") != text.npos;
}

TEST(Messages, ShowControlCharactersAsEscapes) {
  const std::string harm = "'a\xC2\x85z\x1b[31mz\xC2\x9Bz\xE9'";
  for (const std::string command :
       {"run scenarios/axel_typical.yaml --set ", "run scenarios/axel_typical.yaml --set name=",
        "run scenarios/axel_typical.yaml --set light=", "run ", "report ", "", "run --", "help ",
        "campaign scenarios/ci_4.yaml --set vary=", "submit scenarios/ci_4.yaml --slurm=--",
        "submit scenarios/ci_4.yaml --slurm=--qos=", "accept --reliability ", "check --package ",
        "check "}) {
    const Ended ended = Dockyard(command + harm);
    EXPECT_NE(ended.code, 0) << command;
    EXPECT_FALSE(HasControl(ended.err)) << command << ended.err;
    EXPECT_EQ(ended.out, "") << command;
  }
}

TEST(Messages, CountOneThingInTheSingular) {
  EXPECT_THAT(Dockyard("accept --trials 1 --failures 1 --reliability 0.5").out,
              StartsWith("1 trial, 1 failure: "));
  EXPECT_THAT(Dockyard("compare --only-a 1 --only-b 0").out,
              StartsWith("only A succeeded 1 time, only B 0 times: "));
}

TEST(Messages, AreTheSameInJson) {
  const Ended ended = Dockyard("run 'a\xE9\xC2\x85.yaml' --json");
  EXPECT_EQ(ended.code, 3);
  const Json error = Json::parse(ended.out)["error"];
  EXPECT_EQ(ended.err, "error: " + error["text"].get<std::string>() + "\n");
  EXPECT_EQ(error["file"], "a\\xe9\\u0085.yaml");
}

TEST(Messages, SaysOfWhichKindAFileIsThatItCannotRun) {
  for (const std::string wanted : {"campaign", "scenario"}) {
    for (const auto& [file, kind] : {std::pair("models/axel/axel.yaml", "rover"),
                                     {"models/soils/loose_sand.yaml", "soil"},
                                     {"models/axel/axel.urdf", "urdf"}}) {
      const Ended ended =
          Dockyard((wanted == "campaign" ? "campaign " : "run ") + std::string(file));
      EXPECT_EQ(ended.code, 3) << file;
      EXPECT_THAT(ended.err, StartsWith("error: " + std::string(file) + ": expected a " + wanted +
                                        ", found a file of the kind '" + kind + "'; a " + wanted +
                                        " has the key"));
      EXPECT_THAT(ended.err, HasSubstr("(docs/reference/" + wanted + "s.md)"));
    }
  }
}

TEST(Messages, LeadsToTheHelpOfASystemsOwnDetect) {
  const std::string detect = "detect a.png --robot models/raposa/raposa.yaml ";
  const Ended unknown = Dockyard(detect + "--board models/axel/station/station.yaml");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_EQ(unknown.err,
            "error: detect, for the system raposa: unknown option "
            "'--board'; " +
                ProgramPath() + " detect --robot FILE --help lists the options\n");
  EXPECT_THAT(Dockyard(detect + "--draww x.png").err, EndsWith("did you mean '--draw'?\n"));
  EXPECT_THAT(Dockyard("tune").err, HasSubstr("; " + ProgramPath() + " help tune shows"));
}

}  // namespace
}  // namespace dockyard
