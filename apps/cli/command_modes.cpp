// lissom modes FILE

#include "lissom/session/command_modes.h"

#include <fmt/format.h>

#include "apps/cli/arguments.h"
#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/solver_arguments.h"
#include "apps/cli/terminal.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string file, folder, picture = "svg";
  ModesCommand command;
  bool json = false, vtu = false;
  RunOptions run;
};

void print_modes(const PoseModes& modes) {
  print(fmt::format("{}: {}\n", modes.pose, modes.equilibrium.message));
  if (!modes.remark.empty()) print("  " + modes.remark + "\n");
  for (size_t i = 0; i < modes.equilibrium.modes.size(); ++i) {
    print(fmt::format("  softest motion {:<3} {:>12.6g} N/m\n", i, modes.equilibrium.modes[i].stiffness));
  }
  for (size_t i = 0; i < modes.vibrations.size(); ++i) {
    const NaturalMode& mode = modes.vibrations[i];
    const std::string value = mode.unstable() ? fmt::format("{:>12.6g} 1/s, grows", mode.growth_rate)
                                              : fmt::format("{:>12.6g} Hz", mode.frequency);
    print(fmt::format("  vibration {:<8} {}  bending {:.0f} %, along the rods {:.0f} %, torsion {:.0f} %\n", i, value,
                      100 * mode.bending, 100 * mode.axial, 100 * mode.torsional));
  }
  for (const std::filesystem::path& file : modes.files) print("  wrote " + file.string() + "\n");
}

int find_modes(Arguments& arguments) {
  const Result<Document> document = read_input(arguments.file);
  if (!document) return report(document.error(), arguments.file);
  ModesCommand& command = arguments.command;
  command.folder =
      arguments.folder.empty() ? document.value().default_output() : std::filesystem::path(arguments.folder);
  command.vtu = arguments.vtu ? ParaView::kYes : ParaView::kNo;
  command.picture = format_named(arguments.picture);
  Run run(arguments.run);
  const Result<std::vector<PoseModes>> results = modes_command(document.value(), command, run.context());
  run.clear_line();
  if (!results) return report(results.error(), arguments.file);
  int code = kDone;
  std::vector<std::string> summaries;
  for (const PoseModes& modes : results.value()) {
    if (code == kDone) code = verdict_info(modes.equilibrium.verdict).exit_code;
    summaries.push_back(modes.summary);
    if (!arguments.json) print_modes(modes);
  }
  if (arguments.json) print_json_list("poses", summaries);
  return code;
}

}  // namespace

void add_modes(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("modes", "Find the softest motions and the natural vibrations of a shape at rest");
  command->add_option("file", arguments->file, kInputHelp)->required();
  command->add_option("--pose", arguments->command.poses, "Pose to look at; may be repeated [all]")
      ->allow_extra_args(false);
  command->add_option("--count", arguments->command.count, "How many of each [6]")->check(CLI::Range(1, 1000));
  command->add_option("-o,--output", arguments->folder, "Folder for results [out, next to the document]");
  command->add_flag("--json", arguments->json, "Print one JSON object (SI units) and nothing else");
  command->add_option("--picture", arguments->picture, "Format of the picture of the modes, svg or png [svg]")
      ->check(CLI::IsMember({"svg", "png"}));
  command->add_flag("--vtu", arguments->vtu, "Also write a .vtu file per mode for ParaView");
  add_solver_options(*command, arguments->command.options);
  add_run_options(*command, arguments->run);
  command->footer(
      std::string(
          "The stiffness of a motion (N/m) says how much energy it costs: half of it times the square of the mean\n"
          "displacement. Frequencies are in Hz. Pictures exaggerate.\n\nExample:\n  lissom modes bridge.lissom --count "
          "4\n\n") +
      exit_codes_text());
  command->callback([arguments, &chosen] { chosen = [arguments] { return find_modes(*arguments); }; });
}

}  // namespace lissom::cli
