#include "lissom/model/rod_mesh.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "lissom/core/nearest_name.h"
#include "lissom/model/brief_methods.h"

namespace lissom {

namespace {

constexpr double kOvershoot = 0.125;  // of the range: how far radii between controls may leave it [mathematics 6.1]

Status check_region(const DeformerRegion& region, DeformerBrief::Kind kind, const std::string& where) {
  if (region.depth > 0 && kind == DeformerBrief::Kind::kShell) {
    return Error{ErrorCode::kConflict, where + "/depth", "a shell has nothing below its surface",
                 "make the deformer a solid, or leave the depth out"};
  }
  if (region.low.has_value() != region.high.has_value()) {
    return Error{ErrorCode::kConflict, where, "a box needs both corners", "give \"low\" and \"high\", or neither"};
  }
  if (region.low && (region.high->array() < region.low->array()).any()) {
    return Error{ErrorCode::kRange, where, "the box is upside down", "\"low\" has the smaller coordinates"};
  }
  return {};
}

Status check_material(const RodMeshProject& project) {
  std::vector<std::string> known;
  for (const Material& material : project.materials) {
    if (Status s = material.validate("/materials/" + material.name); !s) return s;
    known.push_back(material.name);
  }
  for (const Material& material : material_library()) known.push_back(material.name);
  const std::string& wanted = project.rods.material;
  if (std::find(known.begin(), known.end(), wanted) != known.end()) return {};
  return Error{ErrorCode::kUnknown, "/rods/material", fmt::format("there is no material \"{}\"", wanted),
               suggestion(wanted, known)};
}

Status check_design(const RodMeshProject& project) {
  const MeshDesign& design = project.design;
  const std::vector<std::string> methods(kBriefMethods.begin(), kBriefMethods.end());
  if (!design.method.empty() && std::find(methods.begin(), methods.end(), design.method) == methods.end()) {
    return Error{ErrorCode::kUnknown, "/design/method", fmt::format("there is no method \"{}\"", design.method),
                 suggestion(design.method, methods)};
  }
  const double low = design.radii[0], high = design.radii[1];
  if (!(low > 0 && high > low)) {
    return Error{ErrorCode::kRange, "/design/radii", "radii need a smallest one above 0 and a larger largest one",
                 "for example [\"1 mm\", \"3 mm\"]"};
  }
  if (low - kOvershoot * (high - low) <= 0) {
    return Error{ErrorCode::kRange, "/design/radii",
                 fmt::format("between controls radii may leave their range by an eighth of it: below {:.3g} mm nothing "
                             "would be left",
                             1e3 * low),
                 fmt::format("raise the smallest to {:.3g} mm or lower the largest", 1e3 * high / 8)};
  }
  for (const auto& [name, radius] : {std::pair("r_n", project.rods.r_n), std::pair("r_b", project.rods.r_b)}) {
    if (radius >= low && radius <= high) continue;
    return Error{ErrorCode::kRange, std::string("/rods/") + name,
                 fmt::format("the start, {:.3g} mm, is outside of the range of radii, {:.3g} to {:.3g} mm",
                             1e3 * radius, 1e3 * low, 1e3 * high),
                 "start inside of it"};
  }
  return {};
}

Status check_pose(const RodMeshProject& project, const MeshPose& pose, const std::string& where) {
  const int ways = (pose.deformer.empty() ? 0 : 1) + (pose.mesh.empty() ? 0 : 1) + (pose.warp.empty() ? 0 : 1);
  if (ways != 1) {
    return Error{
        ways == 0 ? ErrorCode::kType : ErrorCode::kConflict, where,
        ways == 0 ? "nothing says which shape this pose has" : "the shape of this pose is given in several ways",
        "give one of \"deformer\", \"mesh\" and \"warp\""};
  }
  if (!pose.deformer.empty() && std::none_of(project.deformers.begin(), project.deformers.end(),
                                             [&](const DeformerBrief& d) { return d.name == pose.deformer; })) {
    return Error{ErrorCode::kUnknown, where + "/deformer", fmt::format("there is no deformer \"{}\"", pose.deformer),
                 "name one of \"deformers\""};
  }
  if (pose.pose.supports.empty()) {
    return Error{ErrorCode::kGeometry, where + "/pose/supports",
                 "nothing holds this pose, so nothing says where in space it is", "hold a part of the surface"};
  }
  return {};
}

}  // namespace

Status RodMeshProject::validate() const {
  if (Status s = check_material(*this); !s) return s;
  if (Status s = check_design(*this); !s) return s;
  if (print.bed && !(print.bed->minCoeff() > 0 && print.bed->allFinite())) {
    return Error{ErrorCode::kRange, "/print/bed", "a bed needs three lengths above 0",
                 "for example [250, 210, 210] mm"};
  }
  for (std::size_t d = 0; d < deformers.size(); ++d) {
    for (std::size_t r = 0; r < deformers[d].regions.size(); ++r) {
      const std::string where = fmt::format("/deformers/{}/regions/{}", deformers[d].name, r);
      if (Status s = check_region(deformers[d].regions[r], deformers[d].kind, where); !s) return s;
    }
  }
  std::set<std::string> names;
  bool designed_for = false;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const std::string where = fmt::format("/poses/{}", k);
    if (!names.insert(poses[k].pose.name).second) {
      return Error{ErrorCode::kConflict, where + "/pose/name",
                   fmt::format("two poses are called \"{}\"", poses[k].pose.name), "give each its own name"};
    }
    if (Status s = check_pose(*this, poses[k], where); !s) return s;
    designed_for = designed_for || !poses[k].held_back;
  }
  if (!designed_for) {
    return Error{ErrorCode::kConflict, "/poses", "all poses are held back, so there is none to design for",
                 "hold back fewer"};
  }
  return {};
}

}  // namespace lissom
