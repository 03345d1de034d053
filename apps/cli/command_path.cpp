// lissom path FILE

#include "lissom/session/command_path.h"

#include <fmt/format.h>
#include <map>

#include "apps/cli/arguments.h"
#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/solver_arguments.h"
#include "apps/cli/terminal.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string file, folder, axis, follow, picture = "svg";
  double from = 0, to = 1;
  int steps = 10;
  PathCommand command;
  bool json = false, vtu = false;
  RunOptions run;
};

void print_path(const FollowedPose& followed) {
  print(fmt::format("{}: {}\n", followed.pose, followed.path.message.empty() ? "arrived" : followed.path.message));
  print(fmt::format("  {:>12}  {:>14}  {:>14}  {:>16}  {}\n", "load factor", "moved [mm]", "energy [mJ]",
                    "softest [N/m]", "stable"));
  for (const std::vector<double>& row : followed.table.rows) {
    print(fmt::format("  {:>12.6g}  {:>14.6g}  {:>14.6g}  {:>16.6g}  {}\n", row[0], 1e3 * row[1], 1e3 * row[2], row[3],
                      row[4] == 0 ? "yes" : "no"));
  }
  print("  moved: displacement of " + followed.watched + "\n");
  for (const CriticalPoint& point : followed.path.critical) {
    print(fmt::format("  {} at load factor {:.8g}: {} unstable modes before, {} after\n",
                      critical_kind_name(point.kind), point.load_factor, point.negative_before, point.negative_after));
  }
  for (const std::filesystem::path& file : followed.files) print("  wrote " + file.string() + "\n");
}

int follow(const CLI::App& typed, Arguments& arguments) {
  const Result<Document> document = read_input(arguments.file);
  if (!document) return report(document.error(), arguments.file);
  PathCommand& command = arguments.command;
  if (typed.count("--from") > 0) command.from = arguments.from;
  if (typed.count("--to") > 0) command.to = arguments.to;
  if (typed.count("--steps") > 0) command.steps = arguments.steps;
  if (!arguments.follow.empty()) {
    command.follow = arguments.follow == "load" ? LoadPath::Follow::kLoad : LoadPath::Follow::kArcLength;
  }
  command.axis = axis_named(arguments.axis);
  command.folder =
      arguments.folder.empty() ? document.value().default_output() : std::filesystem::path(arguments.folder);
  command.vtu = arguments.vtu ? ParaView::kYes : ParaView::kNo;
  command.picture = format_named(arguments.picture);
  Run run(arguments.run);
  const Result<std::vector<FollowedPose>> results = path_command(document.value(), command, run.context());
  run.clear_line();
  if (!results) return report(results.error(), arguments.file);
  int code = kDone;
  std::vector<std::string> summaries;
  for (const FollowedPose& followed : results.value()) {
    if (code == kDone) code = path_end_info(followed.path.end).exit_code;
    summaries.push_back(followed.summary);
    if (!arguments.json) print_path(followed);
  }
  if (arguments.json) print_json_list("poses", summaries);
  return code;
}

}  // namespace

void add_path(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("path", "Follow a structure while its load grows; find where it buckles");
  command->add_option("file", arguments->file, kInputHelp)->required();
  command->add_option("--pose", arguments->command.poses, "Pose to follow; may be repeated [all]")
      ->allow_extra_args(false);
  command->add_option("--from", arguments->from, "First load factor [that of the pose, else 0]");
  command->add_option("--to", arguments->to, "Last load factor [that of the pose, else 1]");
  command->add_option("--steps", arguments->steps, "Recorded states in between [that of the pose, else 10]")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--follow", arguments->follow, "load, or arc_length to pass folds [that of the pose, else load]")
      ->check(CLI::IsMember({"load", "arc_length"}));
  command->add_flag("--stop-at-critical", arguments->command.stop_at_critical, "End at the first critical point");
  command->add_flag("--switch-branch", arguments->command.switch_branch,
                    "Leave on the other branch at the first bifurcation");
  command->add_option("--watch", arguments->command.watch,
                      "Place to plot: a set, or a rod and a place on it such as beam:0.5 [the node that moves most]");
  command->add_option("--axis", arguments->axis, "Plot its displacement along x, y or z [its size]")
      ->check(CLI::IsMember({"x", "y", "z"}));
  command->add_option("-o,--output", arguments->folder, "Folder for results [out, next to the document]");
  command->add_flag("--json", arguments->json, "Print one JSON object (SI units) and nothing else");
  command->add_flag("--vtu", arguments->vtu,
                    "Also write a series of .vtu files for ParaView, and a .pvd that lists them");
  command->add_option("--picture", arguments->picture, "Format of the chart, svg or png [svg]")
      ->check(CLI::IsMember({"svg", "png"}));
  add_solver_options(*command, arguments->command.options);
  add_run_options(*command, arguments->run);
  command->footer(
      std::string(
          "Writes the path as a table (.csv), a chart of the load factor over a displacement, and .json.\n\nExample:\n"
          "  lissom path arch.lissom --to 2 --steps 40 --follow arc_length --watch arch:0.5 --axis z\n\n") +
      exit_codes_text());
  command->callback(
      [command, arguments, &chosen] { chosen = [command, arguments] { return follow(*command, *arguments); }; });
}

}  // namespace lissom::cli
