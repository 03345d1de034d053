#include "lissom/session/command_draw.h"

#include <algorithm>

#include "lissom/session/fields.h"
#include "lissom/session/ghost_lines.h"
#include "lissom/session/output.h"
#include "lissom/session/picture_strip.h"

namespace lissom {

namespace {

std::string title_of(const Drawable& drawable) {
  const Document& document = drawable.document;
  return document.model.title.empty() ? document.name : document.model.title;
}

std::string pose_of(const Drawable& drawable) {
  return drawable.pose >= 0 ? drawable.document.model.poses[drawable.pose].name : std::string();
}

Result<ImageFormat> format_of(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".svg") return ImageFormat::kSvg;
  if (ending == ".png") return ImageFormat::kPng;
  return Error{ErrorCode::kUnsupported, file.string(), "pictures are .svg or .png files", "name the file like that"};
}

/// The layers that `shown` asks for; the last one is solid.
Result<std::vector<Layer>> layers_of(const Drawable& drawable, Shown wanted) {
  const Shown shown = drawable.solved ? wanted : Shown::kRest;
  Result<Drawing> solid = draw(drawable, shown == Shown::kRest ? Shape::kRest : Shape::kDeformed);
  if (!solid) return solid.error();
  const State state = shown == Shown::kRest ? drawn_state(drawable.system) : drawable.state;
  std::vector<Layer> layers;
  if (shown == Shown::kBoth) layers.push_back({draw_rest(drawable.system), Layer::Style::kGhost});
  layers.push_back(
      {std::move(solid).value(), Layer::Style::kSolid, ghost_lines(drawable.document.model, drawable.system, state)});
  return layers;
}

}  // namespace

Status draw_command(const Drawable& drawable, const DrawCommand& command) {
  const Result<ImageFormat> format = format_of(command.file);
  if (!format) return format.error();
  Result<std::vector<Layer>> layers = layers_of(drawable, command.shown);
  if (!layers) return layers.error();
  PictureOptions options = command.picture;
  if (options.membrane_field.empty()) {
    options.membrane_field = field_of_membranes(layers.value().back().drawing, options.field);
  }
  if (options.title.empty()) options.title = title_of(drawable);
  Output output(command.file.parent_path());
  return output.write(command.file.filename(),
                      draw_picture({{std::move(layers).value(), pose_of(drawable)}}, options, format.value()));
}

Status draw_strip_command(const std::vector<Drawable>& drawables, const DrawCommand& command) {
  const Result<ImageFormat> format = format_of(command.file);
  if (!format) return format.error();
  const bool same_title = std::all_of(drawables.begin(), drawables.end(),
                                      [&](const Drawable& d) { return title_of(d) == title_of(drawables.front()); });
  std::vector<Panel> panels;
  for (const Drawable& drawable : drawables) {
    Result<std::vector<Layer>> layers = layers_of(drawable, command.shown);
    if (!layers) return layers.error();
    panels.push_back({std::move(layers).value(), same_title ? pose_of(drawable) : title_of(drawable)});
  }
  const PictureOptions& picture = command.picture;
  PictureStrip strip{.title = picture.title,
                     .field = picture.field,
                     .membrane_field = picture.membrane_field,
                     .view = picture.view,
                     .width = picture.width,
                     .theme = picture.theme,
                     .shadow = picture.shadow,
                     .tension = picture.tension};
  if (strip.membrane_field.empty() && !panels.empty()) {
    strip.membrane_field = field_of_membranes(panels.front().layers.back().drawing, strip.field);
  }
  if (strip.title.empty() && same_title && !drawables.empty()) strip.title = title_of(drawables.front());
  Output output(command.file.parent_path());
  return output.write(command.file.filename(), draw_panels(strip, panels, format.value()));
}

}  // namespace lissom
