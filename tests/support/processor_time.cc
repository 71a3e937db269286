// At its end each test program prints the processor time that it and its children took:
// scripts/test_times reads it.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>

namespace dockyard {
namespace {

double Seconds(int whose) {
  rusage used{};
  getrusage(whose, &used);
  return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

class ProcessorTime final : public testing::Environment {
  void TearDown() override {
    const char* cost = std::getenv("DOCKYARD_TEST_COST");  // of ctest: see tests/CMakeLists.txt
    if (cost == nullptr) return;
    std::printf("processor time: %.2f s, COST %s\n",
                Seconds(RUSAGE_SELF) + Seconds(RUSAGE_CHILDREN), cost);
    std::fflush(stdout);
  }
};

[[maybe_unused]] const testing::Environment* const kAdded =
    testing::AddGlobalTestEnvironment(new ProcessorTime);

}  // namespace
}  // namespace dockyard
