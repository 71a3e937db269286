// Limits of the shell on a process end it with a sentence and exit code 50, never by a signal.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdlib>

#include "app/program.h"
#include "support/fake_runs.h"
#include "support/program_path.h"
#include "support/source_tree.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// The program in a shell with a limit.
Ended Under(const std::string& limit, const std::string& arguments) {
  const TemporaryFolder folder;
  const std::string err = (folder.path() / "err").string();
  const std::string command = "cd '" + SourceDir() + "' && ulimit " + limit + " && '" +
                              ProgramPath() + "' " + arguments + " >/dev/null 2>'" + err + "'";
  const int status = std::system(("bash -c " + ("\"" + command + "\"")).c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), "", Slurp(err)};
}

TEST(Limits, AFileThatMayNotGrowIsAFullDisk) {
  const TemporaryFolder folder;
  const Ended ended =
      Under("-f 1", "run scenarios/axel_typical.yaml --set time_limit_s=0.1 --out " +
                        (folder.path() / "out").string());
  EXPECT_EQ(ended.code, 50);
  EXPECT_THAT(ended.err, HasSubstr("File too large"));
}

TEST(Limits, ASmallStackIsRaisedOrRefused) {
  EXPECT_EQ(Under("-S -s 64", "accept --trials 9 --failures 0 --reliability 0.5").code, 0);
  const Ended ended = Under("-s 64", "accept --trials 9 --failures 0 --reliability 0.5");
  EXPECT_EQ(ended.code, 50);
  EXPECT_THAT(ended.err, HasSubstr("the program's stack may take 64 KiB alone (ulimit -s)"));
}

TEST(Limits, LittleMemoryIsRefused) {
  const Ended ended = Under("-d 8192", "accept --trials 9 --failures 0 --reliability 0.5");
  EXPECT_EQ(ended.code, 50);
  EXPECT_THAT(ended.err, HasSubstr("the program's data may take 8192 KiB alone (ulimit -d)"));
}

}  // namespace
}  // namespace dockyard
