#pragma once
/// Named fields of a state, for pictures and ParaView: the list is in fields.cpp.

#include <span>
#include <string>
#include <string_view>

#include "lissom/equilibrium/static_problem.h"
#include "lissom/model/model.h"
#include "lissom/view/rod_drawing.h"

namespace lissom {

/// What fields are computed from. `reaction` (N, N m per unknown, global axes) may be null: no reactions.
struct FieldSource {
  const Model& model;
  const System& system;
  const State& state;
  const VecX* reaction = nullptr;
  double stretch_share = 1;  ///< part of the pre-stretch of membranes that is there (stretch_share())
};

/// Structures without membranes have no fields of membranes, nor those that matter for membranes only.
enum class FieldNeeds { kNothing, kMembranes };

struct FieldInfo {
  std::string_view name;
  std::string_view unit, display_unit;
  double display_scale = 1;
  Field::Place place = Field::Place::kEdge;
  Field::Colors colors = Field::Colors::kSequential;
  std::string_view description;
  std::vector<double> (*values)(const FieldSource&);  ///< one per node, edge or triangle of the structure
  FieldNeeds needs = FieldNeeds::kNothing;
};

std::span<const FieldInfo> field_list();

/// The structure in this state with every field and, unless `pose` is null, with its supports and forces.
Result<Drawing> draw_state(const FieldSource& source, const Pose* pose);

/// What colours membranes in a picture whose rods have the colours of `field`: "smallest stretch" where there are
/// membranes that `field` has no values for, else nothing.
std::string field_of_membranes(const Drawing& drawing, const std::string& field);

/// The drawn shape without fields, for comparison.
Drawing draw_rest(const System& system);

}  // namespace lissom
