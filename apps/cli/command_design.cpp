// lissom design PROJECT

#include "lissom/session/command_design.h"

#include <cmath>
#include <fmt/format.h>

#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/terminal.h"
#include "lissom/core/file_io.h"
#include "lissom/model/document.h"
#include "lissom/model/rod_mesh_document.h"
#include "lissom/session/design_run.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string file, folder;
  bool resume = false, json = false;
  RunOptions run;
};

std::string in_mm(double metres) {
  return std::isfinite(metres) ? fmt::format("{:.3g} mm", 1e3 * metres) : std::string("no stable shape");
}

void print_project(const DesignedProject& done) {
  print(fmt::format("{} rods, {} joints, {} nodes, {} edges\n", done.rods, done.joints, done.nodes, done.edges));
  print(fmt::format("{}: {} ({} iterations)\n", design_verdict_info(done.design.verdict).name, done.design.message,
                    done.design.iterations));
  for (const PoseOutcome& pose : done.poses) {
    print(fmt::format("  {}{}: moves by {} ({} at most), misses by {}, at the start {}\n", pose.name,
                      pose.held_back ? " (held back)" : "", in_mm(pose.moved), in_mm(pose.farthest), in_mm(pose.after),
                      in_mm(pose.before)));
  }
  if (!done.poses.empty()) {
    print(fmt::format(
        "  all designed poses: miss by {}, at the start {}{}\n", in_mm(done.rms_after(false)),
        in_mm(done.rms_before(false)),
        std::isfinite(done.rms_radii_only()) ? ", with other radii alone " + in_mm(done.rms_radii_only()) : ""));
  }
  for (const std::string& note : done.notes) print("  note: " + note + "\n");
  if (done.print) {
    for (const PrintedObject& o : done.print->objects) {
      print(
          fmt::format("  to be printed in {}: {:.1f} cm\u00b3, {:.1f} g\n", o.material, 1e6 * o.volume, 1e3 * o.mass));
    }
    for (const PrintFinding& f : done.print->findings) {
      print(fmt::format("  {}: {} at {}; {}\n", f.weight == PrintFinding::Weight::kError ? "error" : "warning", f.what,
                        f.where, f.remedy));
    }
  }
  for (const std::filesystem::path& file : done.files) print("  wrote " + file.string() + "\n");
}

Result<DesignedProject> designed(const Arguments& arguments, const Context& context) {
  DesignCommand command;
  if (arguments.resume) command.begin = DesignCommand::Begin::kResume;
  command.line = "lissom design " + arguments.file + (arguments.folder.empty() ? "" : " -o " + arguments.folder);
  command.version = LISSOM_VERSION;
  const Result<std::string> text = read_file(arguments.file, kLargestDocument);
  if (text.ok() && is_project(text.value())) {
    const Result<Project> project = read_project_file(arguments.file);
    if (!project) return project.error();
    command.folder =
        arguments.folder.empty() ? project.value().folder / "out" : std::filesystem::path(arguments.folder);
    return design_command(project.value(), command, context);
  }
  const Result<Document> document = read_input(arguments.file);
  if (!document) return document.error();
  command.folder =
      arguments.folder.empty() ? document.value().default_output() : std::filesystem::path(arguments.folder);
  return design_command(document.value(), command, context);
}

int design(const Arguments& arguments) {
  Run run(arguments.run);
  const Result<DesignedProject> done = designed(arguments, run.context());
  run.clear_line();
  if (!done) {
    const int code = report(done.error(), arguments.file);
    return run.context().cancelled() ? exit_code(DesignVerdict::kCancelled) : code;
  }
  if (arguments.json) {
    print(done.value().summary + "\n");
  } else {
    print_project(done.value());
  }
  if (done.value().print && done.value().print->errors > 0) return kFailed;
  return exit_code(done.value().design.verdict);
}

}  // namespace

void add_design(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("design", "From a surface and its poses to a mesh of rods that takes them");
  command->add_option("project", arguments->file, "Project (JSON with \"lissom_project\")")->required();
  command->add_option("-o,--output", arguments->folder, "Folder for results [out, next to the project]");
  command->add_flag("--resume", arguments->resume, "Go on from what an earlier run left in the folder");
  command->add_flag("--json", arguments->json, "Print one JSON object (SI units) and nothing else");
  add_run_options(*command, arguments->run);
  command->footer(
      "Reads and mends the surface, lays rods on it, finds the shapes of the poses, and works on radii and rest shape\n"
      "until the rods take them. Ctrl-C stops and keeps the best design so far; --resume goes on from there, also "
      "after\n"
      "a crash, and ends with the same bytes.\n\n"
      "Example:\n  lissom design hat.lissom\n\n"
      "Exit codes: those of `lissom optimize`.");
  command->callback([arguments, &chosen] { chosen = [arguments] { return design(*arguments); }; });
}

}  // namespace lissom::cli
