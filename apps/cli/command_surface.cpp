// lissom surface FILE

#include "lissom/session/command_surface.h"

#include <fmt/format.h>

#include "apps/cli/arguments.h"
#include "apps/cli/command.h"
#include "apps/cli/terminal.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string file, unit, size, output;
  bool fill_holes = false, keep_largest = false, refuse_crossings = false, json = false;
};

/// Lengths with their units; one of the two may be given.
Result<SurfaceScale> scale_of(const Arguments& arguments) {
  SurfaceScale scale;
  if (!arguments.unit.empty()) {
    const Result<double> unit = length_of("1 " + arguments.unit, "--unit");
    if (!unit) return unit.error();
    scale.unit = unit.value();
  }
  if (!arguments.size.empty()) {
    const Result<double> size = length_of(arguments.size, "--size");
    if (!size) return size.error();
    scale.size = size.value();
  }
  return scale;
}

std::string facts_text(const BroughtSurface& brought) {
  const SurfaceFacts& facts = brought.facts;
  std::string text =
      fmt::format("{} with {} vertices and {} triangles, {} and {} after mending\n", brought.format, brought.points,
                  brought.faces, brought.surface.vertices.size(), brought.surface.triangles.size());
  text += fmt::format("size {}, area {:.4g} cm^2, genus {}\n", size_in_millimetres(facts.high - facts.low),
                      1e4 * facts.area, facts.genus);
  text += facts.loops == 0 ? fmt::format("closed, volume {:.4g} cm^3\n", 1e6 * facts.volume)
                           : fmt::format("open, {} {}, the longest {:.4g} mm\n", facts.loops,
                                         facts.loops == 1 ? "boundary" : "boundaries", 1000 * facts.longest_loop);
  if (!brought.surface.darkness.empty()) text += "painted: colours are kept as darkness\n";
  for (const SurfaceNote& note : brought.notes) {
    text += (note.outcome == SurfaceNote::Outcome::kMended ? "mended: " : "noted: ") + note.text() + "\n";
  }
  if (brought.notes.empty()) text += "nothing to mend\n";
  return text;
}

int bring(const Arguments& arguments) {
  const Result<SurfaceScale> scale = scale_of(arguments);
  if (!scale) return report(scale.error());
  SurfaceCommand command{.file = arguments.file, .scale = scale.value(), .repair = {}, .output = arguments.output};
  using Options = SurfaceRepairOptions;
  if (arguments.fill_holes) command.repair.holes = Options::Holes::kFill;
  if (arguments.keep_largest) command.repair.pieces = Options::Pieces::kKeepLargest;
  if (arguments.refuse_crossings) command.repair.crossings = Options::Crossings::kRefuse;
  const Result<SurfaceReport> done = surface_command(command);
  if (!done) return report(done.error(), arguments.file);
  if (arguments.json) {
    print(done.value().summary + "\n");
    return kDone;
  }
  print(facts_text(done.value().brought));
  for (const auto& file : done.value().files) print("wrote " + file.string() + "\n");
  return kDone;
}

}  // namespace

void add_surface(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("surface", "Read a surface mesh, name its defects and mend them");
  command->add_option("file", arguments->file, "Surface: .obj, .ply, .stl or .off")->required();
  command->add_option("--unit", arguments->unit, "Unit of its coordinates, such as mm, cm, m or in");
  command->add_option("--size", arguments->size, "Instead: its largest extent along an axis, such as \"230 mm\"");
  command->add_option("-o,--out", arguments->output, "Write the mended surface, in mm: .ply or .obj [nothing]");
  command->add_flag("--fill-holes", arguments->fill_holes, "Close holes smaller than 5 % of the surface");
  command->add_flag("--keep-largest", arguments->keep_largest, "Of several pieces keep the largest");
  command->add_flag("--refuse-crossings", arguments->refuse_crossings, "Refuse surfaces that cross themselves");
  command->add_flag("--json", arguments->json, "Print one JSON object (SI units) and nothing else");
  command->footer(
      "What can be mended without changing the shape is mended and said; the rest is refused with its place. Places\n"
      "have the numbers of the file, counted from 0. Colours of vertices become darkness, for patterns.\n\n"
      "Example:\n  lissom surface hat.obj --size \"230 mm\" --out hat-mended.ply");
  command->callback([arguments, &chosen] { chosen = [arguments] { return bring(*arguments); }; });
}

}  // namespace lissom::cli
