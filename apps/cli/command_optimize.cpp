// lissom optimize FILE

#include "lissom/session/command_optimize.h"

#include <fmt/format.h>

#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/terminal.h"
#include "lissom/model/brief_methods.h"
#include "lissom/session/design_run.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string file, folder, method;
  int iterations = 0;  ///< 0: those of the document
  bool resume = false, json = false;
  RunOptions run;
};

void print_design(const OptimizedDesign& design) {
  print(fmt::format("{}: {} ({} iterations)\n", design_verdict_info(design.verdict).name, design.message,
                    design.iterations));
  for (size_t g = 0; g < design.after.size(); ++g) {
    print(fmt::format("  {}: misses by {}, at the start {}\n", design.after[g].name,
                      in_unit_of_goal(design.after[g].rms, design.after[g].unit),
                      in_unit_of_goal(design.before[g].rms, design.before[g].unit)));
  }
  for (const std::string& note : design.notes) print("  note: " + note + "\n");
  for (const std::filesystem::path& file : design.files) print("  wrote " + file.string() + "\n");
}

/// The line that makes the design again.
std::string line_of(const Arguments& arguments) {
  std::string line = "lissom optimize " + arguments.file;
  if (!arguments.folder.empty()) line += " -o " + arguments.folder;
  if (!arguments.method.empty()) line += " --method " + arguments.method;
  if (arguments.iterations > 0) line += fmt::format(" --iterations {}", arguments.iterations);
  return line;
}

int optimize(const Arguments& arguments) {
  const Result<Document> document = read_input(arguments.file);
  if (!document) return report(document.error(), arguments.file);
  OptimizeCommand command;
  command.folder =
      arguments.folder.empty() ? document.value().default_output() : std::filesystem::path(arguments.folder);
  if (!arguments.method.empty()) command.method = arguments.method;
  if (arguments.iterations > 0) command.iterations = arguments.iterations;
  if (arguments.resume) command.begin = OptimizeCommand::Begin::kResume;
  command.line = line_of(arguments);
  command.version = LISSOM_VERSION;
  Run run(arguments.run);
  const Result<OptimizedDesign> design = optimize_command(document.value(), command, run.context());
  run.clear_line();
  if (!design) {
    const int code = report(design.error(), arguments.file);
    return run.context().cancelled() ? exit_code(DesignVerdict::kCancelled) : code;
  }
  if (arguments.json) {
    print(design.value().summary + "\n");
  } else {
    print_design(design.value());
  }
  return exit_code(design.value().verdict);
}

}  // namespace

void add_optimize(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("optimize", "Find the design whose shapes come nearest to what is asked for");
  command->add_option("file", arguments->file, kInputHelp)->required();
  command->add_option("-o,--output", arguments->folder, "Folder for results [out, next to the document]");
  command->add_option("--method", arguments->method,
                      fmt::format("{} [that of the document]", fmt::join(kBriefMethods, ", ")));
  command->add_option("--iterations", arguments->iterations, "Limit of iterations [that of the document]")
      ->check(CLI::Range(1, 1000000));
  command->add_flag("--resume", arguments->resume, "Go on from the checkpoint in the folder");
  command->add_flag("--json", arguments->json, "Print one JSON object (SI units) and nothing else");
  add_run_options(*command, arguments->run);
  command->footer(
      "What may change and what is to be reached is said under \"design\" in the document. Ctrl-C stops and keeps the\n"
      "best design so far; --resume goes on from there, also after a crash, and ends with the same bytes.\n\n"
      "Example:\n  lissom optimize gridshell.lissom --iterations 200\n\n"
      "Exit codes: 0 converged, or good enough; 2 wrong arguments; 3 something is wrong in a document;\n"
      "4 a file cannot be read or written; 12 out of iterations; 13 no step lowers the objective; 15 stopped by you;\n"
      "16 the start has no finite value; 17 every step snaps to another shape; 18 every step ends without a stable\n"
      "shape; 19 hard goals that cannot be met.");
  command->callback([arguments, &chosen] { chosen = [arguments] { return optimize(*arguments); }; });
}

}  // namespace lissom::cli
