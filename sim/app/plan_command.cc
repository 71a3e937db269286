#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/geometry/pose.h"
#include "controller/motion/free_path.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/number_option.h"
#include "sim/base/json.h"

namespace dockyard {
namespace {

struct PlanArguments {
  std::vector<double> point_m{0.0, 0.0}, goal_m;
  std::optional<double> heading_deg;
  double min_radius_m = 0.0;
  int arcs = 2;
  bool forward_only = false, json = false;
};

constexpr const char* kPlanHelp =
    R"(Plan arcs that bring a point of a rover to a goal, after Nesnas, Maimone and Das (2000).

Examples:
  dockyard plan --point 0.6,0 --goal 1.5,0.3
  dockyard plan --point 0.6,0 --goal 2,0.5 --heading-deg -50 --min-radius 0.4 --json
  dockyard plan --point 0,0 --goal 0.3,0.2 --heading-deg 0 --min-radius 0.5 --forward-only --arcs 3

Metres, in the frame of the rover's reference point before it moves: x forward, y left, the centre
of every turn on the y axis. Without --heading-deg one arc leads to the goal. With it two arcs do,
those of least cost by the paper's Eq. (14), twice the longer of both; or three, the shortest found.
An arc has a length, negative backwards, and a turn, counter-clockwise. cost_m of one arc and of
three is their length. Exit code 4: there are no such arcs.)";

struct Plan {
  std::vector<Arc> arcs;
  double cost_m = 0.0;
};

// The rest of the circle, driven the other way.
Arc OtherWayRound(const Arc& arc) {
  const double turn_rad = arc.turn_rad - std::copysign(2.0 * kPi, arc.turn_rad);
  return {arc.length_m * turn_rad / arc.turn_rad, turn_rad};
}

std::optional<Plan> OneArc(const Eigen::Vector2d& goal, const Eigen::Vector2d& point,
                           const ArcLimits& limits) {
  if (goal == point) return Plan{};
  Arc arc{-2.0 * point.x(), 0.0};  // to the point's mirror image every circle leads, and a line
  if (const auto found = OneArcTo(goal, point)) arc = *found;
  if (!Keeps(arc, limits) && arc.turn_rad != 0.0) arc = OtherWayRound(arc);
  if (!Keeps(arc, limits)) return std::nullopt;
  return Plan{{arc}, std::abs(arc.length_m)};
}

std::optional<Plan> SeveralArcs(const Pose2& X_RG, const ArcLimits& limits, int arcs) {
  if (arcs == 2) {
    const auto pair = CheapestPair(X_RG, limits);
    if (!pair) return std::nullopt;
    return Plan{{pair->begin(), pair->end()}, PairCost(*pair)};
  }
  const auto triple = ShortestFreeTriple({}, X_RG, limits, {});
  if (!triple) return std::nullopt;
  const std::vector<Arc> all(triple->begin(), triple->end());
  return Plan{all, Length(all)};
}

void PrintJson(const std::optional<Plan>& plan) {
  Json arcs = Json::array();
  for (const Arc& arc : plan ? plan->arcs : std::vector<Arc>{}) {
    arcs.push_back({{"length_m", arc.length_m}, {"turn_rad", arc.turn_rad}});
  }
  const Json json{{"feasible", plan.has_value()},
                  {"arcs", arcs},
                  {"cost_m", plan ? Json(plan->cost_m) : Json()}};
  std::printf("%s\n", json.dump(2).c_str());
}

void PrintText(const std::optional<Plan>& plan) {
  if (!plan) {
    std::printf("there are no such arcs\n");
    return;
  }
  for (const Arc& arc : plan->arcs) {
    std::printf("arc of %.6f m, turning by %.6f deg", arc.length_m, Degrees(arc.turn_rad));
    if (arc.turn_rad != 0.0) {
      std::printf(", radius %.6f m", std::abs(arc.length_m / arc.turn_rad));
    }
    std::printf("\n");
  }
  std::printf("cost %.6f m\n", plan->cost_m);
}

int PrintPlan(const PlanArguments& in) {
  if (in.arcs == 3 && !in.heading_deg) throw UsageError("--arcs needs --heading-deg");
  const Eigen::Vector2d point(in.point_m[0], in.point_m[1]), goal(in.goal_m[0], in.goal_m[1]);
  const ArcLimits limits{in.min_radius_m, in.forward_only ? Travel::kForward : Travel::kEither};
  std::optional<Plan> plan;
  if (in.heading_deg) {
    const double heading = WrapPi(Radians(*in.heading_deg));
    const Eigen::Vector2d at = goal - Pose2{0.0, 0.0, heading} * point;  // Eq. (13)
    plan = SeveralArcs({at.x(), at.y(), heading}, limits, in.arcs);
  } else {
    plan = OneArc(goal, point, limits);
  }
  if (in.json) {
    PrintJson(plan);
  } else {
    PrintText(plan);
  }
  return plan ? kExitDone : kExitNotDocked;
}

}  // namespace

void AddPlanCommand(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand("plan", kPlanHelp);
  const auto AddPlace = [&](const char* name, std::vector<double>& place, const char* help) {
    return command->add_option(name, place, help)
        ->delimiter(',')
        ->expected(2)
        ->check(NumberWithin(-1e4, 1e4));
  };
  AddPlace("--point", arguments->point_m, "X,Y of the rover's point to bring there [0,0]");
  AddPlace("--goal", arguments->goal_m, "X,Y of where to bring it")->required();
  command->add_option("--heading-deg", arguments->heading_deg, "heading at the goal")
      ->check(NumberWithin(-360.0, 360.0));
  command->add_option("--min-radius", arguments->min_radius_m, "least radius of an arc in m [0]")
      ->check(NumberWithin(0.0, 1e4));
  command->add_flag("--forward-only", arguments->forward_only, "no arc backwards");
  command->add_option("--arcs", arguments->arcs, "2 or 3 arcs to a heading [2]")
      ->check(CLI::IsMember({2, 3}));
  command->add_flag("--json", arguments->json, "the plan as JSON");
  command->callback([arguments, &exit_code] { exit_code = PrintPlan(*arguments); });
}

}  // namespace dockyard
