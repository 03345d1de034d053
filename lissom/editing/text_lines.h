#pragma once
/// Texts as lists of lines, their differences as JSON patches (RFC 6902), and a short name for a text.

#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"

namespace lissom {

std::vector<std::string> lines_of(std::string_view text);
std::string text_of(const std::vector<std::string>& lines);

/// What makes the list `to` of the list `from`: a JSON array of operations.
std::string line_patch(const std::vector<std::string>& from, const std::vector<std::string>& to);

/// 16 hexadecimal digits that tell one text from another: FNV-1a, as document_hash() of session.
std::string text_hash(std::string_view text);

}  // namespace lissom
