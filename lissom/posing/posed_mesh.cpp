#include "lissom/posing/posed_mesh.h"

#include <algorithm>
#include <fmt/format.h>

#include "lissom/model/structure.h"
#include "lissom/posing/deformer.h"
#include "lissom/posing/mesh_topology.h"
#include "lissom/posing/surface_rods.h"
#include "lissom/posing/warp.h"

namespace lissom {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Selector at_point(const Vec3& x) {
  Selector selector;
  selector.kind = Selector::Kind::kPoint;
  selector.point = x;
  return selector;
}

Vec3 carried(const std::vector<Vec3>& vertices, const Surface& surface, const SurfacePlace& place) {
  Vec3 x = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    x += place.weights[i] * vertices[at(surface.triangles[at(place.triangle)][at(i)])];
  }
  return x;
}

ParameterBrief radii(int controls, const Vec2& range) {
  ParameterBrief brief;
  brief.what = RadiiBrief{controls, range};
  return brief;
}

/// Makes the structure of a project pose by pose.
class Poser {
 public:
  Poser(const RodMeshProject& project, const ProjectFiles& files, const Context& context)
      : project_(project), files_(files), context_(context) {}

  Result<PosedMesh> run() {
    if (Status s = lay_rods(); !s) return s.error();
    if (Status s = make_deformers(); !s) return s.error();
    for (std::size_t k = 0; k < project_.poses.size(); ++k) {
      context_.report({.task = "poses", .iteration = static_cast<int>(k) + 1, .detail = project_.poses[k].pose.name});
      if (context_.cancelled()) return Error{ErrorCode::kConflict, "/poses", "stopped", "run it again"};
      if (Status s = add_pose(project_.poses[k], fmt::format("/poses/{}", k)); !s) return s.error();
    }
    made_.model.design = brief();
    return std::move(made_);
  }

 private:
  Status lay_rods() {
    const Result<SurfaceNetwork> network =
        lay_out(files_.surface, project_.topology, project_.rods, files_.drawn, "/topology", context_);
    if (!network) return network.error();
    made_.notes = network.value().notes;
    made_.joints = static_cast<int>(network.value().joints.size());
    SurfaceRods rods = rods_on_surface(files_.surface, network.value(), project_.rods);
    made_.model.title = project_.title;
    made_.model.source = project_.source;
    made_.model.materials = project_.materials;
    made_.model.joint_kind = JointKind::kCorotational;
    made_.model.rods = std::move(rods.rods);
    Result<Structure> structure = discretize(made_.model);
    if (!structure) return structure.error();
    structure_ = std::move(structure).value();
    place_.resize(structure_.nodes.size());
    for (std::size_t r = 0; r < rods.places.size(); ++r) {
      for (std::size_t k = 0; k < rods.places[r].size(); ++k)
        place_[at(structure_.rods[r].nodes[k])] = rods.places[r][k];
    }
    return {};
  }

  Status make_deformers() {
    for (const DeformerBrief& brief : project_.deformers) {
      Result<Deformer> made = Deformer::make(brief, files_.surface, "/deformers/" + brief.name);
      if (!made) return made.error();
      deformers_.emplace(brief.name, std::move(made).value());
    }
    const auto comes_without = [](const MeshPose& pose) { return pose.deformer.empty(); };
    if (std::none_of(project_.poses.begin(), project_.poses.end(), comes_without)) return {};
    // The surface itself resolves the selectors of these poses.
    DeformerBrief plain;
    plain.name = "plain";
    Result<Deformer> made = Deformer::make(plain, files_.surface, "/surface");
    if (!made) return made.error();
    plain_.emplace(std::move(made).value());
    return {};
  }

  /// Where the surface's vertices are in a pose.
  Result<std::vector<Vec3>> posed_surface(const MeshPose& pose, const std::string& where) const {
    if (!pose.deformer.empty()) return deformers_.at(pose.deformer).posed(pose.pose, where, context_);
    if (!pose.mesh.empty()) return files_.posed.at(pose.mesh);
    const Result<Warp> warp = Warp::make(pose.warp, where + "/warp");
    if (!warp) return warp.error();
    std::vector<Vec3> moved;
    for (const Vec3& x : files_.surface.vertices) moved.push_back(warp.value()(x));
    return moved;
  }

  Status add_pose(const MeshPose& wanted, const std::string& where) {
    const Result<std::vector<Vec3>> posed = posed_surface(wanted, where);
    if (!posed) return posed.error();
    std::vector<Vec3> targets;
    for (const SurfacePlace& place : place_) targets.push_back(carried(posed.value(), files_.surface, place));
    Pose pose;
    pose.name = wanted.pose.name;
    pose.gravity = wanted.pose.gravity;
    std::vector<char> held(place_.size(), 0);
    for (std::size_t i = 0; i < wanted.pose.supports.size(); ++i) {
      const std::string place = fmt::format("{}/pose/supports/{}", where, i);
      if (wanted.pose.supports[i].kind == SupportKind::kFree) {
        pose.supports.push_back(wanted.pose.supports[i]);
        continue;
      }
      if (Status s = hold(wanted, wanted.pose.supports[i].at, place, held); !s) return s;
    }
    for (std::size_t i = 0; i < wanted.pose.forces.size(); ++i) {
      const std::string place = fmt::format("{}/pose/forces/{}", where, i);
      if (Status s = hold(wanted, wanted.pose.forces[i].at, place, held); !s) return s;
    }
    for (std::size_t n = 0; n < held.size(); ++n) {
      if (held[n] == 0) continue;
      pose.soft_pins.push_back({at_point(structure_.nodes[n]), project_.design.pin_stiffness, targets[n]});
    }
    made_.model.poses.push_back(std::move(pose));
    made_.targets.push_back(std::move(targets));
    return {};
  }

  /// Marks the nodes that lie where the surface is held or pulled.
  Status hold(const MeshPose& pose, const Selector& selector, const std::string& where, std::vector<char>& held) const {
    const Deformer& deformer = pose.deformer.empty() ? *plain_ : deformers_.at(pose.deformer);
    const Result<VecX> share = deformer.selected(selector, where + "/at");
    if (!share) return share.error();
    bool any = false;
    for (std::size_t n = 0; n < place_.size(); ++n) {
      double here = 0;
      for (int i = 0; i < 3; ++i) {
        here += place_[n].weights[i] * share.value()[files_.surface.triangles[at(place_[n].triangle)][at(i)]];
      }
      if (here < 0.5) continue;
      held[n] = 1;
      any = true;
    }
    if (any) return {};
    return Error{ErrorCode::kGeometry, where + "/at", "no rod runs through this part of the surface",
                 "take a larger part, or more cells"};
  }

  /// Methods that put matrices over all parameters together are the fastest up to about so many parameters.
  std::string fastest_method() const {
    constexpr int kManyParameters = 1500;
    const int rods = static_cast<int>(made_.model.rods.size());
    const bool many = 5 * (made_.joints + 2 * rods) > kManyParameters;
    return many ? "gauss_newton_products" : DesignSettings().method;
  }

  Brief brief() const {
    const MeshDesign& design = project_.design;
    Brief brief;
    brief.parameters.push_back(radii(4, design.radii));
    for (int stage = 0; stage < 3; ++stage) {
      if (design.iterations[at(stage)] == 0) continue;
      StageBrief& made = brief.stages.emplace_back();
      made.parameters.push_back(radii(stage + 2, design.radii));
      made.iterations = design.iterations[at(stage)];
    }
    if (design.reach > 0 && design.iterations[3] > 0) {
      brief.parameters.emplace_back().what = RestShapeBrief{4, design.reach, RestShapeBrief::Gauge::kFree};
      brief.settings.iterations = design.iterations[3];
    } else if (!brief.stages.empty()) {
      brief.settings.iterations = *brief.stages.back().iterations;
      brief.stages.pop_back();
    }
    brief.settings.pins = DesignSettings::Pins::kAdaptive;
    brief.settings.method = design.method.empty() ? fastest_method() : design.method;
    brief.wishes.smoothness = design.smoothness;
    brief.wishes.clearance = design.clearance;
    for (std::size_t k = 0; k < project_.poses.size(); ++k) {
      if (project_.poses[k].held_back) continue;
      PositionsGoal places;
      places.targets = made_.targets[k];
      GoalBrief& goal = brief.goals.emplace_back();
      goal.what = std::move(places);
      goal.pose = made_.model.poses[k].name;
      goal.weight = project_.poses[k].weight;
    }
    return brief;
  }

  const RodMeshProject& project_;
  const ProjectFiles& files_;
  const Context& context_;
  PosedMesh made_;
  Structure structure_;
  std::vector<SurfacePlace> place_;  // per node of the structure
  std::map<std::string, Deformer> deformers_;
  std::optional<Deformer> plain_;
};

}  // namespace

Result<PosedMesh> pose_rod_mesh(const RodMeshProject& project, const ProjectFiles& files, const Context& context) {
  return Poser(project, files, context).run();
}

}  // namespace lissom
