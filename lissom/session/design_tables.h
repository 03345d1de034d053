#pragma once
/// What came of a project, as tables of its report and as JSON.

#include <string>
#include <vector>

#include "lissom/session/command_design.h"

namespace lissom {

/// Sizes of the mesh, poses with what they miss, remarks.
std::vector<DesignReport::Table> project_tables(const DesignedProject& done);

/// Objects, strains of the poses, what speaks against printing.
std::vector<DesignReport::Table> print_tables(const PrintOutcome& print);

/// JSON, one line, SI units.
std::string summary_of(const std::string& name, const DesignedProject& done);

}  // namespace lissom
