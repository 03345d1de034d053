#pragma once
/// What every command of the tool has: arguments to declare and something to run.

#include <CLI/CLI.hpp>
#include <functional>

namespace lissom::cli {

/// Runs the command that was typed and returns the exit code.
using Runner = std::function<int()>;

/// Declares a command and its arguments; when it is typed, `chosen` becomes what runs it.
using AddCommand = void (*)(CLI::App& app, Runner& chosen);

void add_solve(CLI::App& app, Runner& chosen);
void add_path(CLI::App& app, Runner& chosen);
void add_modes(CLI::App& app, Runner& chosen);
void add_branches(CLI::App& app, Runner& chosen);
void add_dynamics(CLI::App& app, Runner& chosen);
void add_optimize(CLI::App& app, Runner& chosen);
void add_design(CLI::App& app, Runner& chosen);
void add_draw(CLI::App& app, Runner& chosen);
void add_print(CLI::App& app, Runner& chosen);
void add_verify(CLI::App& app, Runner& chosen);
void add_calibrate(CLI::App& app, Runner& chosen);
void add_fit_fabric(CLI::App& app, Runner& chosen);
void add_convert(CLI::App& app, Runner& chosen);
void add_surface(CLI::App& app, Runner& chosen);
void add_schema(CLI::App& app, Runner& chosen);
void add_scenes(CLI::App& app, Runner& chosen);
void add_examples(CLI::App& app, Runner& chosen);
void add_studio(CLI::App& app, Runner& chosen);

/// Exit codes besides those of verdicts.
enum ExitCode { kDone = 0, kFailed = 1, kUsage = 2, kBadInput = 3, kFileTrouble = 4 };

/// "Exit codes: ...", for the help.
const char* exit_codes_text();

}  // namespace lissom::cli
