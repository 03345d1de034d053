#pragma once
/// Motions as JSON (SI units).

#include <string>

#include "lissom/session/command_dynamics.h"

namespace lissom {

/// The file of a motion: how it went, a row per record, and the last shape.
std::string dynamics_text(const Document& document, const MotionCase& motion, const PlayedMotion& played);

/// One line, as `lissom dynamics --json` prints it.
std::string dynamics_summary(const PlayedMotion& played);

}  // namespace lissom
