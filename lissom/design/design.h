#pragma once
/// One design: a description and what it was discretised to. What a design space makes of parameters.

#include "lissom/mechanics/system.h"
#include "lissom/model/model.h"

namespace lissom {

struct Design {
  Model model;
  System system;
};

}  // namespace lissom
