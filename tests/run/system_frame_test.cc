// What systems have in common as values of type System.
#include "sim/run/system_frame.h"

#include <gmock/gmock.h>

#include "run/cart.h"
#include "sim/scenario/keys.h"

namespace dockyard::cart {
namespace {

using testing::ElementsAre;

struct CartModels {
  double length_m = 0.0;
};

int g_loads = 0;  // of the models, by all tests
CartModels LoadCart(const Scenario& scenario, MeshStore*) {
  ++g_loads;
  return {scenario.of_system.kind == YamlNode::Kind::kNull ? 1.0 : 2.0};
}

Built BuildRun(const Scenario&, const CartModels& models) { return {{0.5}, {models.length_m}}; }

ReadyRun PartsOf(const Nominal&) {
  ReadyRun ready;
  ready.motor_count = 1;
  ready.control_period = 40;
  return ready;
}

class CartJudge final : public Judge {
 public:
  explicit CartJudge(const CartPlant& plant) : plant_(plant) {}
  void Observe() override {}
  void ObserveSighting(const SightingReport&) override {}
  bool fatal() const override { return plant_.tick() > 0; }
  Conclusion Conclude(const Commands&, const Belief&, const TrialWatch&) override { return {}; }

 private:
  const CartPlant& plant_;
};

ReadyRun MakeCart(const Scenario& scenario, const CartModels& models,
                  const std::shared_ptr<KeptRenderer>& renderer) {
  return MakeReady<CartPlant, CartJudge, PartsOf>(scenario, models, renderer);
}
std::string CheckCart(const Scenario&, const CartModels& models) {
  return "a cart of " + std::to_string(models.length_m);
}
void ViewCart(const Scenario&, const CartModels&, const std::filesystem::path&) {
  throw std::runtime_error("viewed");
}
StageShapes ShapesOfCart(const Scenario&, const CartModels& models) {
  StageShapes shapes;
  shapes.ground_grain = models.length_m;
  return shapes;
}

System CartSystem() {
  System system;
  UseModels(std::make_shared<ModelStore<CartModels>>(LoadCart),
            {CheckCart, MakeCart, ViewCart, ShapesOfCart}, system);
  return system;
}

Commands OneMotor() {
  Commands commands;
  commands.motors.resize(1);
  return commands;
}

TEST(SystemFrame, ReadsModelsOnceForAllFunctionsOfASystem) {
  const System system = CartSystem();
  Scenario scenario;
  const int before = g_loads;
  EXPECT_EQ(system.check(scenario), "a cart of " + std::to_string(1.0));
  EXPECT_EQ(system.make_ready(scenario).nominal.at("length_m"), 1.0);
  EXPECT_EQ(system.shapes(scenario).ground_grain, 1.0);
  EXPECT_THROW(system.view(scenario, {}), std::runtime_error);
  EXPECT_EQ(g_loads, before + 1);
  scenario.of_system = ParseYaml("{length_m: 2}", "s.yaml");
  EXPECT_EQ(system.shapes(scenario).ground_grain, 2.0);
  EXPECT_EQ(g_loads, before + 2);
}

TEST(SystemFrame, MakesAPlantOfItsOwnForEachRunWithOneRenderer) {
  const System system = CartSystem();
  const ReadyRun first = system.make_ready({}), second = system.make_ready({});
  const auto* one = dynamic_cast<CartPlant*>(first.plant.get());
  const auto* two = dynamic_cast<CartPlant*>(second.plant.get());
  ASSERT_TRUE(one != nullptr && two != nullptr && one != two);
  EXPECT_TRUE(one->renderer() != nullptr && one->renderer() == two->renderer());
  first.plant->Advance(OneMotor());
  EXPECT_EQ(first.plant->tick(), 20);
  EXPECT_EQ(second.plant->tick(), 0);
  // Each judge has its own run's plant.
  EXPECT_TRUE(first.judge->fatal());
  EXPECT_FALSE(second.judge->fatal());
}

TEST(SystemFrame, MakesARunWithThePartsOfItsNominalRobot) {
  const ReadyRun ready = MakeCart({}, {3.5}, std::make_shared<KeptRenderer>());
  EXPECT_EQ(ready.nominal.dump(), R"({"length_m":3.5})");
  EXPECT_EQ(ready.motor_count, 1);
  EXPECT_EQ(ready.control_period, 40);
}

TEST(SystemFrame, MakesControllersFromTheirNominalParameters) {
  std::vector<double> lengths;
  const std::vector<NamedController<Nominal>> named{
      {"short",
       [&](const Nominal& nominal) { return lengths.push_back(nominal.length_m), nullptr; }},
      {"long",
       [&](const Nominal& nominal) { return lengths.push_back(10.0 * nominal.length_m), nullptr; },
       "tall"}};
  const std::vector<ControllerEntry> entries = EntriesOf(named, FromJson);
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].name, "short");
  EXPECT_EQ(entries[0].former_name, "");
  EXPECT_EQ(entries[1].former_name, "tall");
  entries[1].make({{"length_m", 2.0}});
  entries[0].make({{"length_m", 3.0}});
  EXPECT_THAT(lengths, ElementsAre(20.0, 3.0));
  EXPECT_THROW(entries[0].make({{"width_m", 2.0}}), Json::exception);
}

struct CartKeys {
  double load_kg = 4.0;
};
void VisitCart(Keys& keys, CartKeys& values) {
  keys.Number({"load_kg", "kg", "on the cart"}, values.load_kg, NonNegative(10.0));
}

TEST(SystemFrame, NamesTheKeysOfASystemWithTheirDefaults) {
  const std::vector<KeyRow> rows = DocumentKeys(VisitOf(VisitCart));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].key, "load_kg");
  EXPECT_EQ(rows[0].unit, "kg");
  EXPECT_EQ(rows[0].default_text, "4");
}

}  // namespace
}  // namespace dockyard::cart
