// lissom: design of flexible structures, on the command line. Arguments and printing only; the work is in lissom/session.

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "apps/cli/command.h"
#include "apps/cli/terminal.h"
#include "lissom/core/nearest_name.h"

namespace lissom::cli {
namespace {

/// One entry per command, in the order of the help.
constexpr AddCommand kCommands[] = {add_studio,     add_solve,   add_path,      add_modes,  add_branches, add_dynamics,
                                    add_optimize,   add_design,  add_calibrate, add_draw,   add_print,    add_verify,
                                    add_fit_fabric, add_convert, add_surface,   add_schema, add_scenes,   add_examples};

/// A first word that is neither an option nor a command, with the command that may have been meant.
Status check_command(const CLI::App& app, int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "-";
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return {};
  return Error{ErrorCode::kUnknown, {}, "there is no command \"" + word + "\"", suggestion(word, names)};
}

int run(int argc, char** argv) {
  CLI::App app{"lissom: predicts the shape of flexible structures made of rods and membranes.", "lissom"};
  app.set_version_flag("--version", std::string("lissom ") + LISSOM_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  Runner chosen;
  for (const AddCommand add : kCommands) add(app, chosen);
  app.footer(std::string("`lissom COMMAND --help` explains a command and gives an example.\n\n") + exit_codes_text());
  if (const Status s = check_command(app, argc, argv); !s) {
    report(s.error());
    return kUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help and version
    const std::vector<CLI::App*> typed = app.get_subcommands();
    const std::string command = typed.empty() ? "lissom" : "lissom " + typed.front()->get_name();
    report({ErrorCode::kUnknown, {}, error.what(), "`" + command + " --help` explains"});
    return kUsage;
  }
  return chosen();
}

}  // namespace
}  // namespace lissom::cli

int main(int argc, char** argv) {
  const int code = lissom::cli::run(argc, argv);
  if (std::fflush(stdout) != 0) return lissom::cli::kFileTrouble;
  return code;
}
