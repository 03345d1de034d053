// lissom fit-fabric FILE

#include "lissom/session/command_fit_fabric.h"

#include <fmt/format.h>

#include "apps/cli/arguments.h"
#include "apps/cli/command.h"
#include "apps/cli/input.h"
#include "apps/cli/terminal.h"

namespace lissom::cli {

namespace {

struct Arguments {
  std::string file;
  std::vector<std::string> tests;
  bool json = false;
};

int fit(const Arguments& arguments) {
  const Result<Document> document = read_input(arguments.file);
  if (!document) return report(document.error(), arguments.file);
  const Result<std::vector<FittedFabric>> fabrics = fit_fabric_command(document.value().model, arguments.tests);
  if (!fabrics) return report(fabrics.error(), arguments.file);
  std::vector<std::string> summaries;
  for (const FittedFabric& fabric : fabrics.value()) {
    summaries.push_back(fabric.summary);
    if (arguments.json) continue;
    const FabricFit& f = fabric.fit;
    print(
        fmt::format("{}: Y1 {:.6g} N/m along the warp, Y2 {:.6g} N/m along the weft, Poisson ratio {:.4g}, G {:.6g} "
                    "N/m\n  {} stretches fitted, root mean square deviation {:.2g}, largest {:.2g}\n  {}\n",
                    fabric.test, f.stiffness_1, f.stiffness_2, f.poisson_ratio, f.shear(), fabric.measured, f.rms,
                    f.largest, fabric.document));
  }
  if (arguments.json) print_json_list("fabrics", summaries);
  return kDone;
}

}  // namespace

void add_fit_fabric(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("fit-fabric", "Find the moduli of a fabric from pulled strips");
  command->add_option("file", arguments->file, kInputHelp)->required();
  command->add_option("--test", arguments->tests, "Fabric test to fit; may be repeated [all]")->allow_extra_args(false);
  command->add_flag("--json", arguments->json, "Print one JSON object (SI units) and nothing else");
  command->footer(
      std::string("The last line of each test is an entry for \"membrane_materials\". The Poisson ratio needs "
                  "stretches across\nsome strips, the two moduli strips in at least two directions.\n\n"
                  "Example:\n  lissom fit-fabric jersey.lissom\n\n") +
      exit_codes_text());
  command->callback([arguments, &chosen] { chosen = [arguments] { return fit(*arguments); }; });
}

}  // namespace lissom::cli
