#pragma once
/// What `branches` tells machines.

#include <string>

#include "lissom/session/command_branches.h"

namespace lissom {

/// One line of JSON (SI units).
std::string branches_summary(const PoseBranches& found);

}  // namespace lissom
