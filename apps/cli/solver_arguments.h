#pragma once
/// Solver options that several commands take.

#include <CLI/CLI.hpp>

#include "lissom/equilibrium/options.h"

namespace lissom::cli {

void add_solver_options(CLI::App& command, SolveOptions& options);

}  // namespace lissom::cli
