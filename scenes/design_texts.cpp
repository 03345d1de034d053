#include "scenes/design_texts.h"

#include "design_texts_data.h"

namespace lissom {

std::span<const DesignText> design_texts() { return kDesignTexts; }

}  // namespace lissom
