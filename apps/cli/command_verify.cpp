// lissom verify FILE...

#include <cstdio>
#include <fmt/format.h>

#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/terminal.h"
#include "lissom/session/quantities.h"
#include "lissom/session/verify.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::vector<std::string> files;
  bool quantities = false;
  RunOptions run;
};

int list_quantities() {
  for (const QuantityInfo& info : quantities()) {
    print(fmt::format("{:<22}{:<7}{}{}\n", info.name, info.unit, info.description,
                      info.rate != nullptr ? "; also as a rate" : ""));
  }
  print("\nRates end in _rate and are derivatives by the load factor. docs/guide/quantities.md defines everything.\n");
  return kDone;
}

int verify_files(const Arguments& arguments) {
  if (arguments.quantities) return list_quantities();
  if (arguments.files.empty()) {
    std::fputs("lissom: verify needs at least one document (`lissom verify --help` explains)\n", stderr);
    return kUsage;
  }
  Run run(arguments.run);
  int passed = 0, failed = 0;
  for (const std::string& file : arguments.files) {
    const Result<Document> document = read_input(file);
    if (!document) {
      run.clear_line();
      print("FAIL  " + document.error().text() + "\n");
      ++failed;
      continue;
    }
    for (const Check& check : verify(document.value().model, run.context())) {
      ++(check.passed ? passed : failed);
      run.clear_line();
      print(check_line(check, document.value().name) + "\n");
      std::fflush(stdout);
    }
  }
  run.clear_line();
  print(fmt::format("{} passed, {} failed\n", passed, failed));
  return failed == 0 ? kDone : kFailed;
}

}  // namespace

void add_verify(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("verify", "Check the numbers that documents expect");
  command->add_option("files", arguments->files, "Documents with \"expect\" entries, or scene:NAME");
  command->add_flag("--quantities", arguments->quantities, "List what can be expected, with units");
  add_run_options(*command, arguments->run);
  command->footer(
      "Prints one line per number, PASS or FAIL, then `N passed, N failed`. The exit code is 0 when all pass. What "
      "the\n"
      "quantities mean is in docs/guide/quantities.md.\n\nExample:\n  lissom verify bridge.lissom");
  command->callback([arguments, &chosen] { chosen = [arguments] { return verify_files(*arguments); }; });
}

}  // namespace lissom::cli
