#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/view/picture_parts.h"

namespace lissom {

namespace {

Status check_field(const Drawing& drawing, const std::string& name) {
  if (name.empty() || drawing.field(name) != nullptr) return {};
  std::string names;
  for (const Field& f : drawing.fields) names += (names.empty() ? "" : ", ") + f.name;
  return Error{ErrorCode::kUnknown, "field", fmt::format("there is no field \"{}\"", name),
               names.empty() ? "this drawing has no fields" : "known fields: " + names};
}

}  // namespace

Status check_picture(const std::vector<Panel>& panels, const PictureOptions& options) {
  if (Status status = check_size(options.width, options.height); !status) return status;
  if (Status status = options.view.validate(); !status) return status;
  for (const std::optional<ColorRange>& range : {options.range, options.membrane_range}) {
    if (!range || (std::isfinite(range->low) && range->high > range->low && std::isfinite(range->high))) continue;
    return Error{ErrorCode::kRange, "range", "the colour range is empty", "give a lower and a higher finite number"};
  }
  bool any = false;
  for (const Panel& panel : panels) {
    for (const Layer& layer : panel.layers) {
      any = true;
      if (Status status = check_drawing(layer.drawing); !status) return status;
      for (const std::vector<Vec3>& guide : layer.guides) {
        if (std::all_of(guide.begin(), guide.end(), [](const Vec3& p) { return p.allFinite(); })) continue;
        return Error{ErrorCode::kRange, "guides", "a guide has a coordinate that is not a finite number", {}};
      }
      if (!std::all_of(layer.dots.begin(), layer.dots.end(), [](const Vec3& p) { return p.allFinite(); })) {
        return Error{ErrorCode::kRange, "dots", "a dot has a coordinate that is not a finite number", {}};
      }
      if (layer.style != Layer::Style::kSolid) continue;
      if (Status status = check_field(layer.drawing, options.field); !status) return status;
      if (Status status = check_field(layer.drawing, options.membrane_field); !status) return status;
      if (const Field* field = layer.drawing.field(options.membrane_field);
          field != nullptr && field->place == Field::Place::kEdge) {
        return Error{ErrorCode::kConflict, "field", fmt::format("membranes have no \"{}\"", field->name),
                     "choose a field of nodes or triangles for them"};
      }
    }
  }
  if (!any) return Error{ErrorCode::kGeometry, "picture", "there is nothing to draw", "give at least one state"};
  return {};
}

}  // namespace lissom
