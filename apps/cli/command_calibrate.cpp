// lissom calibrate FILE

#include "lissom/session/command_calibrate.h"

#include <algorithm>
#include <fmt/format.h>

#include "apps/cli/arguments.h"
#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/terminal.h"
#include "lissom/session/command_optimize.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string file, folder, picture = "svg";
  bool json = false;
  RunOptions run;
};

void print_calibration(const CalibratedDocument& done) {
  print(fmt::format("{}: {} ({} iterations)\n{}\n", design_verdict_info(done.verdict).name, done.message,
                    done.iterations, done.counts));
  size_t name = 9, value = 5, interval = 8 + done.confidence.size();
  for (const CertaintyWords& w : done.parameters) {
    name = std::max(name, w.name.size());
    value = std::max(value, w.value.size());
    interval = std::max(interval, w.interval.size());
  }
  const auto row = [&](const std::string& a, const std::string& b, const std::string& c, const std::string& d) {
    std::string line = fmt::format("  {:<{}}  {:>{}}  {:>{}}  {}", a, name, b, value, c, interval, d);
    line.erase(line.find_last_not_of(' ') + 1);
    print(line + "\n");
  };
  row("parameter", "value", done.confidence + " interval", "standard error");
  for (const CertaintyWords& w : done.parameters) {
    row(w.name, w.value.empty() ? "-" : w.value, w.interval, w.remark.empty() ? w.error : w.remark);
  }
  for (const std::string& set : done.sets) print("  " + set + "\n");
  for (const std::string& note : done.notes) print("  note: " + note + "\n");
  for (const std::filesystem::path& file : done.files) print("  wrote " + file.string() + "\n");
}

int calibrate(const Arguments& arguments) {
  const Result<Document> document = read_input(arguments.file);
  if (!document) return report(document.error(), arguments.file);
  CalibrateCommand command;
  command.folder =
      arguments.folder.empty() ? document.value().default_output() : std::filesystem::path(arguments.folder);
  command.picture = format_named(arguments.picture);
  command.line = "lissom calibrate " + arguments.file;
  if (!arguments.folder.empty()) command.line += " -o " + arguments.folder;
  command.version = LISSOM_VERSION;
  Run run(arguments.run);
  const Result<CalibratedDocument> done = calibrate_command(document.value(), command, run.context());
  run.clear_line();
  if (!done) {
    const int code = report(done.error(), arguments.file);
    return run.context().cancelled() ? exit_code(DesignVerdict::kCancelled) : code;
  }
  if (arguments.json) {
    print(done.value().summary + "\n");
  } else {
    print_calibration(done.value());
  }
  return done.value().code;
}

}  // namespace

void add_calibrate(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("calibrate", "Find moduli from measured forces, lengths and shapes");
  command->add_option("file", arguments->file, kInputHelp)->required();
  command->add_option("-o,--output", arguments->folder, "Folder for results [out, next to the document]");
  command->add_option("--picture", arguments->picture, "Format of the charts, svg or png [svg]")
      ->check(CLI::IsMember({"svg", "png"}));
  command->add_flag("--json", arguments->json, "Print one JSON object (SI units) and nothing else");
  add_run_options(*command, arguments->run);
  command->footer(
      "What is unknown and where the measurements are is said under \"calibration\" in the document. Files of\n"
      "measurements are CSV with units in the header: \"force [N], length [mm]\" or \"place, x [mm], y [mm], z "
      "[mm]\".\n\n"
      "Example:\n  lissom calibrate strip.lissom\n\n"
      "Exit codes: 0 all parameters are determined; 2 wrong arguments; 3 something is wrong in a document or a file "
      "of\n"
      "measurements; 4 a file cannot be read or written; 12 out of iterations; 13 no step lowers the deviations;\n"
      "15 stopped by you; 17 every step snaps to another shape; 18 every step ends without a stable shape;\n"
      "20 a parameter is at a bound, or not determined.");
  command->callback([arguments, &chosen] { chosen = [arguments] { return calibrate(*arguments); }; });
}

}  // namespace lissom::cli
