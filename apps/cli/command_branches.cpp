// lissom branches FILE

#include "lissom/session/command_branches.h"

#include <fmt/format.h>

#include "apps/cli/arguments.h"
#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/solver_arguments.h"
#include "apps/cli/terminal.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string file, folder, picture = "png";
  BranchesCommand command;
  bool json = false;
  RunOptions run;
};

void print_branches(const PoseBranches& found) {
  const BranchSearch& search = found.search;
  print(fmt::format("{}: {} stable shape{} from {} solves{}\n", found.pose, search.branches.size(),
                    search.branches.size() == 1 ? "" : "s", search.solves,
                    search.exhausted ? "" : "; the limit of solves ended the search, raise it with --most"));
  if (search.drawn_negative > 0) {
    print(fmt::format("  drawn shape        unstable in {} mode{}\n", search.drawn_negative,
                      search.drawn_negative == 1 ? "" : "s"));
  }
  for (size_t k = 0; k < search.branches.size(); ++k) {
    const Branch& branch = search.branches[k];
    const double lowest = branch.equilibrium.modes.empty() ? 0 : branch.equilibrium.modes.front().stiffness;
    std::string remarks;
    if (branch.barrier_free) remarks += ", downhill from the drawn shape";
    if (branch.mirrored) remarks += ", its mirror image too";
    if (branch.same_energy_as >= 0) {
      remarks += fmt::format(", shape {} under a symmetry of the plan", branch.same_energy_as + 1);
    }
    print(fmt::format("  shape {:<3} {:>12.6g} mJ  {:>7.2f} mm high, lowest mode {:.3g} N/m{}\n", k + 1,
                      1e3 * branch.equilibrium.energy, 1e3 * found.heights[k], lowest, remarks));
  }
  for (const std::filesystem::path& file : found.files) print("  wrote " + file.string() + "\n");
}

int search_branches(Arguments& arguments) {
  const Result<Document> document = read_input(arguments.file);
  if (!document) return report(document.error(), arguments.file);
  BranchesCommand& command = arguments.command;
  command.folder =
      arguments.folder.empty() ? document.value().default_output() : std::filesystem::path(arguments.folder);
  command.picture = format_named(arguments.picture);
  Run run(arguments.run);
  const Result<std::vector<PoseBranches>> results = branches_command(document.value(), command, run.context());
  run.clear_line();
  if (!results) return report(results.error(), arguments.file);
  int code = kDone;
  std::vector<std::string> summaries;
  for (const PoseBranches& found : results.value()) {
    if (found.search.branches.empty()) code = verdict_info(Verdict::kUnstable).exit_code;
    summaries.push_back(found.summary);
    if (!arguments.json) print_branches(found);
  }
  if (arguments.json) print_json_list("poses", summaries);
  return code;
}

}  // namespace

void add_branches(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("branches", "Search for the stable shapes of a design");
  command->add_option("file", arguments->file, kInputHelp)->required();
  command->add_option("--pose", arguments->command.poses, "Pose to look at; may be repeated [all]")
      ->allow_extra_args(false);
  command->add_option("--most", arguments->command.options.most_solves, "Limit of solves [80]")
      ->check(CLI::Range(1, 100000));
  command->add_option("--pushes", arguments->command.options.modes, "How many low modes push a shape [4]")
      ->check(CLI::Range(1, 100));
  command->add_option("-o,--output", arguments->folder, "Folder for results [out, next to the document]");
  command->add_flag("--json", arguments->json, "Print one JSON object (SI units) and nothing else");
  command->add_option("--picture", arguments->picture, "Format of the picture of the shapes, svg or png [png]")
      ->check(CLI::IsMember({"svg", "png"}));
  add_solver_options(*command, arguments->command.options.solve);
  add_run_options(*command, arguments->run);
  command->footer(
      std::string("From the drawn shape, and from every shape found, low modes push to both sides; what settles is\n"
                  "compared with what is known, mirror images included. One result file per shape: `lissom solve\n"
                  "--resume` goes on from it.\n\nExample:\n  lissom branches frame.lissom --most 200\n\n") +
      exit_codes_text());
  command->callback([arguments, &chosen] { chosen = [arguments] { return search_branches(*arguments); }; });
}

}  // namespace lissom::cli
