#include "lissom/session/command_design.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <variant>

#include "lissom/core/file_io.h"
#include "lissom/equilibrium/settled.h"
#include "lissom/model/document.h"
#include "lissom/session/design_tables.h"
#include "lissom/session/output.h"
#include "lissom/session/posed_mesh_file.h"

namespace lissom {

namespace {

/// Names of the files between the steps.
std::string rods_name(const Project& project) { return project.name + "-rods.lissom"; }
std::string poses_name(const Project& project) { return project.name + "-poses.json"; }

double rms_of(const std::vector<PoseOutcome>& poses, bool held_back, double PoseOutcome::*miss) {
  double squares = 0;
  int count = 0;
  for (const PoseOutcome& pose : poses) {
    if (pose.held_back != held_back) continue;
    squares += pose.*miss * (pose.*miss);
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : std::numeric_limits<double>::quiet_NaN();
}

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
  const Result<Equilibrium> found = settled(model, system.value(), described, described.name, context);
  if (!found) return found.error();
  if (found.value().verdict != Verdict::kStable) return std::numeric_limits<double>::quiet_NaN();
  double squares = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    squares += (found.value().state.position(static_cast<int>(i)) - targets[i]).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(targets.size()));
}

/// A pose with a place for every node.
struct Wanted {
  int pose = -1;
  bool held_back = false;
  const std::vector<Vec3>* targets = nullptr;
};

std::vector<Wanted> wanted_of(const Model& model, std::size_t nodes) {
  std::vector<Wanted> all;
  for (const GoalBrief& goal : model.design->goals) {
    const auto* places = std::get_if<PositionsGoal>(&goal.what);
    if (places == nullptr || places->targets.size() != nodes) continue;
    for (std::size_t k = 0; k < model.poses.size(); ++k) {
      if (goal.pose.empty() || model.poses[k].name == goal.pose) {
        all.push_back({static_cast<int>(k), false, &places->targets});
        break;
      }
    }
  }
  return all;
}

std::vector<Wanted> wanted_of(const Project& project, const PosedMesh& mesh) {
  std::vector<Wanted> all;
  for (std::size_t k = 0; k < mesh.targets.size(); ++k) {
    all.push_back({static_cast<int>(k), project.description.poses[k].held_back, &mesh.targets[k]});
  }
  return all;
}

double measured(const std::vector<GoalMeasure>& measures, int pose) {
  for (const GoalMeasure& measure : measures) {
    if (measure.pose == pose && measure.unit == "m") return measure.rms;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

bool only_radii(const std::vector<ParameterBrief>& parameters) {
  return std::all_of(parameters.begin(), parameters.end(),
                     [](const ParameterBrief& p) { return std::holds_alternative<RadiiBrief>(p.what); });
}

/// What the last stage that changes nothing but radii has left of a pose.
double radii_only(const Brief& brief, const OptimizedDesign& design, int pose) {
  double left = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t s = 0; s < design.stages.size(); ++s) {
    if (!only_radii(s < brief.stages.size() ? brief.stages[s].parameters : brief.parameters)) break;
    for (std::size_t g = 0; g < design.after.size(); ++g) {
      if (design.after[g].pose == pose && design.after[g].unit == "m") left = design.stages[s].rms[g];
    }
  }
  return left;
}

/// Designed poses as the run measured them, held back ones solved before and after.
Status judge(const Model& start, const Structure& structure, const std::vector<Wanted>& wanted, const Context& context,
             DesignedProject& done) {
  for (const Wanted& w : wanted) {
    PoseOutcome outcome;
    outcome.name = start.poses[static_cast<std::size_t>(w.pose)].name;
    outcome.held_back = w.held_back;
    double squares = 0;
    for (std::size_t n = 0; n < structure.nodes.size(); ++n) {
      const double way = ((*w.targets)[n] - structure.nodes[n]).norm();
      squares += way * way;
      outcome.farthest = std::max(outcome.farthest, way);
    }
    outcome.moved = std::sqrt(squares / static_cast<double>(structure.nodes.size()));
    if (w.held_back) {
      const Result<double> before = missed(start, w.pose, *w.targets, context);
      if (!before) return before.error();
      const Result<double> after = missed(done.design.model, w.pose, *w.targets, context);
      if (!after) return after.error();
      outcome.before = before.value();
      outcome.after = after.value();
    } else {
      outcome.before = measured(done.design.before, w.pose);
      outcome.after = measured(done.design.after, w.pose);
      outcome.radii_only = radii_only(*start.design, done.design, w.pose);
    }
    done.poses.push_back(outcome);
  }
  return {};
}

int count_joints(const Structure& structure) {
  std::set<int> ends;
  for (const StructureRod& rod : structure.rods) {
    if (!rod.closed) ends.insert({rod.nodes.front(), rod.nodes.back()});
  }
  return static_cast<int>(ends.size());
}

/// Work on the brief and what comes of it, for both kinds of input.
Result<DesignedProject> work(const Document& document, const std::vector<Wanted>& wanted, const Structure& structure,
                             const MeshPrint& print, const DesignCommand& command, const Context& context) {
  DesignedProject done;
  done.rods = static_cast<int>(structure.rods.size());
  done.joints = count_joints(structure);
  done.nodes = static_cast<int>(structure.nodes.size());
  done.edges = static_cast<int>(structure.edges.size());
  OptimizeCommand optimize;
  optimize.folder = command.folder;
  optimize.line = command.line;
  optimize.version = command.version;
  const std::filesystem::path checkpoint = command.folder / (document.name + "-design.checkpoint.json");
  if (command.begin == DesignCommand::Begin::kResume && std::filesystem::exists(checkpoint)) {
    optimize.begin = OptimizeCommand::Begin::kResume;
  }
  Result<OptimizedDesign> design = optimize_command(document, optimize, context);
  if (!design) return design.error();
  done.design = std::move(design).value();
  done.files = done.design.files;
  if (done.design.verdict == DesignVerdict::kCancelled) return done;
  if (Status s = judge(document.model, structure, wanted, context, done); !s) return s.error();
  PrintCommand printing;
  printing.file = command.folder / (document.name + ".3mf");
  printing.process = print.process;
  printing.solid.tolerance = print.tolerance;
  printing.bed = print.bed;
  Result<PrintOutcome> printed = print_command({document.name, command.folder, done.design.model}, printing, context);
  if (!printed) return printed.error();
  done.print = std::move(printed).value();
  if (!done.print->file.empty()) done.files.push_back(done.print->file);
  return done;
}

/// The page once more, with what only this command knows.
Status finish(const Document& document, const DesignCommand& command, DesignedProject& done) {
  DesignReport& report = done.design.report;
  report.project = project_tables(done);
  if (done.print) report.print = print_tables(*done.print);
  if (done.print && !done.print->file.empty()) report.files.push_back(done.print->file.filename().string());
  Output output(command.folder);
  if (Status s = output.write(document.name + "-design.html", design_report_html(report)); !s) return s;
  done.summary = summary_of(document.name, done);
  return {};
}

}  // namespace

double DesignedProject::rms_before(bool held_back) const { return rms_of(poses, held_back, &PoseOutcome::before); }
double DesignedProject::rms_after(bool held_back) const { return rms_of(poses, held_back, &PoseOutcome::after); }
double DesignedProject::rms_radii_only() const { return rms_of(poses, false, &PoseOutcome::radii_only); }

Result<DesignedProject> design_command(const Project& project, const DesignCommand& command, const Context& context) {
  Output output(command.folder);
  if (const Status s = output.prepare(); !s) return s.error();
  const Result<PosedMesh> mesh = make_mesh(project, command, output, context);
  if (!mesh) return mesh.error();
  const Result<Structure> structure = discretize(mesh.value().model);
  if (!structure) return structure.error();
  const Document document{project.name, command.folder, mesh.value().model};
  Result<DesignedProject> done =
      work(document, wanted_of(project, mesh.value()), structure.value(), project.description.print, command, context);
  if (!done) return done;
  const std::vector<std::filesystem::path> written = output.take_written();
  done.value().files.insert(done.value().files.begin(), written.begin(), written.end());
  done.value().notes = project.notes;
  for (const std::string& note : mesh.value().notes) done.value().notes.push_back(note);
  if (Status s = finish(document, command, done.value()); !s) return s.error();
  return done;
}

Result<DesignedProject> design_command(const Document& document, const DesignCommand& command, const Context& context) {
  if (!document.model.design) {
    return Error{ErrorCode::kConflict, document.name, "the document does not say what may change and what is wanted",
                 "give it a \"design\" section, or start from a project with a surface (`lissom examples`)"};
  }
  const Result<Structure> structure = discretize(document.model);
  if (!structure) return structure.error();
  Result<DesignedProject> done = work(document, wanted_of(document.model, structure.value().nodes.size()),
                                      structure.value(), {}, command, context);
  if (!done) return done;
  if (Status s = finish(document, command, done.value()); !s) return s.error();
  return done;
}

}  // namespace lissom
