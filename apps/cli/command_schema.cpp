// lissom schema

#include "apps/cli/command.h"
#include "apps/cli/terminal.h"
#include "lissom/model/document.h"

namespace lissom::cli {

void add_schema(CLI::App& app, Runner& chosen) {
  CLI::App* command = app.add_subcommand("schema", "Print the JSON Schema of documents");
  command->footer("Editors complete and check documents with it.\n\nExample:\n  lissom schema > lissom.schema.json");
  command->callback([&chosen] {
    chosen = [] {
      print(document_schema());
      return static_cast<int>(kDone);
    };
  });
}

}  // namespace lissom::cli
