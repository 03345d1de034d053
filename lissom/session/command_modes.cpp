#include "lissom/session/command_modes.h"

#include <algorithm>
#include <fmt/format.h>

#include "lissom/equilibrium/form_finding.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/mechanics/membrane_strain.h"
#include "lissom/session/fields.h"
#include "lissom/session/modes_json.h"
#include "lissom/session/pose_files.h"
#include "lissom/view/picture.h"
#include "lissom/view/vtk_export.h"

namespace lissom {

namespace {

/// The state moved along a mode as far as can be seen: the largest displacement is a tenth of the size, less where that
/// would turn rods too far.
State moved_along(const System& system, const State& state, const VecX& shape) {
  double largest = 0;
  for (int i = 0; i < system.layout.nodes(); ++i) largest = std::max(largest, shape.segment<3>(3 * i).norm());
  const int frames = static_cast<int>(shape.size()) - 3 * system.layout.nodes();
  const double spin = frames > 0 ? shape.tail(frames).cwiseAbs().maxCoeff() : 0;
  double amplitude = 1e300;
  if (largest > 0) amplitude = 0.1 * system.structure.size / largest;
  amplitude =
      std::min({amplitude, 0.8 / std::max(largest_turn(system, state, shape), 1e-300), 1.5 / std::max(spin, 1e-300)});
  State moved;
  return advance(system, state, amplitude * shape, moved) ? moved : state;
}

/// What is drawn of a mode.
struct ModeView {
  std::string caption, stem;
  State state;
};

std::vector<ModeView> mode_views(const System& system, const PoseModes& result) {
  std::vector<ModeView> views;
  for (size_t i = 0; i < result.equilibrium.modes.size(); ++i) {
    const Mode& mode = result.equilibrium.modes[i];
    views.push_back({fmt::format("softest motion {}: {:.3g} N/m", i, mode.stiffness), fmt::format("soft-{}", i),
                     moved_along(system, result.equilibrium.state, mode.shape)});
  }
  for (size_t i = 0; i < result.vibrations.size(); ++i) {
    const NaturalMode& mode = result.vibrations[i];
    views.push_back({mode.unstable() ? fmt::format("vibration {}: grows, {:.3g} 1/s", i, mode.growth_rate)
                                     : fmt::format("vibration {}: {:.4g} Hz", i, mode.frequency),
                     fmt::format("vibration-{}", i), moved_along(system, result.equilibrium.state, mode.shape)});
  }
  return views;
}

Status write_views(const Document& document, const Pose& pose, const System& system, const std::string& stem,
                   const ModesCommand& command, const PoseModes& result, Output& output) {
  const std::vector<ModeView> views = mode_views(system, result);
  const double share = stretch_share(pose, result.equilibrium.state.load_factor);
  const FieldSource still{document.model, system, result.equilibrium.state, nullptr, share};
  if (command.picture && !views.empty()) {
    std::vector<Panel> panels;
    for (const ModeView& view : views) {
      const Result<Drawing> ghost = draw_state(still, nullptr);
      const Result<Drawing> solid = draw_state({document.model, system, view.state, nullptr, share}, &pose);
      if (!ghost) return ghost.error();
      if (!solid) return solid.error();
      panels.push_back({{{ghost.value(), Layer::Style::kGhost}, {solid.value(), Layer::Style::kSolid}}, view.caption});
    }
    PictureOptions options;
    options.title = (document.model.title.empty() ? document.name : document.model.title) + ", " + pose.name;
    options.columns = std::min(3, static_cast<int>(panels.size()));
    options.forces = Visibility::kHidden;
    options.ruler = Visibility::kHidden;
    const std::string ending = *command.picture == ImageFormat::kSvg ? ".svg" : ".png";
    if (const Status s = output.write(stem + "-modes" + ending, draw_picture(panels, options, *command.picture)); !s)
      return s;
  }
  if (command.vtu == ParaView::kNo) return {};
  for (const ModeView& view : views) {
    const Result<Drawing> drawing = draw_state({document.model, system, view.state, nullptr, share}, nullptr);
    if (!drawing) return drawing.error();
    if (const Status s = output.write(stem + "-" + view.stem + ".vtu", vtu_bytes(drawing.value())); !s) return s;
  }
  return {};
}

}  // namespace

Result<std::vector<PoseModes>> modes_command(const Document& document, const ModesCommand& command,
                                             const Context& context) {
  SolveOptions options = command.options;
  options.modes = command.count;
  if (const Status s = options.validate(); !s) return s.error();
  const Model& model = document.model;
  const Result<std::vector<int>> poses = pose_numbers(model, command.poses);
  if (!poses) return poses.error();
  const Result<System> made = make_system(model);
  if (!made) return made.error();
  const System& system = made.value();
  Output output(command.folder);
  if (const Status s = output.prepare(); !s) return s.error();
  const std::vector<std::string> stems = pose_file_names(document);
  std::vector<PoseModes> results;
  for (const int p : poses.value()) {
    const Pose& pose = model.poses[p];
    const std::string where = "/poses/" + std::to_string(p);
    PoseModes result;
    result.pose = pose.name;
    std::unique_ptr<System> found;  // with the rest shapes that form finding has made
    if (pose.form_finding) {
      Result<FoundForm> form = find_form(model, system, pose, where, options, context);
      if (!form) return form.error();
      result.equilibrium = std::move(form.value().equilibrium);
      found = std::move(form.value().system);
    } else {
      const Result<StaticProblem> problem = make_static_problem(model, system, pose, where);
      if (!problem) return problem.error();
      result.equilibrium = solve(problem.value(), start_state(problem.value(), pose), 1, options, context);
    }
    const System& shown = found ? *found : system;
    const Verdict verdict = result.equilibrium.verdict;
    const bool balanced = verdict == Verdict::kStable || verdict == Verdict::kCritical || verdict == Verdict::kUnstable;
    if (!balanced) {
      result.remark = "no modes: the structure is not in balance";
    } else if (!(system.rest.total_mass > 0)) {
      result.remark = "no vibrations: the materials have no density";
    } else {
      const Result<StaticProblem> free = make_static_problem(model, shown, pose, where, NullMotions::kKeep);
      if (!free) return free.error();
      Result<std::vector<NaturalMode>> modes =
          natural_modes(free.value(), result.equilibrium.state, command.count, RollInertia::kLumped, context);
      if (!modes) return modes.error();
      result.vibrations = std::move(modes).value();
    }
    if (const Status s = output.write(stems[p] + "-modes.json", modes_text(document, result)); !s) return s.error();
    if (balanced) {
      if (const Status s = write_views(document, pose, shown, stems[p], command, result, output); !s) return s.error();
    }
    result.files = output.take_written();
    result.summary = modes_summary(result);
    results.push_back(std::move(result));
    if (context.cancelled()) break;
  }
  return results;
}

}  // namespace lissom
