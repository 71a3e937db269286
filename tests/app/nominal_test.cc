// The nominal parameters, as documented and as sent.
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/program.h"
#include "support/fake_runs.h"
#include "support/program_path.h"
#include "support/source_tree.h"

namespace dockyard {
namespace {

TEST(Nominal, IsDocumentedKeyByKeyAsProgramsGetIt) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "faults").string();
  const std::string command = "python3 '" + SourceFile("tests/app/nominal_check.py") + "' '" +
                              ProgramPath() + "' '" + SourceDir() + "' '" + folder.path().string() +
                              "' >'" + out + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << Slurp(out);
}

}  // namespace
}  // namespace dockyard
