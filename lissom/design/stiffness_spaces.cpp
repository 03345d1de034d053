#include "lissom/design/stiffness_spaces.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <utility>

#include "lissom/core/nearest_name.h"
#include "lissom/design/linear_columns.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

Status check_positive(const Vec2& range, const char* what) {
  if (range[0] > 0) return {};
  return Error{ErrorCode::kRange, "/parameters", fmt::format("{} may be {:g}", what, range[0]),
               "give a positive lower bound"};
}

const char* name_of(SheetProperty property) {
  switch (property) {
    case SheetProperty::kStiffness:
      return "stiffness";
    case SheetProperty::kStiffness1:
      return "stiffness along the warp";
    case SheetProperty::kStiffness2:
      return "stiffness across the warp";
    case SheetProperty::kPoissonRatio:
      return "Poisson's ratio";
    case SheetProperty::kThickness:
      return "thickness";
    case SheetProperty::kPreStretch:
      return "pre-stretch";
    case SheetProperty::kPreStretch1:
      return "pre-stretch along the warp";
    case SheetProperty::kPreStretch2:
      return "pre-stretch across the warp";
  }
  return "";
}

ParameterKind kind_of(SheetProperty property) {
  switch (property) {
    case SheetProperty::kStiffness:
    case SheetProperty::kStiffness1:
    case SheetProperty::kStiffness2:
      return ParameterKind::kSheetStiffness;
    case SheetProperty::kPoissonRatio:
      return ParameterKind::kPoissonRatio;
    case SheetProperty::kThickness:
      return ParameterKind::kThickness;
    default:
      return ParameterKind::kPreStretch;
  }
}

/// The first input of a property in a membrane, and the second where both axes go together, else -1.
std::pair<int, int> inputs_of(SheetProperty property, const RestInputs& inputs, int membrane) {
  switch (property) {
    case SheetProperty::kStiffness:
      return {inputs.sheet_stiffness(membrane, 0), inputs.sheet_stiffness(membrane, 1)};
    case SheetProperty::kStiffness1:
      return {inputs.sheet_stiffness(membrane, 0), -1};
    case SheetProperty::kStiffness2:
      return {inputs.sheet_stiffness(membrane, 1), -1};
    case SheetProperty::kPoissonRatio:
      return {inputs.sheet_poisson(membrane), -1};
    case SheetProperty::kThickness:
      return {inputs.thickness(membrane), -1};
    case SheetProperty::kPreStretch:
      return {inputs.pre_stretch(membrane, 0), inputs.pre_stretch(membrane, 1)};
    case SheetProperty::kPreStretch1:
      return {inputs.pre_stretch(membrane, 0), -1};
    case SheetProperty::kPreStretch2:
      return {inputs.pre_stretch(membrane, 1), -1};
  }
  return {-1, -1};
}

struct NaturalWords {
  const char* name;
  ParameterKind kind;
};

NaturalWords words_of(NaturalProperty property) {
  switch (property) {
    case NaturalProperty::kCurvatureB:
      return {"natural curvature towards b", ParameterKind::kCurvature};
    case NaturalProperty::kCurvatureN:
      return {"natural curvature towards n", ParameterKind::kCurvature};
    case NaturalProperty::kTwist:
      return {"natural twist", ParameterKind::kTwistRate};
    case NaturalProperty::kLengthFactor:
      break;
  }
  return {"natural length over the drawn one", ParameterKind::kLengthFactor};
}

Result<std::vector<int>> rod_numbers(const Structure& structure, const std::vector<std::string>& names) {
  std::vector<int> numbers;
  std::vector<std::string> known;
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r) {
    known.push_back(structure.rods[r].name);
    if (names.empty()) numbers.push_back(r);
  }
  for (const std::string& name : names) {
    const int r = structure.rod_index(name);
    if (r < 0) {
      return Error{ErrorCode::kUnknown, "/rods", fmt::format("there is no rod \"{}\"", name), suggestion(name, known)};
    }
    if (std::find(numbers.begin(), numbers.end(), r) == numbers.end()) numbers.push_back(r);
  }
  return numbers;
}

}  // namespace

Result<LinearSpace> youngs_modulus_space(std::shared_ptr<const Design> base, ModulusChoice choice, const Vec2& range) {
  if (Status s = check_positive(range, "Young's moduli"); !s) return s.error();
  const Structure& structure = base->system.structure;
  const RestInputs inputs(structure);
  LinearColumns columns;
  const auto modulus = [&](int r) { return base->model.material(structure.rods[r].material)->youngs_modulus; };
  const auto parameter = [&](const std::string& of) {
    return Parameter{ParameterKind::kYoungsModulus, fmt::format("{}: Young's modulus", of), range[0], range[1]};
  };
  if (choice == ModulusChoice::kPerRod) {
    for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r) {
      const StructureRod& rod = structure.rods[r];
      if (r >= static_cast<int>(base->model.rods.size())) {
        return Error{ErrorCode::kUnsupported, "/plan", "the rods of a plan share their material",
                     "choose one modulus for each material"};
      }
      Parameter own = parameter(fmt::format("rod \"{}\"", rod.name));
      own.at = structure.nodes[rod.nodes[rod.nodes.size() / 2]];
      columns.add(std::move(own), modulus(r));
      columns.input(inputs.youngs_modulus(r), 1);
    }
    return std::move(columns).space(std::move(base));
  }
  std::map<std::string, std::vector<int>> by_material;
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r)
    by_material[structure.rods[r].material].push_back(r);
  for (const auto& [name, rods] : by_material) {
    columns.add(parameter(fmt::format("material \"{}\"", name)), modulus(rods[0]));
    for (const int r : rods) columns.input(inputs.youngs_modulus(r), 1);
  }
  return std::move(columns).space(std::move(base));
}

Result<LinearSpace> fabric_space(std::shared_ptr<const Design> base, const std::vector<SheetChoice>& choices) {
  const Structure& structure = base->system.structure;
  const RestInputs inputs(structure);
  const VecX present = rest_input_values(base->model, base->system);
  LinearColumns columns;
  std::vector<bool> taken(static_cast<std::size_t>(inputs.size()), false);
  for (const SheetChoice& choice : choices) {
    const char* what = name_of(choice.property);
    const ParameterKind kind = kind_of(choice.property);
    if (kind == ParameterKind::kSheetStiffness || kind == ParameterKind::kPreStretch ||
        kind == ParameterKind::kThickness) {
      if (Status s = check_positive(choice.range, what); !s) return s.error();
    }
    // Moduli belong to fabrics, pre-stretches to membranes.
    std::map<std::string, std::vector<int>> users;
    for (int m = 0; m < static_cast<int>(structure.membranes.size()); ++m) {
      const StructureMembrane& membrane = structure.membranes[m];
      users[kind == ParameterKind::kPreStretch ? fmt::format("membrane \"{}\"", membrane.name)
                                               : fmt::format("fabric \"{}\"", membrane.material)]
          .push_back(m);
    }
    for (const auto& [of, membranes] : users) {
      const double start = present[inputs_of(choice.property, inputs, membranes[0]).first];
      columns.add({kind, fmt::format("{}: {}", of, what), choice.range[0], choice.range[1]}, start);
      for (const int m : membranes) {
        const auto [first, second] = inputs_of(choice.property, inputs, m);
        for (const int input : {first, second}) {
          if (input < 0) continue;
          if (taken[static_cast<std::size_t>(input)]) {
            return Error{ErrorCode::kConflict, "/parameters",
                         fmt::format("{}: {} is chosen in more than one way", of, what), "choose it once"};
          }
          taken[static_cast<std::size_t>(input)] = true;
          columns.input(input, present[input] / start);
        }
      }
    }
  }
  return std::move(columns).space(std::move(base));
}

Result<LinearSpace> natural_shape_space(std::shared_ptr<const Design> base, const std::vector<std::string>& rods,
                                        const std::vector<NaturalChoice>& choices) {
  const Structure& structure = base->system.structure;
  const RestInputs inputs(structure);
  const Result<std::vector<int>> numbers = rod_numbers(structure, rods);
  if (!numbers) return numbers.error();
  LinearColumns columns;
  std::vector<NaturalProperty> taken;
  for (const NaturalChoice& choice : choices) {
    const NaturalWords words = words_of(choice.property);
    const bool factor = choice.property == NaturalProperty::kLengthFactor;
    if (std::find(taken.begin(), taken.end(), choice.property) != taken.end()) {
      return Error{ErrorCode::kConflict, "/parameters", fmt::format("the {} is chosen twice", words.name),
                   "choose it once"};
    }
    taken.push_back(choice.property);
    if (factor) {
      if (Status s = check_positive(choice.range, words.name); !s) return s.error();
    }
    for (const int r : numbers.value()) {
      const StructureRod& rod = structure.rods[r];
      if (r >= static_cast<int>(base->model.rods.size())) {
        return Error{ErrorCode::kUnsupported, "/plan", "rods of a plan are natural as drawn",
                     "use the control points of the plan"};
      }
      if (!factor && !rod.natural_rates) {
        return Error{ErrorCode::kUnsupported, "/rods",
                     fmt::format("the natural shape of rod \"{}\" has no constant curvature and twist", rod.name),
                     "describe it as \"straight\", or by its curvatures and twist"};
      }
      const int row = factor ? inputs.length_factor(r) : inputs.natural_rate(r, static_cast<int>(choice.property));
      const double start = factor ? rod.length_factor : (*rod.natural_rates)[static_cast<int>(choice.property)];
      columns.add({words.kind, fmt::format("rod \"{}\": {}", rod.name, words.name), choice.range[0], choice.range[1]},
                  start);
      columns.input(row, 1);
    }
  }
  return std::move(columns).space(std::move(base));
}

}  // namespace lissom
