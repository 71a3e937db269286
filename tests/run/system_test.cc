// A system by its name, its controllers and its columns.
#include "sim/run/system.h"

#include <gmock/gmock.h>

#include "models/read/config_error.h"
#include "sim/bridge/pipe_controller.h"

namespace dockyard {
namespace {

using testing::ElementsAre;

System Named(const std::string& name) {
  System system;
  system.name = name;
  system.controllers = {{"first", {}}, {"second", {}, "former"}};
  system.columns.outcomes = {{"docked", true, ""}, {"lost", false, ""}};
  system.columns.measures = {{"depth_m", "m", ""}};
  system.scenario.file_keys = {"flag"};
  return system;
}

std::string MessageIn(const std::function<void()>& call) {
  try {
    call();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "(no error)";
}

TEST(System, IsFoundByItsNameOrAllAreNamed) {
  const std::vector<System> systems{Named("boat"), Named("cart")};
  EXPECT_EQ(&FindSystem(systems, "cart"), &systems[1]);
  EXPECT_EQ(MessageIn([&] { FindSystem(systems, "car"); }),
            "system: expected one of boat, cart, found 'car'");
}

TEST(System, GivesAControllerByItsNameOrNamesAll) {
  const System system = Named("boat");
  EXPECT_EQ(&system.RequireController("second"), &system.controllers[1]);
  // A former name is the scenario reader's to replace.
  EXPECT_EQ(MessageIn([&] { system.RequireController("former"); }),
            "controller: expected one of first, second, found 'former'");
}

TEST(System, IsKnownToReadersWithItsOwnNameAndControllers) {
  const std::vector<KnownSystem> known = KnownSystems({Named("boat"), Named("cart")});
  ASSERT_EQ(known.size(), 2u);
  EXPECT_EQ(known[1].name, "cart");
  EXPECT_THAT(known[1].controllers, ElementsAre("first", "second"));
  EXPECT_THAT(known[1].file_keys, ElementsAre("flag"));
  ASSERT_EQ(known[1].former_controllers.size(), 1u);
  EXPECT_EQ(known[1].former_controllers[0].former, "former");
  EXPECT_EQ(known[1].former_controllers[0].now, "second");
}

TEST(System, HasTheOutcomesOfEveryRunBehindItsOwn) {
  const RowColumns columns = Named("boat").Columns({"soil"});
  EXPECT_THAT(columns.labels, ElementsAre("soil"));
  ASSERT_EQ(columns.measures.size(), 1u);
  std::vector<std::string> names;
  for (const OutcomeName& outcome : columns.outcomes) {
    names.push_back(outcome.name);
    EXPECT_EQ(columns.IsSuccess(outcome.name), outcome.name == "docked");
  }
  EXPECT_THAT(names, ElementsAre("docked", "lost", kControllerCrashed, kControllerTimeout,
                                 kControllerError, kCrashed, kStopped));
  EXPECT_FALSE(columns.IsSuccess("unheard of"));
}

}  // namespace
}  // namespace dockyard
