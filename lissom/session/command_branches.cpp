#include "lissom/session/command_branches.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/mechanics/membrane_strain.h"
#include "lissom/session/branches_json.h"
#include "lissom/session/fields.h"
#include "lissom/session/output.h"
#include "lissom/session/pose_files.h"
#include "lissom/session/result_file.h"
#include "lissom/view/picture.h"

namespace lissom {

namespace {

constexpr size_t kMostPanels = 12;

double height_of(const System& system, const State& state) {
  double low = INFINITY, high = -INFINITY;
  for (int i = 0; i < system.layout.nodes(); ++i) {
    low = std::min(low, state.position(i).z());
    high = std::max(high, state.position(i).z());
  }
  return high - low;
}

Result<std::string> picture_of(const Document& document, const Pose& pose, const System& system,
                               const PoseBranches& found, ImageFormat format) {
  std::vector<Panel> panels;
  for (size_t k = 0; k < std::min(found.search.branches.size(), kMostPanels); ++k) {
    const Branch& branch = found.search.branches[k];
    const Result<Drawing> drawing = draw_state({document.model, system, branch.equilibrium.state, nullptr}, nullptr);
    if (!drawing) return drawing.error();
    const std::string also = branch.same_energy_as >= 0 ? fmt::format(", alike to {}", branch.same_energy_as + 1)
                                                        : std::string(branch.mirrored ? ", and its mirror image" : "");
    panels.push_back({{{drawing.value()}},
                      fmt::format("{}: {:.6g} mJ, {:.1f} mm high{}", k + 1, 1e3 * branch.equilibrium.energy,
                                  1e3 * found.heights[k], also)});
  }
  PictureOptions options;
  options.title = (document.model.title.empty() ? document.name : document.model.title) + ", " + pose.name;
  options.forces = Visibility::kHidden;
  options.supports = Visibility::kHidden;
  options.ruler = Visibility::kHidden;
  return draw_picture(panels, options, format);
}

}  // namespace

Result<std::vector<PoseBranches>> branches_command(const Document& document, const BranchesCommand& command,
                                                   const Context& context) {
  if (const Status s = command.options.validate(); !s) return s.error();
  const Result<std::vector<int>> poses = pose_numbers(document.model, command.poses);
  if (!poses) return poses.error();
  const Result<System> made = make_system(document.model);
  if (!made) return made.error();
  const System& system = made.value();
  Output output(command.folder);
  if (const Status s = output.prepare(); !s) return s.error();
  const std::vector<std::string> stems = pose_file_names(document);
  std::vector<PoseBranches> results;
  for (const int p : poses.value()) {
    const Pose& pose = document.model.poses[p];
    const Result<StaticProblem> problem =
        make_static_problem(document.model, system, pose, "/poses/" + std::to_string(p));
    if (!problem) return problem.error();
    PoseBranches found;
    found.pose = pose.name;
    found.search = find_branches(problem.value(), pose, command.options, context);
    for (size_t k = 0; k < found.search.branches.size(); ++k) {
      const Equilibrium& e = found.search.branches[k].equilibrium;
      found.heights.push_back(height_of(system, e.state));
      const std::string name = fmt::format("{}-shape-{}.json", stems[p], k + 1);
      const std::string text = result_text(document, pose, system, problem.value().supports.removed_motions(), e,
                                           warnings(system, e.state, stretch_share(pose, e.state.load_factor)));
      if (const Status s = output.write(name, text); !s) return s.error();
    }
    if (command.picture && !found.search.branches.empty()) {
      const Result<std::string> picture = picture_of(document, pose, system, found, *command.picture);
      if (!picture) return picture.error();
      const char* ending = *command.picture == ImageFormat::kSvg ? "-branches.svg" : "-branches.png";
      if (const Status s = output.write(stems[p] + ending, picture.value()); !s) return s.error();
    }
    found.files = output.take_written();
    found.summary = branches_summary(found);
    results.push_back(std::move(found));
    if (context.cancelled()) break;
  }
  return results;
}

}  // namespace lissom
