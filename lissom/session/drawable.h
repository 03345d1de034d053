#pragma once
/// What can be drawn: a description as it is drawn, or a result as it came to rest.

#include <string>

#include "lissom/session/result_file.h"
#include "lissom/view/rod_drawing.h"

namespace lissom {

enum class Shape { kRest, kDeformed };

/// A structure with the state to look at.
struct Drawable {
  Document document;
  System system;
  State state;          ///< of a result; else the drawn shape
  int pose = -1;        ///< whose supports and forces are shown; -1: none
  bool solved = false;  ///< comes from a result
};

/// Whether the text is a result file rather than a document.
bool is_result(std::string_view text);

/// From a result.
Result<Drawable> make_drawable(SavedResult saved);
/// From a description; `pose` may be empty.
Result<Drawable> make_drawable(Document document, const std::string& pose);

/// With fields (computed in that shape) and markers.
Result<Drawing> draw(const Drawable& drawable, Shape shape);

}  // namespace lissom
