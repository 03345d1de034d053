// lissom convert INPUT OUTPUT

#include "lissom/session/command_convert.h"

#include <map>

#include "apps/cli/arguments.h"
#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/terminal.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string input, output, unit = "mm", material, fabric, radius = "1 mm", rods = "chains", field, obj = "lines";
  int edges = 4;
};

Result<NetworkOptions> network_options(const Arguments& arguments) {
  NetworkOptions options;
  const Result<double> scale = length_of("1 " + arguments.unit, "--unit");
  if (!scale) return scale.error();
  const Result<double> radius = length_of(arguments.radius, "--radius");
  if (!radius) return radius.error();
  options.scale = scale.value();
  options.material = arguments.material.empty() ? "GFRP" : arguments.material;
  options.section = {.r_n = {radius.value()}, .r_b = {radius.value()}};
  options.edges_per_segment = arguments.edges;
  options.rods = arguments.rods == "chains" ? NetworkRods::kChains : NetworkRods::kSegments;
  return options;
}

Result<Drawable> read_plan(const Arguments& arguments) {
  const Result<double> radius = length_of(arguments.radius, "--radius");
  if (!radius) return radius.error();
  DrawingOptions options;
  options.r_n = options.r_b = radius.value();
  if (!arguments.material.empty()) options.material = arguments.material;
  if (!arguments.fabric.empty()) options.fabric = arguments.fabric;
  std::vector<std::string> notes;
  Result<Document> document = import_plan(arguments.input, options, notes);
  if (!document) return document.error();
  for (const std::string& note : notes) print(note + "\n");
  return make_drawable(std::move(document).value(), {});
}

Result<Drawable> read_source(const Arguments& arguments) {
  if (is_plan_drawing(arguments.input)) return read_plan(arguments);
  if (std::filesystem::path(arguments.input).extension() != ".obj") return read_drawable(arguments.input, {});
  const Result<NetworkOptions> options = network_options(arguments);
  if (!options) return options.error();
  std::vector<std::string> notes;
  Result<Document> document = import_document(arguments.input, options.value(), notes);
  if (!document) return document.error();
  for (const std::string& note : notes) print(note + "\n");
  return make_drawable(std::move(document).value(), {});
}

int convert(const Arguments& arguments) {
  std::error_code none;
  if (std::filesystem::equivalent(arguments.input, arguments.output, none)) {
    return report({ErrorCode::kConflict, arguments.output, "the output is the input", "name another file"});
  }
  const Result<Drawable> drawable = read_source(arguments);
  if (!drawable) return report(drawable.error(), arguments.input);
  ConvertCommand command;
  command.obj = arguments.obj == "lines" ? ObjContent::kCentrelines : ObjContent::kSurfaces;
  command.field = arguments.field;
  command.file = arguments.output;
  if (const Status s = convert_command(drawable.value(), command); !s) return report(s.error());
  print("wrote " + arguments.output + "\n");
  return kDone;
}

}  // namespace

void add_convert(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("convert", "Turn documents, line networks and results into other files");
  command
      ->add_option("input", arguments->input,
                   "A document, scene:NAME, a result, a line network (.obj with l elements), or a drawing of a plan "
                   "(.svg, .dxf)")
      ->required();
  command
      ->add_option("output", arguments->output,
                   "File to write: .lissom, .obj, .vtu, .vtp, .ply; of a plan also .svg or .dxf")
      ->required();
  command->add_option("--unit", arguments->unit, "Unit of the coordinates of a line network [mm]");
  command->add_option("--material", arguments->material, "Material of its rods [GFRP; of a drawing PLA]");
  command->add_option("--fabric", arguments->fabric, "Fabric of a drawing [elastane-cotton knit]");
  command->add_option("--radius", arguments->radius,
                      "Radius of its rods, or of lines without width in a drawing, with unit [1 mm]");
  command->add_option("--edges", arguments->edges, "Edges per straight piece of it [4]")->check(CLI::Range(1, 10000));
  command
      ->add_option("--rods", arguments->rods,
                   "chains: lines that go on smoothly are one rod; segments: each piece is one [chains]")
      ->check(CLI::IsMember({"chains", "segments"}));
  command->add_option("--obj", arguments->obj, "What an .obj file gets: lines or surfaces [lines]")
      ->check(CLI::IsMember({"lines", "surfaces"}));
  command->add_option("--field", arguments->field, "Colours of a .ply file, such as stress [none]");
  command->footer(
      "Documents carry their units; .obj, .ply, .svg and .dxf files are in millimetres, .vtu and .vtp files in "
      "metres.\n"
      "In drawings the layers RODS and GHOST hold rods, FRAME and MARKS are left out; lines that meet share a "
      "point.\n\n"
      "Example:\n  lissom convert roof.obj roof.lissom --unit m --material GFRP --radius \"10 mm\"");
  command->callback([arguments, &chosen] { chosen = [arguments] { return convert(*arguments); }; });
}

}  // namespace lissom::cli
