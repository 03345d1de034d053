#include "scenes/design_texts.h"

#include <design_texts.h>

namespace lissom {

std::span<const DesignText> design_texts() { return kDesignTexts; }

}  // namespace lissom
