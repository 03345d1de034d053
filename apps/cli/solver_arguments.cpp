#include "apps/cli/solver_arguments.h"

#include <map>
#include <string>

namespace lissom::cli {

void add_solver_options(CLI::App& command, SolveOptions& options) {
  const auto choice = [&](const char* name, auto& value, const auto& names, const char* help) {
    std::string words;
    for (const auto& [word, meaning] : names) words += (words.empty() ? "{" : ",") + word;
    const CLI::Validator known(
        [names, words](std::string& text) -> std::string {
          const auto found = names.find(CLI::ignore_case(text));
          if (found == names.end()) return "\"" + text + "\" is not one of " + words + "}";
          text = std::to_string(static_cast<int>(found->second));
          return {};
        },
        words + "}");
    command.add_option(name, value, help)->transform(known)->type_name("TEXT")->group("Solver");
  };
  choice("--method", options.method,
         std::map<std::string, Method>{{"minimize", Method::kMinimize}, {"find_root", Method::kFindRoot}},
         "minimize the energy, or find_root of the forces, which may end in unstable shapes [minimize]");
  choice("--path", options.path,
         std::map<std::string, StepPath>{{"straight", StepPath::kStraight},
                                         {"second_order", StepPath::kSecondOrder},
                                         {"rotating", StepPath::kRotating},
                                         {"second_order_rotating", StepPath::kSecondOrderRotating}},
         "Path of a trial step [second_order_rotating]");
  choice(
      "--shift", options.shift,
      std::map<std::string, ShiftRule>{{"remembered", ShiftRule::kRemembered}, {"eigenvalue", ShiftRule::kEigenvalue}},
      "Where the shift of an indefinite matrix comes from [eigenvalue]");
  choice("--expansion", options.expansion,
         std::map<std::string, Expansion>{{"off", Expansion::kOff}, {"on", Expansion::kOn}},
         "Try longer steps while a shift is active [on]");
  choice("--frames", options.frames,
         std::map<std::string, Relaxation>{{"off", Relaxation::kOff}, {"on", Relaxation::kOn}},
         "Balance rolls and joint rotations inside each trial step [off]");
  choice("--rods", options.rods, std::map<std::string, Relaxation>{{"off", Relaxation::kOff}, {"on", Relaxation::kOn}},
         "Balance the rods of membranes inside each trial step [on]");
  choice("--reuse", options.reuse,
         std::map<std::string, FactorReuse>{{"off", FactorReuse::kOff}, {"on", FactorReuse::kOn}},
         "Solve steps with the factor of an earlier one where that is cheaper; of membranes [on]");
  choice("--at-saddle", options.at_saddle,
         std::map<std::string, AtSaddle>{{"escape", AtSaddle::kEscape}, {"stay", AtSaddle::kStay}},
         "Leave an unstable equilibrium, or stay there and report it [escape]");
  command.add_option("--tolerance", options.tolerance, "Largest unbalanced force, relative to the loads [1e-6]")
      ->group("Solver");
  command.add_option("--max-iterations", options.max_iterations, "Limit of iterations [500]")->group("Solver");
  command.add_option("--modes", options.modes, "How many of the lowest modes to report [3]")->group("Solver");
}

}  // namespace lissom::cli
