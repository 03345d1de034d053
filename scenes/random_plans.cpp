#include "scenes/random_plans.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <vector>

#include "scenes/random_numbers.h"
#include "scenes/random_rods.h"

namespace lissom::scene_models {

namespace {

constexpr double kPi = std::numbers::pi;

/// What rods have to balance.
struct Pull {
  double extent = 0;   // m
  double tension = 0;  // N/m
};

MembraneMaterial random_fabric(RandomNumbers& random) {
  if (random.chance(0.3)) return *find_membrane_material("elastane-cotton knit");
  if (random.chance(0.3)) return *find_membrane_material("soft knit");
  MembraneMaterial fabric;
  fabric.name = "own fabric";
  fabric.stiffness_1 = random.log_between(0.25, 60);
  fabric.stiffness_2 = fabric.stiffness_1 * (random.chance(0.5) ? 1 : random.log_between(0.4, 2.5));
  fabric.poisson_ratio = random.between(0.1, 0.45);
  fabric.thickness = random.between(0.2e-3, 1e-3);
  fabric.area_density = random.between(0.08, 0.25);
  fabric.source = "drawn by lot";
  return fabric;
}

Vec2 random_stretch(RandomNumbers& random) {
  constexpr double kLeast = 1.05, kMost = 1.8;
  const double s = random.between(kLeast, kMost);
  if (random.chance(0.6)) return Vec2::Constant(s);
  return {s, std::clamp(s * random.between(0.8, 1.25), kLeast, kMost)};
}

/// N/m, mean of the two directions, of the sheet that rods hold at its pre-stretch.
double tension_of(const MembraneMaterial& fabric, const Vec2& stretch) {
  const double mean = std::sqrt(fabric.stiffness_1 * fabric.stiffness_2) / (1 - fabric.poisson_ratio);
  return mean * (stretch.squaredNorm() / 2 - 1) / 2;
}

/// Rods whose Euler load over the whole extent is `ratio` times less than what the fabric pulls with; of the first material
/// tried with which they are thin enough for the plan.
void choose_rods(RandomNumbers& random, const Pull& pull, double thickest, Plan& plan) {
  const double ratio = random.log_between(0.5, 50), flatness = random.between(1, 2.5);
  const auto out_of_plane = [&](const Material& material) {
    const double force = pull.tension * pull.extent / 2 / ratio;
    return std::pow(4 * force * pull.extent * pull.extent / (std::pow(kPi, 3) * material.youngs_modulus * flatness),
                    0.25);
  };
  const std::span<const Material> library = material_library();
  const Material* material = nullptr;
  for (int tries = 0; tries < 8; ++tries) {
    const Material& next = library[static_cast<std::size_t>(random.whole(0, static_cast<int>(library.size()) - 1))];
    if (material == nullptr || out_of_plane(next) < out_of_plane(*material)) material = &next;
    if (flatness * out_of_plane(*material) <= thickest) break;
  }
  plan.material = material->name;
  const double r_n = std::min(out_of_plane(*material), thickest / flatness);
  const bool even = random.chance(0.5);
  for (PlanPoint& point : plan.points) {
    point.r_n = r_n * (even ? 1 : random.log_between(0.7, 1.4));
    point.r_b = flatness * r_n * (even ? 1 : random.log_between(0.7, 1.4));
  }
}

void choose_splits(RandomNumbers& random, Plan& plan) {
  if (random.chance(0.5)) return;
  for (PlanPoint& point : plan.points) point.split = random.chance(0.15);
}

void choose_ghosts(RandomNumbers& random, std::size_t outline_rods, Plan& plan) {
  const double outer = random.chance(0.35) ? (outline_rods > 1 ? 0.5 : 0.4) : 0, inner = random.chance(0.5) ? 0.15 : 0;
  for (std::size_t r = 0; r < plan.rods.size(); ++r) {
    if (random.chance(r < outline_rods ? outer : inner)) plan.rods[r].role = PlanRole::kGhost;
  }
  const bool all =
      std::all_of(plan.rods.begin(), plan.rods.end(), [](const PlanRod& rod) { return rod.role == PlanRole::kGhost; });
  if (all) plan.rods.back().role = PlanRole::kRod;
}

std::string title_of(unsigned seed, const char* outline, const Plan& plan) {
  std::vector<int> uses(plan.points.size(), 0);
  int ghosts = 0, splits = 0, free_ends = 0;
  for (const PlanRod& rod : plan.rods) {
    ghosts += rod.role == PlanRole::kGhost;
    for (const int point : rod.points) ++uses[static_cast<std::size_t>(point)];
  }
  for (const PlanRod& rod : plan.rods) {
    if (rod.closed) continue;
    for (const int end : {rod.points.front(), rod.points.back()}) free_ends += uses[static_cast<std::size_t>(end)] == 1;
  }
  for (const PlanPoint& point : plan.points) splits += point.split;
  return fmt::format("Random layout {}: {}, {} rods, {} ghosts, {} splits, {} free ends, {} holes", seed, outline,
                     plan.rods.size(), ghosts, splits, free_ends, plan.fabric.holes.size());
}

}  // namespace

Model random_plan(unsigned seed, const RandomPlanSize& size) {
  RandomNumbers random(seed);
  Model model;
  const int rods = random.whole(size.least_rods, size.most_rods);
  constexpr int kNodesPerRod = 28;  // or there is no room for them
  const double nodes = std::max(random.log_between(size.least_nodes, size.most_nodes),
                                std::min<double>(kNodesPerRod * rods, size.most_nodes));
  RandomRods drawn = draw_random_rods(random, nodes, rods);
  Plan plan = drawn.sketch.plan();
  plan.edge_length = drawn.edge_length;
  plan.fabric.holes = drawn.holes;
  const MembraneMaterial fabric = random_fabric(random);
  if (!find_membrane_material(fabric.name)) model.membrane_materials.push_back(fabric);
  plan.fabric.material = fabric.name;
  plan.fabric.pre_stretch = random_stretch(random);
  plan.fabric.warp_angle = random.between(0, kPi);
  constexpr double kThickest = 0.32;  // of the clearance; some points are thicker by 1.4
  choose_rods(random, {drawn.extent, tension_of(fabric, plan.fabric.pre_stretch)}, kThickest * drawn.sketch.clearance(),
              plan);
  choose_splits(random, plan);
  choose_ghosts(random, drawn.outline_rods, plan);
  for (std::size_t i = 0; i < plan.points.size(); ++i) plan.points[i].name = fmt::format("p{}", i);
  for (std::size_t r = 0; r < plan.rods.size(); ++r) {
    plan.rods[r].name = fmt::format("{}-{}", r < drawn.outline_rods ? "edge" : "rod", r);
  }
  model.title = title_of(seed, drawn.outline, plan);
  model.plan = std::move(plan);
  Pose pose;
  pose.name = "released";
  model.poses.push_back(pose);
  return model;
}

}  // namespace lissom::scene_models
