#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/read/load_obstacles.h"
#include "models/read/load_rover.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/number_option.h"
#include "sim/app/terminal.h"
#include "sim/base/files.h"
#include "sim/page/report_page.h"
#include "sim/paths/path_json.h"
#include "sim/paths/path_svg.h"
#include "sim/paths/path_watch.h"

namespace dockyard {
namespace {

struct PlanArguments {
  std::vector<double> point_m, goal_m, in_view_m;
  std::optional<double> heading_deg;
  double min_radius_m = 0.0, margin_m = 0.05;
  int arcs = 2;
  bool forward_only = false, pivot = false, json = false;
  std::string robot, obstacles, svg, page;
};

constexpr const char* kPlanHelp =
    R"(Plan arcs that bring a point of a rover to a goal, after Nesnas et al. (2000).

Examples:
  dockyard plan --point 0.6,0 --goal 1.5,0.3
  dockyard plan --point 0.6,0 --goal 2,0.5 --heading-deg -50 --min-radius 0.4 --json
  dockyard plan --point 0,0 --goal 0.3,0.2 --heading-deg 0 --min-radius 0.5 --forward-only --arcs 3
  dockyard plan --robot models/rovers/rocky7.yaml --obstacles examples/obstacles.yaml \
    --goal 2.6,0.8 --heading-deg 10 --svg out/plan.svg --page out/plan.html

Metres, in the frame of the rover's reference point before it moves: x forward, y left, the centre
of every turn on the y axis. Without --heading-deg one arc leads to the goal. With it two arcs do,
those of least cost by the paper's Eq. (14), twice the longer of both; or three, the shortest found.
An arc has a length, negative backwards, and a turn, counter-clockwise. cost_m of one arc and of
three is their length. A rover's file has its wheels, whose steering limits hold. The rover turns in
place with --pivot alone. Without --min-radius its arcs have a radius of 1 m or more; where no such
arcs lead to the goal, they are as sharp as its wheels steer. The file has the rover's outline,
which keeps the margin from all obstacles: a YAML file of discs and areas, or a CSV file of up to
100 000 discs with the columns x_m, y_m, radius_m. Candidates are shown for one and two arcs, not
for three.
Exit code 4: there are no such arcs.)";

constexpr std::size_t kManyDiscs = 1000;  // fewer are compared one by one as quickly

struct Request {
  PathTask task;
  std::vector<ArcLimits> limits;  // the first ones with a path count
  bool json = false;
  std::string svg, page;
};

// Turns in place "are not reliable" and are to be eliminated (Nesnas, Maimone and Das, III-B).
std::vector<ArcLimits> LimitsToTry(const PlanArguments& in, const RoverPlan& rover) {
  const Travel travel = in.forward_only ? Travel::kForward : Travel::kEither;
  ArcLimits limits = LimitsOf(rover.wheels, travel);
  if (in.pivot) return {limits};
  limits.pivot_radius_m.reset();
  ArcLimits gentle = limits;
  const bool given = in.min_radius_m > 0.0 || in.robot.empty();
  gentle.least_radius_m =
      std::max(limits.least_radius_m, given ? in.min_radius_m : kGentleRadius_m);
  // Wheels without a limit could turn in place.
  if (given || limits.least_radius_m == 0.0) return {gentle};
  return {gentle, limits};
}

// Leaves the limits that counted in the task.
PlannedPath PlanFirst(const std::vector<ArcLimits>& limits, PathTask& task) {
  PlannedPath plan;
  for (const ArcLimits& each : limits) {
    task.limits = each;
    plan = PlanPath(task);
    if (plan.best) break;
  }
  return plan;
}

Eigen::Vector2d Place(const std::vector<double>& xy) { return {xy[0], xy[1]}; }

Request RequestOf(const PlanArguments& in) {
  if (in.arcs == 3 && !in.heading_deg) throw UsageError("--arcs needs --heading-deg");
  if (in.robot.empty()) {
    if (!in.obstacles.empty()) throw UsageError("--obstacles needs --robot, for its outline");
    if (!in.page.empty()) throw UsageError("--page needs --robot, to show it");
    if (in.pivot) throw UsageError("--pivot needs --robot, whose wheels may turn in place");
    if (!in.in_view_m.empty()) throw UsageError("--keep-in-view needs --robot, for its cameras");
  }
  Request request{{}, {}, in.json, in.svg, in.page};
  PathTask& task = request.task;
  if (!in.robot.empty()) task.rover = LoadRoverPlan(in.robot);
  task.p_RP = in.point_m.empty() ? task.rover.p_RP : Place(in.point_m);
  task.p_AG = Place(in.goal_m);
  if (in.heading_deg) task.heading = Radians(*in.heading_deg);
  request.limits = LimitsToTry(in, task.rover);
  task.arcs = in.arcs;
  if (!in.obstacles.empty()) {
    task.demands.obstacles = LoadObstacles(in.obstacles);
    task.demands.margin_m = in.margin_m;
    if (task.demands.obstacles.discs.size() > kManyDiscs) {
      task.demands = WithGrid(std::move(task.demands));
    }
  }
  if (!in.in_view_m.empty()) {
    if (!task.rover.view) throw UsageError("--keep-in-view needs a rover with a view");
    task.demands.p_AT = Place(in.in_view_m);
  }
  return request;
}

void PrintText(const PlannedPath& plan) {
  if (!plan.best) {
    std::printf("there are no such arcs\n");
    return;
  }
  for (const Arc& arc : plan.best->arcs) {
    std::printf("arc of %.6f m, turning by %.6f deg", arc.length_m, Degrees(arc.turn_rad));
    if (arc.turn_rad != 0.0) {
      std::printf(", radius %.6f m", std::abs(arc.length_m / arc.turn_rad));
    }
    std::printf("\n");
  }
  std::printf("cost %.6f m\n", plan.best->cost_m);
}

// The report's page with one run: the rover on its path.
std::string PageOf(const PathTask& task, const PlannedPath& plan) {
  RunResult row;
  row.run = 1;
  row.system = task.rover.name;
  row.controller = "arcs";
  row.success = true;
  row.outcome = "reached";
  const LoggedRun watched = WatchedPath(task, plan);
  row.sim_time_s = watched.times_s.back();
  row.measures = {plan.best->cost_m, Length(plan.best->arcs)};
  FinishedRuns runs;
  runs.Add({row, {}, ""});
  ReportContent content;
  content.title = "A path of " + task.rover.name;
  content.program = std::string("dockyard ") + DOCKYARD_VERSION;
  content.runs = &runs;
  content.columns = {{},
                     {{"cost_m", "m", "Eq. (14): twice the longer of two arcs, else the length"},
                      {"length_m", "m", "of the reference point's way"}},
                     {{"reached", true, "the path leads to the goal"}}};
  content.channels = WatchedChannels(task.rover);
  content.system = task.rover.name;
  content.watched = {{0, [&] { return watched; }, [&] { return ShapesOf(task); }, "", ""}};
  return ReportPage(content);
}

void WarnOf(const Request& request, const PlannedPath& plan, std::vector<std::string>* warnings) {
  const PathTask& task = request.task;
  const PathDemands& demands = task.demands;
  const auto CheckAt = [&](const Pose2& X_AR, const char* where) {
    const double clear_m = StandingClearance(task.rover, X_AR, demands.obstacles, demands.margin_m);
    if (clear_m >= demands.margin_m) return;
    Warn(std::string("the rover is nearer to an obstacle than --margin ") + where, warnings);
  };
  if (!plan.best) {
    CheckAt({}, "where it starts");
    if (task.heading) CheckAt(GoalPose(task), "at the goal");
  }
  if (!request.page.empty() && plan.best && demands.obstacles.discs.size() > kMostShownDiscs) {
    Warn(request.page + " shows the " + std::to_string(kMostShownDiscs) +
             " discs nearest to the start and the goal",
         warnings);
  }
}

int PrintPlan(Request request, Invocation& call) {
  const PlannedPath plan = PlanFirst(request.limits, request.task);
  WarnOf(request, plan, &call.warnings);
  if (!request.svg.empty()) WriteWhole(request.svg, PathSvg(request.task, plan));
  if (!request.page.empty() && plan.best) WriteWhole(request.page, PageOf(request.task, plan));
  if (request.json) {
    std::printf("%s\n", PathJson(request.task, plan, call.warnings).dump(2).c_str());
  } else {
    PrintText(plan);
  }
  return plan.best ? kExitDone : kExitNoSuccess;
}

}  // namespace

void AddPlanCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand("plan", kPlanHelp);
  const auto AddPlace = [&](const char* name, std::vector<double>& place, const char* help) {
    return command->add_option(name, place, help)
        ->delimiter(',')
        ->expected(2)
        ->check(NumberWithin(-1e4, 1e4));
  };
  AddPlace("--point", arguments->point_m, "X,Y of the rover's point to bring there [its own]");
  AddPlace("--goal", arguments->goal_m, "X,Y of where to bring it")->required();
  command->add_option("--heading-deg", arguments->heading_deg, "heading at the goal")
      ->check(NumberWithin(-360.0, 360.0));
  CLI::Option* min_radius =
      command->add_option("--min-radius", arguments->min_radius_m, "least radius of an arc in m")
          ->check(NumberWithin(0.0, 1e4));
  command->add_flag("--pivot", arguments->pivot, "turns in place are allowed")
      ->excludes(min_radius);
  command->add_flag("--forward-only", arguments->forward_only, "no arc backwards");
  command->add_option("--arcs", arguments->arcs, "2 or 3 arcs to a heading [2]")
      ->check(CLI::IsMember({2, 3}));
  command->add_option("--robot", arguments->robot, "file of a rover, as in models/rovers");
  command->add_option("--obstacles", arguments->obstacles,
                      "YAML of discs and areas, or CSV of discs");
  command->add_option("--margin", arguments->margin_m, "m to keep from obstacles [0.05]")
      ->check(NumberWithin(0.0, 1e3));
  AddPlace("--keep-in-view", arguments->in_view_m,
           "X,Y that the rover's camera must see all along");
  command->add_option("--svg", arguments->svg, "file for a drawing with all candidates");
  command->add_option("--page", arguments->page, "HTML file in which the rover drives the path");
  command->add_flag("--json", arguments->json, "the plan as JSON");
  command->callback(
      [arguments, &call] { call.exit_code = PrintPlan(RequestOf(*arguments), call); });
}

}  // namespace dockyard
