#include <algorithm>
#include <cmath>

#include "lissom/view/picture_parts.h"

namespace lissom {

ColorKey color_key(const std::vector<Panel>& panels, const std::string& name, const std::optional<ColorRange>& range) {
  ColorKey key;
  if (name.empty()) return key;
  bool any = false;
  ColorRange found;
  for (const Panel& panel : panels) {
    for (const Layer& layer : panel.layers) {
      if (layer.style != Layer::Style::kSolid) continue;
      const Field& field = *layer.drawing.field(name);
      if (key.field == nullptr) key.field = &field;
      const bool has_values =
          std::any_of(field.values.begin(), field.values.end(), [](double v) { return !std::isnan(v); });
      key.legend.has_missing |=
          std::any_of(field.values.begin(), field.values.end(), [](double v) { return std::isnan(v); });
      if (!has_values) continue;
      const ColorRange fitted = ColorRange::fitting(field.colors, field.values);
      const ColorRange extremes = ColorRange::fitting(Field::Colors::kSequential, field.values);
      key.range = any ? key.range.including(fitted) : fitted;
      found = any ? found.including(extremes) : extremes;
      any = true;
    }
  }
  if (key.field == nullptr) return key;
  if (range) key.range = *range;
  const double scale = key.field->display_scale;
  key.legend.title = key.field->name;
  key.legend.unit = key.field->display_unit;
  key.legend.colors = key.field->colors;
  key.legend.range = {key.range.low * scale, key.range.high * scale};
  key.legend.found = {found.low * scale, found.high * scale};
  key.legend.has_values = any;
  return key;
}

}  // namespace lissom
