#pragma once
/// The documents of scenes/data/fabric, as they were when the program was built.

#include <span>

#include "lissom/model/design_text.h"

namespace lissom {

/// Sorted by name, the butterfly, the mask and the car first.
std::span<const DesignText> design_texts();

}  // namespace lissom
