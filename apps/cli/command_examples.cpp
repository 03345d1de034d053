// lissom examples [NAME]

#include <fmt/format.h>

#include "apps/cli/command.h"
#include "apps/cli/terminal.h"
#include "lissom/geometry/surface_file.h"
#include "lissom/model/document.h"
#include "lissom/model/rod_mesh_document.h"
#include "lissom/session/output.h"
#include "scenes/rod_mesh_examples.h"
#include "scenes/sheet_brief.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string name, folder = "examples";
};

constexpr std::string_view kSheet = "sheet",
                           kSheetText = "a sheet of hexagons that bends and stretches as other sheets do";

void list_examples() {
  print(fmt::format("{:<12}{}\n", kSheet, kSheetText));
  for (const scene_models::RodMeshExampleInfo& info : scene_models::rod_mesh_examples()) {
    print(fmt::format("{:<12}{}\n", info.name, info.description));
  }
}

Status write_example(const scene_models::RodMeshExampleInfo& info, Output& output) {
  const Result<scene_models::RodMeshExample> made = info.make();
  if (!made) return made.error();
  const RodMeshProject& project = made.value().project;
  if (Status s = output.write(project.surface.file, write_surface_ply(made.value().surface)); !s) return s;
  return output.write(std::string(info.name) + ".lissom", write_project(project));
}

int examples(const Arguments& arguments) {
  if (arguments.name.empty()) {
    list_examples();
    return kDone;
  }
  Output output(arguments.folder);
  bool found = false;
  if (arguments.name == kSheet || arguments.name == "all") {
    found = true;
    const std::string text = write_document(scene_models::sheet_design(), NetworkText::kRods);
    if (const Status s = output.write(std::string(kSheet) + ".lissom", text); !s)
      return report(s.error(), arguments.name);
  }
  for (const scene_models::RodMeshExampleInfo& info : scene_models::rod_mesh_examples()) {
    if (arguments.name != info.name && arguments.name != "all") continue;
    found = true;
    if (const Status s = write_example(info, output); !s) return report(s.error(), arguments.name);
  }
  if (!found) {
    return report(Error{ErrorCode::kUnknown,
                        {},
                        fmt::format("there is no example \"{}\"", arguments.name),
                        "`lissom examples` lists them"},
                  arguments.name);
  }
  for (const std::filesystem::path& file : output.take_written()) print("wrote " + file.string() + "\n");
  return kDone;
}

}  // namespace

void add_examples(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("examples", "Projects to start from, with their surfaces");
  command->add_option("name", arguments->name, "Which one, or all [list them]");
  command->add_option("-o,--output", arguments->folder, "Folder for the files [examples]");
  command->footer(
      "Example:\n  lissom examples hat && lissom design examples/hat.lissom\n\n"
      "Exit codes: 0 done; 2 wrong arguments; 3 no such example; 4 a file cannot be written.");
  command->callback([arguments, &chosen] { chosen = [arguments] { return examples(*arguments); }; });
}

}  // namespace lissom::cli
