// lissom: design of flexible structures, on the command line. Arguments and printing only; the work is in lissom/session.

#include <cstdio>

#include "apps/cli/command.h"

namespace lissom::cli {
namespace {

/// One entry per command, in the order of the help.
constexpr AddCommand kCommands[] = {add_solve,  add_path,    add_modes,  add_dynamics, add_draw,
                                    add_verify, add_convert, add_schema, add_scenes};

int run(int argc, char** argv) {
  CLI::App app{"lissom: predicts the shape of flexible structures made of rods.", "lissom"};
  app.set_version_flag("--version", std::string("lissom ") + LISSOM_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  Runner chosen;
  for (const AddCommand add : kCommands) add(app, chosen);
  app.footer(std::string("`lissom COMMAND --help` explains a command and gives an example.\n\n") + exit_codes_text());
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kUsage;
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
