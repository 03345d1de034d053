#include "lissom/session/command_solve.h"

#include <algorithm>

#include "lissom/core/nearest_name.h"
#include "lissom/equilibrium/form_finding.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/mechanics/membrane_strain.h"
#include "lissom/session/fields.h"
#include "lissom/session/ghost_lines.h"
#include "lissom/session/output.h"
#include "lissom/session/pose_files.h"
#include "lissom/session/solved_remedy.h"
#include "lissom/view/picture.h"
#include "lissom/view/vtk_export.h"

namespace lissom {

namespace {

Status write_pose(const Document& document, const Pose& pose, const System& system, const std::string& stem,
                  const SolveCommand& command, SolvedPose& solved, Output& output) {
  const Equilibrium& e = solved.equilibrium;
  if (const Status s =
          output.write(stem + ".json", result_text(document, pose, system, solved.removed_motions, e, solved.warnings));
      !s)
    return s;
  if (e.verdict == Verdict::kBadStart) return {};
  const FieldSource source{document.model, system, e.state, &e.reaction, stretch_share(pose, e.state.load_factor)};
  Result<Drawing> drawing = draw_state(source, &pose);
  if (!drawing) return drawing.error();
  solved.largest_displacement = 0;
  for (int i = 0; i < system.layout.nodes(); ++i) {
    solved.largest_displacement =
        std::max(solved.largest_displacement, (e.state.position(i) - system.structure.nodes[i]).norm());
  }
  if (!system.structure.triangles.empty()) solved.totals = totals(system, e.state, source.stretch_share);
  const std::vector<double>& stress = drawing.value().field("stress")->values;
  if (!stress.empty()) solved.largest_stress = *std::max_element(stress.begin(), stress.end());
  if (command.vtu == ParaView::kYes) {
    if (const Status s = output.write(stem + ".vtu", vtu_bytes(drawing.value())); !s) return s;
  }
  if (!command.picture) return {};
  const PictureOptions options{.title = document.model.title.empty() ? document.name : document.model.title,
                               .field = command.field,
                               .membrane_field = field_of_membranes(drawing.value(), command.field)};
  const std::vector<Panel> panels{
      {{{draw_rest(system), Layer::Style::kGhost},
        {drawing.value(), Layer::Style::kSolid, ghost_lines(document.model, system, e.state)}},
       pose.name}};
  return output.write(stem + (*command.picture == ImageFormat::kSvg ? ".svg" : ".png"),
                      draw_picture(panels, options, *command.picture));
}

/// Puts what solving says of the remedy against slack fabric in the place of the estimate.
void solve_remedies(const Model& model, const Pose& pose, const std::string& where, const SolveOptions& options,
                    const Context& context, SolvedPose& solved) {
  const WarningLimits limits;
  for (Warning& warning : solved.warnings) {
    if (warning.what != "slack fabric") continue;
    const std::optional<SolvedRemedy> remedy =
        solved_remedy(model, pose, where, solved.equilibrium, limits.stretch, limits.wanted_stretch, options, context);
    if (remedy) {
      warning.remedy = warning.remedy.substr(0, warning.remedy.find(kEstimatedRemedy)) + solved_remedy_text(*remedy);
    }
  }
}

}  // namespace

Result<std::vector<SolvedPose>> solve_command(const Document& document, const SolveCommand& command,
                                              const Context& context) {
  if (const Status s = command.options.validate(); !s) return s.error();
  if (const Status s = check_load_factor(command.load_factor, "--load-factor"); !s) return s.error();
  std::vector<std::string> wanted = command.poses;
  if (command.resume && wanted.empty()) wanted = {command.resume->pose};
  const Result<std::vector<int>> poses = pose_numbers(document.model, wanted);
  if (!poses) return poses.error();
  if (command.resume && poses.value().size() != 1) {
    return Error{ErrorCode::kConflict, "--resume", "one pose can be resumed at a time", "name it with --pose"};
  }
  const Result<System> made = make_system(document.model);
  if (!made) return made.error();
  const System& system = made.value();
  if (command.resume) {
    if (const Status s = check_state(system, command.resume->state); !s) return s.error();
  }
  Output output(command.folder);
  if (const Status s = output.prepare(); !s) return s.error();
  const std::vector<std::string> stems = pose_file_names(document);
  std::vector<SolvedPose> results;
  for (const int p : poses.value()) {
    const Pose& pose = document.model.poses[p];
    const std::string where = "/poses/" + std::to_string(p);
    const Result<StaticProblem> problem = make_static_problem(document.model, system, pose, where);
    if (!problem) return problem.error();
    SolvedPose solved;
    solved.pose = pose.name;
    solved.nodes = system.layout.nodes();
    solved.unknowns = problem.value().supports.unknowns();
    solved.notes = system.structure.notes;
    solved.removed_motions = problem.value().supports.removed_motions();
    const State start = command.resume ? command.resume->state : start_state(problem.value(), pose);
    std::unique_ptr<System> found;  // with the rest shapes that form finding has made
    if (pose.form_finding) {
      if (command.load_factor != 1 || command.resume) {
        return Error{ErrorCode::kConflict, command.resume ? "--resume" : "--load-factor",
                     "the form of pose \"" + pose.name + "\" is found from the drawn shape at load factor 1",
                     "leave this option out"};
      }
      Result<FoundForm> form = find_form(document.model, system, pose, where, command.options, context);
      if (!form) return form.error();
      solved.equilibrium = std::move(form.value().equilibrium);
      found = std::move(form.value().system);
    } else {
      solved.equilibrium = solve(problem.value(), start, command.load_factor, command.options, context);
    }
    const System& shown = found ? *found : system;
    if (solved.equilibrium.verdict != Verdict::kBadStart) {
      const State& state = solved.equilibrium.state;
      solved.warnings = warnings(shown, state, stretch_share(pose, state.load_factor));
      if (!found && command.load_factor == 1) {
        solve_remedies(document.model, pose, where, command.options, context, solved);
      }
    }
    const Status status = write_pose(document, pose, shown, stems[p], command, solved, output);
    if (!status) return status.error();
    solved.files = output.take_written();
    solved.summary =
        result_summary(pose, shown, solved.removed_motions, solved.equilibrium, solved.warnings, solved.files);
    results.push_back(std::move(solved));
    if (context.cancelled()) break;
  }
  return results;
}

}  // namespace lissom
