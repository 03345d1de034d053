#pragma once
/// What the user names as input: a document, a scene as "scene:NAME", or a result.

#include <string>

#include "lissom/session/document_file.h"
#include "lissom/session/drawable.h"

namespace lissom::cli {

inline constexpr const char* kInputHelp = "A .lissom document, or scene:NAME (`lissom scenes` lists the names)";

Result<Document> read_input(const std::string& input);

/// A result of `lissom solve`.
Result<SavedResult> read_saved(const std::string& path);

/// A document or scene as it is drawn, with the supports of `pose` unless that is empty; or a result.
Result<Drawable> read_drawable(const std::string& input, const std::string& pose);

}  // namespace lissom::cli
