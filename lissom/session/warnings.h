#pragma once
/// What a designer should know about a shape of rods on fabric before making it, each with a remedy in words.

#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/mechanics/state.h"
#include "lissom/mechanics/system.h"

namespace lissom {

struct WarningLimits {
  double stretch = 1.02;                      ///< below this the fabric is nearly slack [thesis chapter 6]
  double wanted_stretch = 1.05;               ///< what the remedy against slack aims at
  double compression = 2e-3;                  ///< of rods, strain; thin rods in fabric bend long before
  double turn = std::numbers::pi / 9;         ///< rad, 20 degrees: bending is some percent off [mathematics 1.3]
  double strong_turn = std::numbers::pi / 6;  ///< rad, 30 degrees
  double diameter = 0.5e-3;                   ///< m, smallest that printers make [thesis chapter 6]
  double pre_stretch = 1.6;                   ///< what fabrics usually bear [thesis chapter 6]
};

/// Where the remedy against slack fabric goes on with an estimate; solving says more (solved_remedy.h).
inline constexpr std::string_view kEstimatedRemedy = "; for about the same shape ";

struct Warning {
  std::string what;        ///< "slack fabric", "compressed rod", "turning angle", "thin rod",
                           ///< "inverted tetrahedra"
  std::string where;       ///< rod or membrane by name, with the place in mm where it helps
  double value = 0;        ///< SI, of what is named
  std::string unit;        ///< of the value; "1" for strains and stretches
  std::string remedy;      ///< a sentence
  int node = -1;           ///< of the structure, where it is worst
  std::string ghost = {};  ///< the rod that the remedy would make a ghost; empty: it would not
};

/// Of a structure with membranes or solids, most pressing first within each kind, at most one per membrane or rod and kind
/// (of thin rods: one); nothing without either. `stretch_share`: part of the pre-stretch that is there.
std::vector<Warning> warnings(const System& system, const State& state, double stretch_share,
                              const WarningLimits& limits = {});

}  // namespace lissom
