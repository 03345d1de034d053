// lissom print FILE

#include "lissom/session/command_print.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "apps/cli/arguments.h"
#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/terminal.h"
#include "lissom/fabrication/exporters.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string file, output, tolerance = "0.1 mm", diameter, gap, bed;
  double cost = -1;
  bool json = false, force = false, no_poses = false, processes = false;
  PrintCommand command;
  RunOptions run;
};

void line(std::string_view name, const std::string& text) { print(fmt::format("  {:<12}{}\n", name, text)); }

int list_processes() {
  for (const PrintProcess& p : print_processes()) {
    print(fmt::format("{}: {}\n", p.name, p.description));
    line("diameter", fmt::format("{:.3g} mm at least", 1e3 * p.diameter));
    line("gap", fmt::format("{:.3g} mm at least", 1e3 * p.gap));
    line("bed", fmt::format("{:.0f} x {:.0f} x {:.0f} mm", 1e3 * p.bed.x(), 1e3 * p.bed.y(), 1e3 * p.bed.z()));
    line("cost", fmt::format("{:.3g} euro per kg", p.cost));
    line("sources", std::string(p.source));
  }
  return kDone;
}

/// "250 x 210 x 210 mm", with or without spaces.
Result<Vec3> bed_of(const std::string& text) {
  Vec3 bed;
  int used = 0;
  const bool read = std::sscanf(text.c_str(), "%lf x %lf x %lf mm%n", &bed.x(), &bed.y(), &bed.z(), &used) == 3;
  if (read && used == static_cast<int>(text.size()) && bed.minCoeff() > 0 && bed.allFinite()) return Vec3(bed / 1e3);
  return Error{ErrorCode::kSyntax, "--bed", "\"" + text + "\" is no size of a bed",
               "write three lengths, such as \"250 x 210 x 210 mm\""};
}

Status read_options(Arguments& arguments) {
  const auto length = [](const std::string& text, const char* option, std::optional<double>& value) -> Status {
    if (text.empty()) return {};
    const Result<double> found = length_of(text, option);
    if (!found) return found.error();
    value = found.value();
    return {};
  };
  PrintCommand& command = arguments.command;
  std::optional<double> tolerance;
  if (Status s = length(arguments.tolerance, "--tolerance", tolerance); !s) return s;
  if (Status s = length(arguments.diameter, "--min-diameter", command.diameter); !s) return s;
  if (Status s = length(arguments.gap, "--gap", command.gap); !s) return s;
  command.solid.tolerance = tolerance.value_or(command.solid.tolerance);
  if (!arguments.bed.empty()) {
    const Result<Vec3> bed = bed_of(arguments.bed);
    if (!bed) return bed.error();
    command.bed = bed.value();
  }
  if (arguments.cost >= 0) command.cost = arguments.cost;
  if (arguments.no_poses) command.poses = PrintCommand::Poses::kSkip;
  if (arguments.force) command.on_errors = PrintCommand::OnErrors::kWrite;
  return {};
}

constexpr std::size_t kFindingsShown = 12;

void print_findings(const std::vector<PrintFinding>& findings) {
  for (std::size_t i = 0; i < std::min(findings.size(), kFindingsShown); ++i) {
    const PrintFinding& f = findings[i];
    line(f.weight == PrintFinding::Weight::kError ? "error" : "warning",
         fmt::format("{}, {}: {}", f.what, f.where, f.remedy));
  }
  if (findings.size() > kFindingsShown) {
    line("", fmt::format("and {} more; --json lists them all", findings.size() - kFindingsShown));
  }
}

void print_outcome(const PrintOutcome& o, const PrintCommand& command) {
  for (const PrintedObject& object : o.objects) {
    print(fmt::format("{}: {:.4g} cm³, {:.4g} g, about {:.2f} euro of material\n", object.material, 1e6 * object.volume,
                      1e3 * object.mass, object.cost));
    line("surface",
         fmt::format("{} triangles, closed, without self-intersections; {}{}", object.triangles,
                     object.parts == 1 ? "one part" : fmt::format("{} parts", object.parts),
                     object.cavities > 0 ? fmt::format("; {} closed cavities filled", object.cavities) : ""));
  }
  line("size", fmt::format("{:.4g} x {:.4g} x {:.4g} mm", 1e3 * o.size.x(), 1e3 * o.size.y(), 1e3 * o.size.z()));
  if (o.tolerance > command.solid.tolerance * 1.001) {
    line("note",
         fmt::format("fine edges are within {:.2g} mm instead of {:.2g} mm, to keep the number of triangles down",
                     1e3 * o.tolerance, 1e3 * command.solid.tolerance));
  }
  for (const PoseStrain& s : o.strains) {
    line("strain", fmt::format("pose {}: {:.3g} % at {}{}", s.pose, 100 * s.strain, s.place,
                               std::isfinite(s.limit) ? fmt::format(", {:.3g} % allowed", 100 * s.limit) : ""));
  }
  print_findings(o.findings);
  if (!o.file.empty()) line("wrote", o.file.string());
  if (o.file.empty()) {
    line("not written", fmt::format("{} error{}; --force writes all the same", o.errors, o.errors == 1 ? "" : "s"));
  }
}

int print_file(Arguments& arguments) {
  if (arguments.processes) return list_processes();
  if (arguments.file.empty() || arguments.output.empty()) {
    std::fputs("lissom: print needs a document and --out FILE (`lissom print --help` explains)\n", stderr);
    return kUsage;
  }
  if (const Status s = read_options(arguments); !s) {
    report(s.error());
    return kUsage;
  }
  const Result<Document> document = read_input(arguments.file);
  if (!document) return report(document.error(), arguments.file);
  arguments.command.file = arguments.output;
  Run run(arguments.run);
  const Result<PrintOutcome> outcome = print_command(document.value(), arguments.command, run.context());
  run.clear_line();
  if (!outcome) return report(outcome.error(), arguments.file);
  if (arguments.json) {
    print(outcome.value().summary + "\n");
  } else {
    print_outcome(outcome.value(), arguments.command);
  }
  return outcome.value().file.empty() ? kFailed : kDone;
}

}  // namespace

void add_print(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("print", "Make rods a solid, and write a file that a printer takes");
  command->add_option("file", arguments->file, kInputHelp);
  command->add_option("-o,--out", arguments->output, "File to write, .3mf or .stl");
  command
      ->add_option("--process", arguments->command.process,
                   "sls, fdm or sla: what thin rods, gaps and sizes are checked for [fdm]")
      ->check(CLI::IsMember({"sls", "fdm", "sla"}));
  command->add_flag("--processes", arguments->processes, "List the numbers of the processes, with sources");
  command->add_option("--tolerance", arguments->tolerance, "Between the rods and the triangles [0.1 mm]");
  command->add_option("--min-diameter", arguments->diameter, "Thinnest rod, such as \"0.8 mm\" [of the process]");
  command->add_option("--gap", arguments->gap,
                      "Between rods that are not to fuse, such as \"0.5 mm\" [of the process]");
  command->add_option("--bed", arguments->bed, "Size of the printer, such as \"250 x 210 x 210 mm\" [of the process]");
  command->add_option("--cost", arguments->cost, "Of the material, euro per kg [of the process]")
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--no-poses", arguments->no_poses, "Do not solve the poses, so not look at strains");
  command->add_flag("--force", arguments->force, "Write the file in spite of errors");
  command->add_flag("--json", arguments->json, "Print one JSON object (SI units) and nothing else");
  add_run_options(*command, arguments->run);
  command->footer(
      "Prints the drawn shape. Errors (thin rods, rods that touch or would fuse, more than the bed holds) forbid\n"
      "writing, exit code 1; strains beyond the material's limit in a pose are warned of.\n\nExample:\n"
      "  lissom print sheet.lissom --out sheet.3mf --process sls");
  command->callback([arguments, &chosen] { chosen = [arguments] { return print_file(*arguments); }; });
}

}  // namespace lissom::cli
