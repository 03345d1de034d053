// lissom schema

#include "apps/cli/command.h"
#include "apps/cli/terminal.h"
#include "lissom/model/document.h"
#include "lissom/model/rod_mesh_document.h"

namespace lissom::cli {

void add_schema(CLI::App& app, Runner& chosen) {
  CLI::App* command = app.add_subcommand("schema", "Print the JSON Schema of documents, or of projects");
  auto of_projects = std::make_shared<bool>(false);
  command->add_flag("--project", *of_projects, "Of projects, which `lissom design` works on");
  command->footer("Editors complete and check documents with it.\n\nExample:\n  lissom schema > lissom.schema.json");
  command->callback([of_projects, &chosen] {
    chosen = [of_projects] {
      print(*of_projects ? project_schema() : document_schema());
      return static_cast<int>(kDone);
    };
  });
}

}  // namespace lissom::cli
