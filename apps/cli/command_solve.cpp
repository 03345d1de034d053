// lissom solve FILE

#include "lissom/session/command_solve.h"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>

#include "apps/cli/arguments.h"
#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/solver_arguments.h"
#include "apps/cli/terminal.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string file, folder, resume, picture;
  SolveCommand command;
  bool json = false, vtu = false;
  RunOptions run;
};

void line(std::string_view name, const std::string& text) { print(fmt::format("  {:<26}{}\n", name, text)); }

std::string energy_shares(const Equilibrium& e) {
  std::string text;
  for (const EnergyShare& share : e.energy_shares) {
    if (share.energy == 0) continue;
    std::string term = share.term;
    std::replace(term.begin(), term.end(), '_', ' ');
    text += fmt::format("{}{} {:.4g} mJ", text.empty() ? "" : ", ", term, 1e3 * share.energy);
  }
  return text;
}

std::string worst_text(const WorstElement& w) {
  const bool angle = w.unit == "rad";
  const double scale = angle ? 180 / std::numbers::pi : w.unit.empty() ? 100 : 1;
  const std::string unit = angle ? "degrees" : w.unit.empty() ? "%" : w.unit;
  if (w.triangle >= 0) {
    return fmt::format("{:.4g} at {}triangle {}", w.value, w.membrane.empty() ? "" : "membrane " + w.membrane + ", ",
                       w.triangle);
  }
  return fmt::format("{:.3g} {} at {}{}", scale * w.value, unit, w.rod.empty() ? "" : "rod " + w.rod + ", ",
                     w.edge >= 0 ? fmt::format("edge {}", w.edge) : fmt::format("node {}", w.node));
}

void print_totals(const Totals& t) {
  const Vec3 box = 1e3 * (t.high - t.low);
  line("height",
       fmt::format("{:.5g} mm, in a box of {:.5g} x {:.5g} x {:.5g} mm", 1e3 * t.height, box.x(), box.y(), box.z()));
  line("fabric", fmt::format("{:.5g} cm², smallest stretch {:.4g}, slack {:.3g} %", 1e4 * t.area, t.smallest_stretch,
                             t.area > 0 ? 100 * t.slack_area / t.area : 0));
}

constexpr size_t kWarningsShown = 8;

void print_warnings(const std::vector<Warning>& warnings) {
  for (size_t i = 0; i < std::min(warnings.size(), kWarningsShown); ++i) {
    line("warning", fmt::format("{}, {}: {}", warnings[i].what, warnings[i].where, warnings[i].remedy));
  }
  if (warnings.size() > kWarningsShown) {
    line("warning", fmt::format("{} more are in the result file", warnings.size() - kWarningsShown));
  }
}

void print_pose(const SolvedPose& pose) {
  const Equilibrium& e = pose.equilibrium;
  print(fmt::format("{}: {}\n", pose.pose, e.message));
  line("unbalanced force", fmt::format("{:.3g} N, wanted {:.3g} N", e.residual, e.tolerance));
  line("work",
       fmt::format("{} iterations, {} factorizations, {} unknowns", e.iterations, e.factorizations, pose.unknowns));
  if (e.verdict != Verdict::kBadStart) {
    line("largest move", fmt::format("{:.5g} mm", 1e3 * pose.largest_displacement));
    line("largest stress", fmt::format("{:.4g} MPa", 1e-6 * pose.largest_stress));
    line("energy", fmt::format("{:.5g} mJ: {}", 1e3 * e.energy, energy_shares(e)));
  }
  if (pose.totals) print_totals(*pose.totals);
  for (const WorstElement& w : e.worst) line(w.triangle >= 0 ? w.what : "largest " + w.what, worst_text(w));
  for (const std::string& motion : pose.removed_motions) line("taken out", motion);
  for (const std::string& note : pose.notes) line("note", note);
  print_warnings(pose.warnings);
  for (const std::filesystem::path& file : pose.files) line("wrote", file.string());
}

int solve_file(Arguments& arguments) {
  SolveCommand& command = arguments.command;
  if (!arguments.resume.empty()) {
    Result<SavedResult> saved = read_saved(arguments.resume);
    if (!saved) return report(saved.error());
    command.resume = std::move(saved).value();
  }
  const Result<Document> document = read_input(arguments.file);
  if (!document) return report(document.error(), arguments.file);
  command.folder =
      arguments.folder.empty() ? document.value().default_output() : std::filesystem::path(arguments.folder);
  command.vtu = arguments.vtu ? ParaView::kYes : ParaView::kNo;
  if (!arguments.picture.empty()) command.picture = format_named(arguments.picture);
  Run run(arguments.run);
  const Result<std::vector<SolvedPose>> results = solve_command(document.value(), command, run.context());
  run.clear_line();
  if (!results) return report(results.error(), arguments.file);
  int code = kDone;
  std::vector<std::string> summaries;
  for (const SolvedPose& pose : results.value()) {
    if (code == kDone) code = verdict_info(pose.equilibrium.verdict).exit_code;
    summaries.push_back(pose.summary);
    if (!arguments.json) print_pose(pose);
  }
  if (arguments.json) print_json_list("poses", summaries);
  return code;
}

}  // namespace

void add_solve(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("solve", "Find the shape in which a structure comes to rest");
  command->add_option("file", arguments->file, kInputHelp)->required();
  command->add_option("--pose", arguments->command.poses, "Pose to solve; may be repeated [all]")
      ->allow_extra_args(false);
  command->add_option("-o,--output", arguments->folder, "Folder for results [out, next to the document]");
  command->add_flag("--json", arguments->json, "Print one JSON object (SI units) and nothing else");
  command->add_option("--load-factor", arguments->command.load_factor, "Multiplies loads and prescribed motions [1]");
  command->add_option("--resume", arguments->resume, "Go on from the shape in this result file");
  command->add_flag("--vtu", arguments->vtu, "Also write a .vtu file for ParaView");
  command->add_option("--picture", arguments->picture, "Also draw the shape, as svg or png")
      ->check(CLI::IsMember({"svg", "png"}));
  command->add_option("--field", arguments->command.field,
                      "Field that colours the picture, such as curvature [stress]");
  add_solver_options(*command, arguments->command.options);
  add_run_options(*command, arguments->run);
  command->footer(
      std::string(
          "Writes one result file per pose, DOCUMENT-POSE.json. Ctrl-C once stops and keeps the best shape so far;\n"
          "--resume goes on from there.\n\nExample:\n  lissom solve bridge.lissom --pose loaded --picture svg\n\n") +
      exit_codes_text());
  command->callback([arguments, &chosen] { chosen = [arguments] { return solve_file(*arguments); }; });
}

}  // namespace lissom::cli
