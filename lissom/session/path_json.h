#pragma once
/// Paths as JSON (SI units).

#include <string>

#include "lissom/session/command_path.h"

namespace lissom {

/// The file of a path: its points with their numbers, and the critical points with their unknowns and modes.
std::string path_text(const Document& document, const FollowedPose& followed);

/// One line that sums it up, as `lissom path --json` prints it.
std::string path_summary(const FollowedPose& followed);

}  // namespace lissom
