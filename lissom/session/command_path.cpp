#include "lissom/session/command_path.h"

#include <algorithm>
#include <fmt/format.h>

#include "lissom/mechanics/membrane_strain.h"
#include "lissom/session/fields.h"
#include "lissom/session/path_json.h"
#include "lissom/session/place_name.h"
#include "lissom/session/pose_files.h"
#include "lissom/view/chart.h"

namespace lissom {

namespace {

constexpr PathEndInfo kEnds[] = {
    {PathEnd::kReached, "reached", 0},
    {PathEnd::kStoppedAtCritical, "stopped_at_critical", 0},
    {PathEnd::kStepTooSmall, "step_too_small", 13},
    {PathEnd::kIterationLimit, "iteration_limit", 12},
    {PathEnd::kCancelled, "cancelled", 15},
    {PathEnd::kBadStart, "bad_start", 16},
};

LoadPath load_path(const Pose& pose, const PathCommand& command) {
  LoadPath path = pose.path.value_or(LoadPath{});
  path.from = command.from.value_or(path.from);
  path.to = command.to.value_or(path.to);
  path.steps = command.steps.value_or(path.steps);
  path.follow = command.follow.value_or(path.follow);
  path.stop_at_critical = path.stop_at_critical || command.stop_at_critical;
  path.switch_branch = path.switch_branch || command.switch_branch;
  return path;
}

Status check_path(const LoadPath& path) {
  if (const Status s = check_load_factor(path.from, "--from"); !s) return s;
  if (const Status s = check_load_factor(path.to, "--to"); !s) return s;
  if (path.from == path.to) {
    return Error{ErrorCode::kRange, "--to", "the path begins and ends at the same load factor",
                 "choose another --from or --to"};
  }
  if (path.stop_at_critical && path.switch_branch) {
    return Error{ErrorCode::kConflict, "--switch-branch",
                 "a path cannot stop at the first critical point and go on from it",
                 "leave out one of --stop-at-critical and --switch-branch"};
  }
  return {};
}

/// The node that is farthest from its drawn place at any point of the path.
int most_moved(const System& system, const PathResult& path) {
  int node = 0;
  double farthest = -1;
  for (const PathPoint& point : path.points) {
    for (int i = 0; i < system.layout.nodes(); ++i) {
      const double moved = (point.state.position(i) - system.structure.nodes[i]).norm();
      if (moved > farthest * (1 + 1e-9)) {
        farthest = moved;
        node = i;
      }
    }
  }
  return node;
}

double displacement(const System& system, const State& state, const std::vector<int>& nodes,
                    const std::optional<Vec3>& axis) {
  Vec3 sum = Vec3::Zero();
  for (const int node : nodes) sum += state.position(node) - system.structure.nodes[node];
  sum /= static_cast<double>(nodes.size());
  return axis ? sum.dot(axis->normalized()) : sum.norm();
}

Chart path_chart(const std::string& title, const FollowedPose& followed) {
  Chart chart;
  chart.title = title;
  chart.x.label = "displacement of " + followed.watched;
  chart.x.unit = "mm";
  chart.x.display_scale = 1000;
  chart.y.label = "load factor";
  // Stable and unstable stretches are series of their own; they share the point between them.
  ChartSeries stable{.name = "stable", .style = ChartSeries::Style::kLineAndPoints}, unstable = stable;
  unstable.name = "unstable";
  const double gap = std::numeric_limits<double>::quiet_NaN();
  for (size_t i = 0; i < followed.path.points.size(); ++i) {
    const bool here = followed.path.points[i].negative_modes == 0;
    const double x = followed.table.rows[i][1], y = followed.table.rows[i][0];
    stable.x.push_back(x);
    unstable.x.push_back(x);
    stable.y.push_back(here ? y : gap);
    unstable.y.push_back(here ? gap : y);
  }
  chart.series.push_back(std::move(stable));
  if (std::any_of(followed.path.points.begin(), followed.path.points.end(),
                  [](const PathPoint& p) { return p.negative_modes > 0; })) {
    chart.series.push_back(std::move(unstable));
  }
  for (const CriticalPoint& point : followed.path.critical) {
    chart.guides.push_back({ChartGuide::Direction::kHorizontal, point.load_factor,
                            fmt::format("{} {:.6g}", critical_kind_name(point.kind), point.load_factor)});
  }
  return chart;
}

Status write_files(const Document& document, const Pose& pose, const System& system, const std::string& stem,
                   const PathCommand& command, FollowedPose& followed, Output& output) {
  const PathResult& path = followed.path;
  if (const Status s = output.write(stem + "-path.json", path_text(document, followed)); !s) return s;
  if (path.points.empty()) return {};
  if (const Status s = output.write(stem + "-path.csv", csv_text(followed.table)); !s) return s;
  const std::string title = (document.model.title.empty() ? document.name : document.model.title) + ", " + pose.name;
  const std::string ending = command.picture == ImageFormat::kSvg ? ".svg" : ".png";
  if (const Status s = output.write(stem + "-path" + ending, draw_chart(path_chart(title, followed), command.picture));
      !s)
    return s;
  if (command.vtu == ParaView::kNo) return {};
  std::vector<double> times;
  for (const PathPoint& point : path.points) times.push_back(point.state.load_factor);
  return write_series(
      stem + "-path", times,
      [&](int i) {
        const PathPoint& point = path.points[i];
        const double share = stretch_share(pose, point.state.load_factor);
        return draw_state({document.model, system, point.state, &point.reaction, share}, nullptr);
      },
      output);
}

}  // namespace

const PathEndInfo& path_end_info(PathEnd end) {
  for (const PathEndInfo& info : kEnds) {
    if (info.end == end) return info;
  }
  LISSOM_ASSERT(false);
  return kEnds[0];
}

std::string_view critical_kind_name(CriticalKind kind) { return kind == CriticalKind::kFold ? "fold" : "bifurcation"; }

Result<std::vector<FollowedPose>> path_command(const Document& document, const PathCommand& command,
                                               const Context& context) {
  if (const Status s = command.options.validate(); !s) return s.error();
  const Model& model = document.model;
  const Result<std::vector<int>> poses = pose_numbers(model, command.poses);
  if (!poses) return poses.error();
  const Result<System> made = make_system(model);
  if (!made) return made.error();
  const System& system = made.value();
  std::vector<int> watched;
  if (!command.watch.empty()) {
    const Result<Selector> place = parse_place(model, command.watch, "--watch");
    if (!place) return place.error();
    Result<std::vector<int>> nodes = select(model, system.structure, place.value(), "--watch");
    if (!nodes) return nodes.error();
    watched = std::move(nodes).value();
  }
  Output output(command.folder);
  if (const Status s = output.prepare(); !s) return s.error();
  const std::vector<std::string> stems = pose_file_names(document);
  std::vector<FollowedPose> results;
  for (const int p : poses.value()) {
    const Pose& pose = model.poses[p];
    const LoadPath path = load_path(pose, command);
    if (const Status s = check_path(path); !s) return s.error();
    const std::string where = "/poses/" + std::to_string(p);
    if (pose.form_finding) {
      return Error{ErrorCode::kConflict, where + "/form_finding",
                   "pose \"" + pose.name + "\" finds a form, so there is no path to follow",
                   "choose other poses with --pose, or use `lissom solve`"};
    }
    const Result<StaticProblem> problem = make_static_problem(model, system, pose, where);
    if (!problem) return problem.error();
    FollowedPose followed;
    followed.pose = pose.name;
    followed.path =
        follow_path(problem.value(), start_state(problem.value(), pose), path, {.solve = command.options}, context);
    const std::vector<int> nodes = watched.empty() ? std::vector<int>{most_moved(system, followed.path)} : watched;
    followed.watched = watched.empty() ? fmt::format("node {}", nodes.front()) : command.watch;
    followed.table.columns = {"load_factor",    "displacement_m", "energy_J", "lowest_stiffness_N_per_m",
                              "negative_modes", "residual_N"};
    for (const PathPoint& point : followed.path.points) {
      followed.table.rows.push_back({point.state.load_factor, displacement(system, point.state, nodes, command.axis),
                                     point.energy, point.lowest, static_cast<double>(point.negative_modes),
                                     point.residual});
    }
    if (const Status s = write_files(document, pose, system, stems[p], command, followed, output); !s) return s.error();
    followed.files = output.take_written();
    followed.summary = path_summary(followed);
    results.push_back(std::move(followed));
    if (context.cancelled()) break;
  }
  return results;
}

}  // namespace lissom
