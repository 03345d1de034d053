#include "lissom/session/command_draw.h"

#include "lissom/session/fields.h"
#include "lissom/session/output.h"

namespace lissom {

Status draw_command(const Drawable& drawable, const DrawCommand& command) {
  const std::string ending = command.file.extension().string();
  if (ending != ".svg" && ending != ".png") {
    return Error{ErrorCode::kUnsupported, command.file.string(), "pictures are .svg or .png files",
                 "name the file like that"};
  }
  const Shown shown = drawable.solved ? command.shown : Shown::kRest;
  Result<Drawing> solid = draw(drawable, shown == Shown::kRest ? Shape::kRest : Shape::kDeformed);
  if (!solid) return solid.error();
  PictureOptions options = command.picture;
  const Document& document = drawable.document;
  if (options.title.empty()) options.title = document.model.title.empty() ? document.name : document.model.title;
  Panel panel;
  if (shown == Shown::kBoth) panel.layers.push_back({draw_rest(drawable.system), Layer::Style::kGhost});
  panel.layers.push_back({std::move(solid).value(), Layer::Style::kSolid});
  if (drawable.pose >= 0) panel.caption = document.model.poses[drawable.pose].name;
  Output output(command.file.parent_path());
  return output.write(command.file.filename(),
                      draw_picture({panel}, options, ending == ".svg" ? ImageFormat::kSvg : ImageFormat::kPng));
}

}  // namespace lissom
