#pragma once
/// Which poses a command works on, under which loads, and what their files are called.

#include <string>
#include <vector>

#include "lissom/session/document_file.h"

namespace lissom {

/// Indices of the named poses; all of them when no name is given. A document without a pose is an error.
Result<std::vector<int>> pose_numbers(const Model& model, const std::vector<std::string>& names);

/// Refuses factors that are not finite or too large to compute with; `option` is what set it.
Status check_load_factor(double factor, const std::string& option);

/// One file name without ending per pose, all different: "bridge-loaded".
std::vector<std::string> pose_file_names(const Document& document);

}  // namespace lissom
