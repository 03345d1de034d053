#include "scenes/rod_mesh_examples.h"

#include <cmath>
#include <numbers>

#include "scenes/object_surfaces.h"
#include "scenes/parts.h"

namespace lissom::scene_models {

namespace {

constexpr double kFar = 1;  // m, beyond everything

Vec3 from(double x, double y, double z) { return {x, y, z}; }

/// Everything beyond a limit of one coordinate (0: x, 1: y, 2: z).
Selector beyond(int axis, double limit, double sign) {
  Vec3 low = Vec3::Constant(-kFar), high = Vec3::Constant(kFar);
  (sign > 0 ? low : high)[axis] = limit;
  return box(low, high);
}

PointForce pull(const Selector& at, const Vec3& force) { return {at, force, true, Scaling::kProportional}; }

MeshPose pose(std::string name, std::string deformer, const std::vector<Selector>& held,
              const std::vector<PointForce>& forces) {
  MeshPose made;
  made.pose.name = std::move(name);
  made.deformer = std::move(deformer);
  for (const Selector& at : held) made.pose.supports.push_back(hold(at, SupportKind::kPin));
  made.pose.forces = forces;
  return made;
}

RodMeshExample begun(const char* title, const char* source, const char* file) {
  RodMeshExample made;
  made.project.title = title;
  made.project.source = source;
  made.project.surface.file = file;
  made.project.surface.unit = 1e-3;
  return made;
}

DeformerRegion softer(const Vec3& low, const Vec3& high, double factor, double blend) {
  DeformerRegion region;
  region.low = low;
  region.high = high;
  region.stiffness = factor;
  region.blend = blend;
  return region;
}

DeformerBrief felt(std::string name, double modulus) {
  DeformerBrief brief;
  brief.name = std::move(name);
  brief.modulus = modulus;
  brief.poisson_ratio = 0.3;
  brief.density = 300;
  brief.thickness = 3e-3;
  return brief;
}

}  // namespace

Result<RodMeshExample> hat_example() {
  RodMeshExample made = begun("Hat", "thesis, table 5.1 and figure 5.7; the surface is our own", "hat.ply");
  RodMeshProject& p = made.project;
  p.topology = CellTopology{64, 1, 1};
  p.rods.shortest = 0.45;
  DeformerBrief soft_front = felt("soft in front", 2e7), soft_left = felt("soft on the left", 2e7);
  soft_front.regions = {softer(from(0.02, -kFar, -kFar), Vec3::Constant(kFar), 0.1, 0.04)};
  soft_left.regions = {softer(from(-kFar, 0.02, -kFar), Vec3::Constant(kFar), 0.1, 0.04)};
  p.deformers = {soft_front, felt("even", 2e8), soft_left};
  const Selector back = beyond(0, -0.085, -1), front = beyond(0, 0.093, 1);
  const Selector right = beyond(1, -0.075, -1), left = beyond(1, 0.082, 1);
  p.poses = {pose("front up", "soft in front", {back}, {pull(front, from(0, 0, 1.2))}),
             pose("front down", "soft in front", {back}, {pull(front, from(0, 0, -1.2))}),
             pose("front in", "soft in front", {back}, {pull(front, from(-2, 0, 0.5))}),
             pose("under its weight", "even", {back}, {}),
             pose("left up", "soft on the left", {right}, {pull(left, from(0, 0, 1.2))})};
  p.poses[3].pose.gravity = Gravity{};
  made.surface = hat_surface();
  return made;
}

Result<RodMeshExample> dinosaur_example() {
  Result<Surface> surface = dinosaur_surface();
  if (!surface) return surface.error();
  RodMeshExample made = begun("Dinosaur", "thesis, table 5.1 and figure 5.8; the surface is our own", "dinosaur.ply");
  RodMeshProject& p = made.project;
  p.topology = DualTopology{222};
  p.design.iterations = {8, 5, 5, 30};
  p.design.clearance = 1e-3;  // its surface is bent, and the check measures across the sections as they lie
  // A body with a skin of 4 mm and a soft core: what is printed is hollow, and full ones ask for more contrast than rods have.
  DeformerBrief body;
  body.name = "body";
  body.kind = DeformerBrief::Kind::kSolid;
  body.modulus = 7e4;
  body.poisson_ratio = 0.45;  // meshes of hexagons keep their area as they bend
  body.density = 300;
  body.cell = 4e-3;
  DeformerRegion core;
  core.depth = 4e-3;
  core.blend = 1e-3;
  core.stiffness = 2e-3;
  DeformerRegion head;
  head.low = from(0.066, -kFar, 0.09);
  head.high = Vec3::Constant(kFar);
  head.density = 8;
  body.regions = {softer(from(-kFar, -kFar, 0.02), from(-0.055, kFar, kFar), 0.5, 0.025),
                  softer(from(-0.05, -kFar, 0.026), from(0.05, kFar, 0.038), 0.5, 0.008), head, core};
  p.deformers = {body};
  const Selector feet = beyond(2, 0.013, -1), tail = beyond(0, -0.092, -1), nose = beyond(0, 0.088, 1);
  const Selector front_feet = box(from(0, -kFar, -kFar), from(kFar, kFar, 0.013));
  const Selector right_rear = box(from(-kFar, -kFar, -kFar), from(0, 0, 0.013));
  const Selector left_rear = box(from(-kFar, 0, -kFar), from(0, kFar, 0.013));
  p.poses = {pose("tail up", "body", {feet}, {pull(tail, from(0.205, 0, 0.535))}),
             pose("tail aside", "body", {feet}, {pull(tail, from(0, 0.55, 0))}),
             pose("nodding", "body", {feet}, {pull(nose, from(0, 0, -0.1))}),
             pose("looking aside", "body", {feet}, {pull(nose, from(0, 0.57, 0))}),
             pose("foot lifted", "body", {front_feet, right_rear}, {pull(left_rear, from(-0.32, 0.1, 0.235))})};
  p.poses[2].pose.gravity = Gravity{};
  made.surface = std::move(surface).value();
  return made;
}

Result<RodMeshExample> smiley_example() {
  RodMeshExample made = begun("Smiley", "thesis, table 5.1 and figure 5.9; the face is our own", "face.ply");
  RodMeshProject& p = made.project;
  p.topology = CellTopology{240, 2, 1};
  Material soft;
  soft.name = "soft TPU";
  soft.youngs_modulus = 10e6;
  soft.poisson_ratio = 0.48;
  soft.density = 1000;
  soft.source = "thesis, table 5.1";
  p.materials = {soft};
  p.rods.material = soft.name;
  p.rods.edges = 4;
  p.rods.r_n = 2.5e-3;  // high ribs keep a sheet in its plane
  p.design.radii = Vec2(1e-3, 4e-3);
  p.design.iterations = {6, 4, 4, 30};               // radii alone, to the end, make ribs that buckle in the plane
  p.print.bed = Vec3(0.34, 0.34, 0.6);               // EOS P 396
  constexpr double kHalf = 0.125, kPulled = 0.0625;  // m
  MeshPose smile;
  smile.pose.name = "smile";
  smile.pose.supports = {hold(beyond(0, -kHalf + 0.004, -1), SupportKind::kPin),
                         hold(beyond(0, kHalf - 0.004, 1), SupportKind::kPin)};
  Support table;  // everything slides on it
  table.at = box(Vec3::Constant(-kFar), Vec3::Constant(kFar));
  table.kind = SupportKind::kFree;
  table.directions = {Vec3::UnitZ()};
  smile.pose.supports.push_back(table);
  // What a pull does to an even sheet, and what the drawing hand adds at the mouth.
  const auto pulled = [&](double x, double y) {
    const double along = (x + kHalf) / (2 * kHalf);
    return Vec3(x + kPulled * along, y * (1 - 0.15 * std::sin(std::numbers::pi * along)), 0);
  };
  for (const double x : {-kHalf, -0.09375, -0.0625, -0.03125, 0.0, 0.03125, 0.0625, 0.09375, kHalf}) {
    for (const double y : {-kHalf, 0.035, 0.09, kHalf}) smile.warp.push_back({Vec3(x, y, 0), pulled(x, y)});
  }
  for (const double x : {-kHalf, kHalf}) smile.warp.push_back({Vec3(x, -0.042, 0), pulled(x, -0.042)});
  for (const double x : {-0.05, -0.025, 0.0, 0.025, 0.05}) {
    const double lift = 0.016 * std::pow(x / 0.05, 2) - 0.006;
    smile.warp.push_back({Vec3(x, -0.042, 0), pulled(x, -0.042) + Vec3(0, lift, 0)});
  }
  p.poses = {smile};
  made.surface = face_surface();
  return made;
}

std::span<const RodMeshExampleInfo> rod_mesh_examples() {
  static constexpr RodMeshExampleInfo kExamples[] = {
      {"hat", "a hat whose front is soft", hat_example},
      {"dinosaur", "a toy with a soft tail and a heavy head", dinosaur_example},
      {"smiley", "a sheet whose serious face smiles when it is pulled", smiley_example}};
  return kExamples;
}

}  // namespace lissom::scene_models
