#pragma once
/// Which material numbers of a structure are unknown and what was measured on it: what `lissom calibrate` works on. Files of
/// measurements are only named here; session/measurement_files.h reads them.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/model/brief.h"
#include "lissom/model/selector.h"

namespace lissom {

/// Pairs of a force and a length. Every pair is a step: the pose with its load set to what the pair prescribes.
struct ForceLengthBrief {
  enum class Prescribed {
    kForce,   ///< weights hang on the structure: forces of the pose are scaled to each force, lengths are measured
    kLength,  ///< a machine pulls: the support of `to` moves to each length, its reaction is measured
  };
  std::string pose;              ///< empty: the only one
  std::string file;              ///< CSV, relative to the folder of the document
  std::optional<Selector> from;  ///< one end of the length; absent: where `to` is drawn
  Selector to;                   ///< the other end
  std::optional<Vec3> axis;      ///< along which the length counts, with its sign; absent: distance between the ends
  Prescribed prescribed = Prescribed::kForce;
  double sigma = 0;  ///< standard deviation of what is measured, m or N, where the file has none; 0: not known
};

/// Places of nodes in some poses.
struct ShapesBrief {
  std::string pose;  ///< of rows that do not name one; empty: the only one
  std::string file;  ///< CSV, relative to the folder of the document
  double sigma = 0;  ///< standard deviation of a coordinate, m, where the file has none; 0: not known
};

using MeasurementBrief = std::variant<ForceLengthBrief, ShapesBrief>;

struct Calibration {
  std::vector<ParameterBrief> parameters;  ///< of the kinds of `may_be_calibrated`
  std::vector<MeasurementBrief> measurements;
  double confidence = 0.95;       ///< of intervals
  int iterations = 100;           ///< at most
  double solve_tolerance = 1e-9;  ///< of equilibria, largest unbalanced force over the loads
};

/// Numbers of the material, and natural shapes, which spoil what is said about the material when they are not known.
inline bool may_be_calibrated(const ParameterKindBrief& what) {
  return std::holds_alternative<ModulusBrief>(what) || std::holds_alternative<FabricBrief>(what) ||
         std::holds_alternative<NaturalBrief>(what);
}

}  // namespace lissom
