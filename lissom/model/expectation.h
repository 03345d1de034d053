#pragma once
/// A number that a document claims, with its tolerance and source: what `lissom verify` checks.

#include <optional>
#include <string>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/model/selector.h"

namespace lissom {

/// `quantity` names an entry of the list in session/quantities.cpp; which of the other fields it reads is stated there.
struct Expectation {
  std::string label;  ///< free text, printed
  std::string quantity;
  std::vector<std::string> poses;  ///< one value per pose; empty: all poses of the document in order
  Selector at;                     ///< where
  std::optional<Selector> to;      ///< second place, for distances and differences
  std::optional<Vec3> axis;        ///< direction, unit
  std::string rod;                 ///< for rod quantities
  std::string membrane;            ///< for quantities of one membrane
  std::string fabric_test;         ///< for moduli fitted to it
  std::string parameter;           ///< of the design, by its name; empty: the only one
  double fraction = -1;            ///< place along the rod, of its rest length
  int mode = -1;                   ///< index of a mode, 0 = lowest
  std::string mode_kind;           ///< "bending", "axial", "torsional": which modes are counted
  std::string combine;             ///< what is made of several measurements: "difference", "ratio", "order", "limit"
  std::vector<int> edges;          ///< resolutions: numbers of edges of `rod`, else of the first rod
  double scale = 1;                ///< the measured value is divided by this (SI) before it is compared: L, B/L^2, ...
  double offset = 0;               ///< and this (SI) is subtracted first
  std::vector<double> value;       ///< SI after scaling; one per pose, or one for all
  std::string unit;                ///< for printing
  double tolerance_relative = 0;
  double tolerance_absolute = 0;  ///< in the unit of `value`
  std::string source;
};

}  // namespace lissom
