#pragma once
/// Modes as JSON (SI units).

#include <string>

#include "lissom/session/command_modes.h"

namespace lissom {

/// The file of a pose: stiffnesses, frequencies, shares and shapes.
std::string modes_text(const Document& document, const PoseModes& result);

/// One line without shapes, as `lissom modes --json` prints it.
std::string modes_summary(const PoseModes& result);

}  // namespace lissom
