// Calls of the program one after the other in one process: none knows of another.
#include <gmock/gmock.h>

#include "sim/app/program.h"
#include "sim/base/json.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

struct Said {
  int code = 0;
  std::string out, err;
};

/// Commands that need no numbers, as the program starts again for those.
Said Call(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Said said;
  said.code = RunProgram(static_cast<int>(argv.size()), argv.data(), {});
  said.out = testing::internal::GetCapturedStdout();
  said.err = testing::internal::GetCapturedStderr();
  return said;
}

TEST(Invocation, KeepsItsWarningsToItself) {
  const ScratchFolder folder;
  const std::string mesh = folder.Write("mm.obj", "v 0 0 0\nv 400 0 0\nv 0 300 0\nf 1 2 3\n");
  const Said warned = Call({"dockyard", "check", "--json", mesh});
  EXPECT_EQ(Json::parse(warned.out)["warnings"].size(), 1u) << warned.err;
  const Said failed = Call({"dockyard", "check", "--json", "--package", "p", mesh});
  EXPECT_EQ(failed.code, 2);
  EXPECT_EQ(Json::parse(failed.out)["warnings"], Json::array());
}

TEST(Invocation, IsNamedAsItWasCalled) {
  EXPECT_THAT(Call({"first", "xyzzy"}).err, HasSubstr("; first help lists them"));
  EXPECT_THAT(Call({"my tools/second", "xyzzy"}).err, HasSubstr("; 'my tools/second' help lists"));
  EXPECT_THAT(Call({"", "xyzzy"}).err, HasSubstr("; dockyard help lists them"));
}

}  // namespace
}  // namespace dockyard
