// lissom scenes [NAME -o FILE]

#include <fmt/format.h>

#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/terminal.h"
#include "lissom/model/document.h"
#include "lissom/session/output.h"
#include "scenes/scenes.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string name, output;
};

int show_scenes(const Arguments& arguments) {
  if (arguments.name.empty()) {
    for (const Scene& scene : scenes()) print(fmt::format("{:<20}{}\n", scene.name, scene.description));
    return kDone;
  }
  const Result<Document> document = read_input("scene:" + arguments.name);
  if (!document) return report(document.error());
  const std::string text = write_document(document.value().model);
  if (arguments.output.empty()) {
    print(text);
    return kDone;
  }
  const std::filesystem::path file = arguments.output;
  Output output(file.parent_path());
  if (const Status s = output.write(file.filename(), text); !s) return report(s.error());
  print("wrote " + arguments.output + "\n");
  return kDone;
}

}  // namespace

void add_scenes(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("scenes", "List the example structures, or write one as a document");
  command->add_option("name", arguments->name, "Scene to write [list them all]");
  command->add_option("-o,--output", arguments->output, "Document to write [standard output]");
  command->footer(
      "Every command takes scene:NAME in place of a document.\n\nExample:\n  lissom scenes hexagon_sheet -o "
      "sheet.lissom");
  command->callback([arguments, &chosen] { chosen = [arguments] { return show_scenes(*arguments); }; });
}

}  // namespace lissom::cli
