#include "lissom/session/command_design.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "lissom/core/file_io.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/model/document.h"
#include "lissom/session/layout_json.h"
#include "lissom/session/output.h"
#include "lissom/session/posed_mesh_file.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;

/// Names of the files between the steps.
std::string rods_name(const Project& project) { return project.name + "-rods.lissom"; }
std::string poses_name(const Project& project) { return project.name + "-poses.json"; }

/// What an earlier run left; an error where it is not there or of another project.
Result<PosedMesh> left_mesh(const Project& project, const std::filesystem::path& folder) {
  const Result<Document> document = read_document_file(folder / rods_name(project));
  if (!document) return document.error();
  const std::filesystem::path path = folder / poses_name(project);
  const Result<std::string> text = read_file(path);
  if (!text) return text.error();
  return read_posed_mesh(text.value(), project.hash, document.value().model, path.string());
}

Result<PosedMesh> make_mesh(const Project& project, const DesignCommand& command, Output& output,
                            const Context& context) {
  if (command.begin == DesignCommand::Begin::kResume) {
    Result<PosedMesh> left = left_mesh(project, command.folder);
    if (left) return left;
  }
  Result<PosedMesh> made = pose_rod_mesh(project.description, project.files, context);
  if (!made) return made;
  if (Status s = output.write(rods_name(project), write_document(made.value().model, NetworkText::kRods)); !s) {
    return s.error();
  }
  if (Status s = output.write(poses_name(project), posed_mesh_text(made.value(), project.hash)); !s) return s.error();
  return made;
}

/// Root mean square distance of the nodes from their targets in the equilibrium of a pose, m; NaN without a stable one.
Result<double> missed(const Model& model, int pose, const std::vector<Vec3>& targets, const Context& context) {
  const Result<System> system = make_system(model);
  if (!system) return system.error();
  const Pose& described = model.poses[static_cast<std::size_t>(pose)];
  const Result<StaticProblem> problem = make_static_problem(model, system.value(), described, described.name);
  if (!problem) return problem.error();
  SolveOptions options;
  options.modes = 0;
  const Equilibrium found = solve(problem.value(), start_state(problem.value(), described), 1, options, context);
  if (found.verdict != Verdict::kStable) return std::numeric_limits<double>::quiet_NaN();
  double squares = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    squares += (found.state.position(static_cast<int>(i)) - targets[i]).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(targets.size()));
}

/// Designed poses as the run measured them, held back ones solved before and after.
Status judge(const Project& project, const PosedMesh& mesh, const Context& context, DesignedProject& done) {
  std::size_t goal = 0;
  for (std::size_t k = 0; k < project.description.poses.size(); ++k) {
    PoseOutcome outcome;
    outcome.name = mesh.model.poses[k].name;
    outcome.held_back = project.description.poses[k].held_back;
    outcome.deformation = mesh.deformation[k];
    if (outcome.held_back) {
      const int pose = static_cast<int>(k);
      const Result<double> before = missed(mesh.model, pose, mesh.targets[k], context);
      if (!before) return before.error();
      const Result<double> after = missed(done.design.model, pose, mesh.targets[k], context);
      if (!after) return after.error();
      outcome.before = before.value();
      outcome.after = after.value();
    } else {
      outcome.before = done.design.before[goal].rms;
      outcome.after = done.design.after[goal].rms;
      ++goal;
    }
    done.poses.push_back(outcome);
  }
  return {};
}

Json summary_of(const Project& project, const DesignedProject& done) {
  Json json;
  json["project"] = project.name;
  json["verdict"] = design_verdict_info(done.design.verdict).name;
  json["message"] = done.design.message;
  json["rods"] = done.rods;
  json["joints"] = done.joints;
  json["nodes"] = done.nodes;
  json["edges"] = done.edges;
  json["poses"] = Json::array();
  for (const PoseOutcome& pose : done.poses) {
    Json entry = {{"name", pose.name}, {"held_back", pose.held_back}, {"deformation", pose.deformation}};
    entry["rms_before"] = std::isfinite(pose.before) ? Json(pose.before) : Json();
    entry["rms_after"] = std::isfinite(pose.after) ? Json(pose.after) : Json();
    json["poses"].push_back(std::move(entry));
  }
  json["notes"] = done.notes;
  json["files"] = file_list(done.files);
  return json;
}

}  // namespace

Result<DesignedProject> design_command(const Project& project, const DesignCommand& command, const Context& context) {
  Output output(command.folder);
  if (const Status s = output.prepare(); !s) return s.error();
  const Result<PosedMesh> mesh = make_mesh(project, command, output, context);
  if (!mesh) return mesh.error();
  DesignedProject done;
  const Result<Structure> structure = discretize(mesh.value().model);
  if (!structure) return structure.error();
  done.rods = static_cast<int>(structure.value().rods.size());
  done.joints = mesh.value().joints;
  done.nodes = static_cast<int>(structure.value().nodes.size());
  done.edges = static_cast<int>(structure.value().edges.size());
  done.notes = project.notes;
  done.notes.insert(done.notes.end(), mesh.value().notes.begin(), mesh.value().notes.end());

  OptimizeCommand optimize;
  optimize.folder = command.folder;
  optimize.line = command.line;
  optimize.version = command.version;
  const Document document{project.name, command.folder, mesh.value().model};
  const std::filesystem::path checkpoint = command.folder / (project.name + "-design.checkpoint.json");
  if (command.begin == DesignCommand::Begin::kResume && std::filesystem::exists(checkpoint)) {
    optimize.begin = OptimizeCommand::Begin::kResume;
  }
  Result<OptimizedDesign> design = optimize_command(document, optimize, context);
  if (!design) return design.error();
  done.design = std::move(design).value();
  if (Status s = judge(project, mesh.value(), context, done); !s) return s.error();
  done.files = output.take_written();
  done.files.insert(done.files.end(), done.design.files.begin(), done.design.files.end());
  done.summary = json_line(summary_of(project, done));
  return done;
}

}  // namespace lissom
