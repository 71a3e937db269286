// What the systems of this program have in common as values of type System: controllers by their
// nominal parameters, and functions on models that are read once.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/plant/model_store.h"
#include "sim/plant/renderer.h"
#include "sim/run/system.h"

namespace dockyard {

/// A controller by the name that scenarios give it.
template <class Nominal>
struct NamedController {
  std::string name;
  std::function<std::unique_ptr<Controller>(const Nominal&)> make;
  std::string former_name{};  // that scenarios of earlier versions give it; empty: none
};

template <class Nominal>
std::vector<ControllerEntry> EntriesOf(const std::vector<NamedController<Nominal>>& controllers,
                                       Nominal (*from_json)(const Json&)) {
  std::vector<ControllerEntry> entries;
  for (const NamedController<Nominal>& controller : controllers) {
    entries.push_back({controller.name,
                       [make = controller.make, from_json](const Json& nominal) {
                         return make(from_json(nominal));
                       },
                       controller.former_name});
  }
  return entries;
}

/// A visit of the keys under a system's own name, with their defaults.
template <class Values>
std::function<void(Keys&)> VisitOf(void (*visit)(Keys&, Values&)) {
  return [visit](Keys& keys) {
    Values values;
    visit(keys, values);
  };
}

/// System::make_ready. PartsOf(nominal) returns a ReadyRun with the counts and names of all parts.
/// The namespace of `Models` has BuildRun(scenario, models) and ToJson(nominal).
template <class Plant, class Judge, auto PartsOf, class Models>
ReadyRun MakeReady(const Scenario& scenario, const Models& models,
                   const std::shared_ptr<KeptRenderer>& renderer) {
  auto plant = std::make_unique<Plant>(scenario, BuildRun(scenario, models), renderer);
  ReadyRun ready = PartsOf(plant->built().nominal);
  ready.nominal = ToJson(plant->built().nominal);
  ready.judge = std::make_unique<Judge>(*plant);
  ready.plant = std::move(plant);
  return ready;
}

/// System::shapes of a plant that has them.
template <class Plant, class Models>
StageShapes ShapesOf(const Scenario& scenario, const Models& models) {
  return Plant(scenario, BuildRun(scenario, models), std::make_shared<KeptRenderer>()).shapes();
}

template <class Models>
struct ModelFunctions {
  std::string (*check)(const Scenario&, const Models&);
  ReadyRun (*make_ready)(const Scenario&, const Models&, const std::shared_ptr<KeptRenderer>&);
  void (*view)(const Scenario&, const Models&, const std::filesystem::path&);
  StageShapes (*shapes)(const Scenario&, const Models&);
};

/// The system's functions of a scenario, on models from the store.
template <class Models>
void UseModels(const std::shared_ptr<ModelStore<Models>>& store,
               const ModelFunctions<Models>& functions, System& system) {
  system.check = [store, check = functions.check](const Scenario& scenario) {
    return check(scenario, *store->Get(scenario));
  };
  const auto renderer = std::make_shared<KeptRenderer>();
  system.make_ready = [store, renderer, make = functions.make_ready](const Scenario& scenario) {
    return make(scenario, *store->Get(scenario), renderer);
  };
  system.view = [store, view = functions.view](const Scenario& scenario,
                                               const std::filesystem::path& dir) {
    view(scenario, *store->Get(scenario), dir);
  };
  system.shapes = [store, shapes = functions.shapes](const Scenario& scenario) {
    return shapes(scenario, *store->Get(scenario));
  };
}

}  // namespace dockyard
