// lissom dynamics FILE

#include "lissom/session/command_dynamics.h"

#include <fmt/format.h>

#include "apps/cli/arguments.h"
#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/terminal.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string file, folder, picture = "svg", axis = "z", camera = "iso";
  std::vector<double> point;  // mm
  DynamicsCommand command;
  bool json = false, vtu = false;
  RunOptions run;
};

void print_motion(const PlayedMotion& played) {
  const MotionResult& result = played.result;
  print(fmt::format("{}: {}\n", played.motion, result.message));
  print(fmt::format("  {:.6g} s in {} steps, {} repeated smaller, {} iterations\n", result.last_time, result.steps,
                    result.rejected_steps, result.iterations));
  print(fmt::format("  energy balance off by {:.3g} %\n", 100 * result.balance_error()));
  for (const std::filesystem::path& file : played.files) {
    if (file.extension() != ".vtu") print("  wrote " + file.string() + "\n");
  }
}

int play(Arguments& arguments) {
  const Result<Document> document = read_input(arguments.file);
  if (!document) return report(document.error(), arguments.file);
  DynamicsCommand& command = arguments.command;
  command.folder =
      arguments.folder.empty() ? document.value().default_output() : std::filesystem::path(arguments.folder);
  command.vtu = arguments.vtu ? ParaView::kYes : ParaView::kNo;
  command.picture = format_named(arguments.picture);
  command.watch_axis = axis_named(arguments.axis).value_or(Vec3::UnitZ());
  if (!arguments.point.empty()) command.watch_point = 1e-3 * Vec3(arguments.point.data());
  command.view = camera_named(arguments.camera);
  Run run(arguments.run);
  const Result<std::vector<PlayedMotion>> results = dynamics_command(document.value(), command, run.context());
  run.clear_line();
  if (!results) return report(results.error(), arguments.file);
  int code = kDone;
  std::vector<std::string> summaries;
  for (const PlayedMotion& played : results.value()) {
    if (code == kDone) code = motion_verdict_info(played.result.verdict).exit_code;
    summaries.push_back(played.summary);
    if (!arguments.json) print_motion(played);
  }
  if (arguments.json) print_json_list("motions", summaries);
  return code;
}

}  // namespace

void add_dynamics(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("dynamics", "Play a motion in time");
  command->add_option("file", arguments->file, kInputHelp)->required();
  command->add_option("--motion", arguments->command.motions, "Motion to play; may be repeated [all]")
      ->allow_extra_args(false);
  command
      ->add_option("--watch", arguments->command.watches,
                   "Record the turning of this place: a set or a rod; may be repeated [none]")
      ->allow_extra_args(false);
  command->add_option("--watch-axis", arguments->axis, "Axis of the turning, x, y or z [z]")
      ->check(CLI::IsMember({"x", "y", "z"}));
  command
      ->add_option("--watch-point", arguments->point,
                   "Point on that axis, x y z in mm [the middle of the place as drawn]")
      ->expected(3);
  command->add_option("--panels", arguments->command.panels, "Pictures in the strip; 0: no strip [6]")
      ->check(CLI::Range(0, 64));
  command->add_option("--field", arguments->command.field, "Field that colours them, such as curvature [plain]");
  command->add_option("--camera", arguments->camera, "Where the strip is seen from: iso, top, front or right [iso]")
      ->check(CLI::IsMember({"iso", "top", "front", "right"}));
  command->add_option("--width", arguments->command.strip_width, "Width of the strip in pixels [1440]")
      ->check(CLI::Range(200, 20000));
  command->add_option("-o,--output", arguments->folder, "Folder for results [out, next to the document]");
  command->add_flag("--json", arguments->json, "Print one JSON object (SI units) and nothing else");
  command->add_flag("--vtu", arguments->vtu,
                    "Also write a series of .vtu files for ParaView, and a .pvd that lists them");
  command->add_option("--picture", arguments->picture, "Format of pictures and charts, svg or png [svg]")
      ->check(CLI::IsMember({"svg", "png"}));
  add_run_options(*command, arguments->run);
  command->footer(std::string("Writes energies and momenta over time (.csv, .json), charts of them, and a strip of "
                              "pictures. Ctrl-C stops\n"
                              "and keeps what has been played.\n\nExample:\n  lissom dynamics scene:windmill "
                              "--watch thin --watch thick --watch-axis x\n\n") +
                  exit_codes_text());
  command->callback([arguments, &chosen] { chosen = [arguments] { return play(*arguments); }; });
}

}  // namespace lissom::cli
