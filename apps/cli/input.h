#pragma once
/// What the user names as input: a document, or a scene as "scene:NAME".

#include <string>

#include "lissom/session/document_file.h"

namespace lissom::cli {

inline constexpr const char* kInputHelp = "A .lissom document, or scene:NAME (`lissom scenes` lists the names)";

Result<Document> read_input(const std::string& input);

}  // namespace lissom::cli
