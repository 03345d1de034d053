/// What the windmills and the sphere do, in figures: rows of name, metric, value, unit separated by tabs.
///
///     motion_figures [FOLDER]      FOLDER: receives windmill-radius.png
///
/// A windmill is run for a series of axis radii. Had its axis no inertia and its blades no give, all its twist energy E would
/// become turning: the angular momentum of the blades would reach sqrt(2 E I), which goes like the radius squared.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "bench/timing.h"
#include "lissom/core/file_io.h"
#include "lissom/equilibrium/continuation.h"
#include "lissom/motion/motion.h"
#include "lissom/view/chart.h"
#include "scenes/scene_models.h"

namespace lissom {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// The first motion of a model, with the turning of a set; nothing when it does not reach its end.
std::optional<MotionResult> play(const std::string& name, const Model& model, const System& system,
                                 const std::string& set, const Vec3& axis) {
  MotionWatch watch;
  watch.nodes.kind = Selector::Kind::kSet;
  watch.nodes.name = set;
  watch.axis = axis;
  MotionOptions options;
  options.watches = {watch};
  Result<MotionResult> result = simulate(model, system, model.motions[0], "/motions/0", options);
  if (!result) return std::fprintf(stderr, "%s: %s\n", name.c_str(), result.error().text().c_str()), std::nullopt;
  const bool finished = result.value().verdict == MotionVerdict::kFinished;
  if (!finished) return std::fprintf(stderr, "%s: %s\n", name.c_str(), result.value().message.c_str()), std::nullopt;
  row(name, "energy balance error", 100 * result.value().balance_error(), "%");
  return std::move(result).value();
}

struct Released {
  double momentum = 0, bound = 0;  ///< kg m^2/s: largest of the blades, and if nothing else took up energy
};

std::optional<Released> release(double radius) {
  const std::string name = "windmill, axis " + std::to_string(radius * 1e3).substr(0, 3) + " mm";
  const scene_models::WindmillAxis axes[] = {{"blades", radius}};
  const Model model = scene_models::windmills(axes);
  const Result<System> system = make_system(model);
  if (!system) return std::fprintf(stderr, "%s: %s\n", name.c_str(), system.error().text().c_str()), std::nullopt;
  const std::optional<MotionResult> motion = play(name, model, system.value(), "blades", Vec3::UnitX());
  if (!motion) return std::nullopt;
  Released released;
  for (const MotionRecord& r : motion->records) {
    released.momentum = std::max(released.momentum, std::abs(r.watches[0].angular_momentum));
  }
  double inertia = 0;  // kg m^2, of the blades about the axis
  for (int i = 0; i < system.value().layout.nodes(); ++i) {
    const Vec3& x = system.value().structure.nodes[i];
    inertia += system.value().rest.node_mass[i] * x.tail<2>().squaredNorm();
  }
  released.bound = std::sqrt(2 * inertia * motion->records.front().elastic_energy);
  row(name, "largest angular momentum of the blades", 1e6 * released.momentum, "kg mm²/s");
  row(name, "the same if all twist became turning", 1e6 * released.bound, "kg mm²/s");
  return released;
}

bool windmills_over_radius(const std::filesystem::path& folder) {
  ChartSeries computed{.name = "computed", .style = ChartSeries::Style::kLineAndPoints};
  ChartSeries bound{.name = "if all twist became turning of stiff blades"};
  for (const double radius : {0.001, 0.0014, 0.002, 0.0024, 0.0028, 0.0034, 0.004}) {
    const std::optional<Released> released = release(radius);
    if (!released) return false;
    computed.x.push_back(radius);
    computed.y.push_back(released->momentum);
    bound.x.push_back(radius);
    bound.y.push_back(released->bound);
  }
  if (folder.empty()) return true;
  Chart chart;
  chart.title = "Windmill: largest angular momentum of the blades";
  chart.x = {.label = "axis radius", .unit = "mm", .display_scale = 1e3};
  chart.y = {.label = "angular momentum", .unit = "kg mm²/s", .display_scale = 1e6};
  chart.series = {computed, bound};
  const Result<std::string> picture = draw_chart(chart, ImageFormat::kPng);
  if (!picture) return std::fprintf(stderr, "%s\n", picture.error().text().c_str()), false;
  const Status written = write_file(folder / "windmill-radius.png", picture.value());
  if (!written) return std::fprintf(stderr, "%s\n", written.error().text().c_str()), false;
  return true;
}

/// How much of what the nodes do is a turn about the z axis, 0..1.
double share_of_turn(const System& system, const VecX& shape, const std::vector<int>& nodes) {
  double turn = 0, inertia = 0, square = 0;
  for (const int node : nodes) {
    const Vec3 u = shape.segment<3>(3 * node);
    const Vec3& x = system.structure.nodes[node];
    turn += x.x() * u.y() - x.y() * u.x();
    inertia += x.head<2>().squaredNorm();
    square += u.squaredNorm();
  }
  return square > 0 ? turn * turn / (inertia * square) : 0;
}

/// Without lean, pressed slowly: where the straight way down stops being stable, and what it gives way to.
bool upright_sphere() {
  const std::string name = "sphere without lean";
  const Model model = scene_models::sphere_leaning(0);
  const Result<System> system = make_system(model);
  if (!system) return std::fprintf(stderr, "%s: %s\n", name.c_str(), system.error().text().c_str()), false;
  const Result<StaticProblem> problem = make_static_problem(model, system.value(), model.poses[0], "/poses/0");
  if (!problem) return std::fprintf(stderr, "%s: %s\n", name.c_str(), problem.error().text().c_str()), false;
  const Result<std::vector<int>> top = select(model, system.value().structure, model.sets[0].nodes, "/sets/0");
  if (!top) return std::fprintf(stderr, "%s: %s\n", name.c_str(), top.error().text().c_str()), false;
  const PathResult path = follow_path(problem.value(), start_state(problem.value(), model.poses[0]),
                                      {.to = 0.5, .steps = 10, .stop_at_critical = true}, {});
  if (path.critical.empty()) return std::fprintf(stderr, "%s: %s\n", name.c_str(), path.message.c_str()), false;
  const CriticalPoint& critical = path.critical.front();
  const double press = std::abs(model.poses[0].supports[1].move.z());
  row(name, "pressed down when the straight way becomes unstable", 1e3 * press * critical.load_factor, "mm");
  row(name, "motions that become unstable there", critical.negative_after - critical.negative_before, "");
  row(name, "share of turning in what the top does then",
      100 * share_of_turn(system.value(), critical.mode.shape, top.value()), "%");
  return true;
}

bool sphere() {
  const Model model = scene_models::sphere();
  const Result<System> system = make_system(model);
  if (!system) return std::fprintf(stderr, "sphere: %s\n", system.error().text().c_str()), false;
  const std::optional<MotionResult> motion = play("sphere", model, system.value(), "top", Vec3::UnitZ());
  if (!motion) return false;
  double turn = 0;
  const double press = std::abs(model.poses[0].supports[1].move.z());
  std::optional<double> onset;  // m
  for (const MotionRecord& r : motion->records) {
    turn = std::max(turn, std::abs(r.watches[0].turn));
    if (!onset && std::abs(r.watches[0].turn) > 1 * kDegree) onset = r.load_factor * press;
  }
  if (onset) row("sphere", "pressed down when the top has turned by 1 deg", 1e3 * *onset, "mm");
  row("sphere", "largest turn of the top", turn / kDegree, "deg");
  return true;
}

}  // namespace
}  // namespace lissom

int main(int argc, char** argv) {
  std::filesystem::path folder;
  for (int i = 1; i < argc; ++i) {
    if (argv[i][0] != '-') folder = argv[i];
  }
  const bool windmills = lissom::windmills_over_radius(folder);
  const bool upright = lissom::upright_sphere();
  return lissom::sphere() && upright && windmills ? 0 : 1;
}
