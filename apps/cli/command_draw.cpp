// lissom draw FILE

#include "lissom/session/command_draw.h"

#include <fmt/format.h>
#include <utility>
#include <vector>

#include "apps/cli/arguments.h"
#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/terminal.h"
#include "lissom/session/fields.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::vector<std::string> files;
  std::string output, pose, shown = "both", field, fabric_field, camera = "iso", size = "1600x1200", theme = "light",
                            title;
  bool fields = false, tension = false, shadow = false;
};

int list_fields() {
  for (const FieldInfo& info : field_list()) {
    print(fmt::format("{:<18}{:<8}{}\n", info.name, info.display_unit, info.description));
  }
  return kDone;
}

/// "1600x1200".
Status read_size(const std::string& text, PictureOptions& picture) {
  int width = 0, height = 0, used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used) == 2 && used == static_cast<int>(text.size())) {
    picture.width = width;
    picture.height = height;
    return {};
  }
  return Error{ErrorCode::kSyntax, "--size", "\"" + text + "\" is not a size",
               "write width x height in pixels, such as 1600x1200"};
}

int draw_file(const Arguments& arguments) {
  if (arguments.fields) return list_fields();
  if (arguments.files.empty()) {
    std::fputs("lissom: draw needs a document or a result (`lissom draw --help` explains)\n", stderr);
    return kUsage;
  }
  std::vector<Drawable> drawables;
  for (const std::string& file : arguments.files) {
    Result<Drawable> drawable = read_drawable(file, arguments.pose);
    if (!drawable) return report(drawable.error(), file);
    drawables.push_back(std::move(drawable).value());
  }
  DrawCommand command;
  command.shown = arguments.shown == "rest"       ? Shown::kRest
                  : arguments.shown == "deformed" ? Shown::kDeformed
                                                  : Shown::kBoth;
  command.picture.view = camera_named(arguments.camera);
  command.picture.field = arguments.field;
  command.picture.membrane_field = arguments.fabric_field;
  command.picture.shadow = arguments.shadow ? Visibility::kShown : Visibility::kHidden;
  command.picture.tension = arguments.tension ? Visibility::kShown : Visibility::kHidden;
  command.picture.title = arguments.title;
  command.picture.theme = arguments.theme == "dark" ? Theme::kDark : Theme::kLight;
  if (const Status s = read_size(arguments.size, command.picture); !s) {
    report(s.error());
    return kUsage;
  }
  const Drawable& first = drawables.front();
  command.file = !arguments.output.empty() ? std::filesystem::path(arguments.output)
                 : first.solved            ? std::filesystem::path(arguments.files.front()).replace_extension(".svg")
                                : first.document.default_output() / (file_name_part(first.document.name) + ".svg");
  const Status drawn = drawables.size() > 1 ? draw_strip_command(drawables, command) : draw_command(first, command);
  if (!drawn) return report(drawn.error());
  print("wrote " + command.file.string() + "\n");
  return kDone;
}

}  // namespace

void add_draw(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("draw", "Draw a structure, or a shape that was found");
  command->add_option("files", arguments->files,
                      "Documents, scene:NAME, or results of `lissom solve`; several are drawn side by side");
  command->add_option("-o,--output", arguments->output, "Picture, .svg or .png [.svg, next to a result, or in out]");
  command->add_option("--pose", arguments->pose, "Show the supports and forces of this pose (of a document)");
  command->add_option("--state", arguments->shown, "rest, deformed or both (of a result) [both]")
      ->check(CLI::IsMember({"rest", "deformed", "both"}));
  command->add_option("--field", arguments->field, "Colour by this, such as curvature [plain]");
  command->add_option("--fabric-field", arguments->fabric_field,
                      "Colour the fabric by this, such as \"smallest stretch\" [as --field]");
  command->add_flag("--tension", arguments->tension, "Show which way the fabric pulls most");
  command->add_flag("--fields", arguments->fields, "List the fields, with units");
  command->add_flag("--shadow", arguments->shadow, "Cast a shadow on the ground");
  command->add_option("--camera", arguments->camera, "iso, top, front or right [iso]")
      ->check(CLI::IsMember({"iso", "top", "front", "right"}));
  command->add_option("--size", arguments->size,
                      "Width x height in pixels, of several shapes only the width counts [1600x1200]");
  command->add_option("--theme", arguments->theme, "light or dark [light]")->check(CLI::IsMember({"light", "dark"}));
  command->add_option("--title", arguments->title, "Title [that of the document]");
  command->footer(
      "Needs no display.\n\nExample:\n  lissom draw out/bridge-loaded.json --field stress --camera front -o "
      "bridge.png");
  command->callback([arguments, &chosen] { chosen = [arguments] { return draw_file(*arguments); }; });
}

}  // namespace lissom::cli
