/// A gridshell: glass-fibre tubes laid out flat, fastened to each other where they cross, pushed inwards at their ends
/// until they rise. The plan is the line network scenes/data/gridshell.obj.

#include <gridshell_obj.h>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/model/import_network.h"
#include "scenes/parts.h"
#include "scenes/scene_models.h"

namespace lissom::scene_models {

Model gridshell() {
  const Result<ObjLines> lines = read_obj_lines(kGridshellObj, "scenes/data/gridshell.obj");
  LISSOM_ASSERT(lines.ok());
  NetworkOptions options;
  options.scale = 0.001;
  options.material = "GFRP";
  options.section.shape = SectionShape::kTube;
  options.section.r_n = options.section.r_b = {0.02};
  options.section.wall = 0.003;
  Result<ImportedNetwork> network = import_network(lines.value(), options);
  LISSOM_ASSERT(network.ok());
  Model model = std::move(network.value().model);
  model.title = "Gridshell of glass-fibre tubes, 12 m by 8 m";
  Pose pose;
  pose.name = "erected";
  Selector ends;
  ends.kind = Selector::Kind::kEnds;
  Support support = hold(ends, SupportKind::kPin);
  support.move_inwards = 0.15;
  pose.supports.push_back(support);
  pose.gravity = Gravity{Vec3(0, 0, -9.81), Scaling::kConstant};
  Seed seed;
  seed.amplitude = 0.3;
  pose.seed = seed;
  model.poses.push_back(pose);
  return model;
}

}  // namespace lissom::scene_models
