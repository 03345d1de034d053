#pragma once
/// The text of a project: JSON with the key "lissom_project". docs/guide/rod-meshes.md explains it to users.

#include <string>
#include <string_view>

#include "lissom/core/result.h"
#include "lissom/model/rod_mesh.h"

namespace lissom {

constexpr int kProjectVersion = 1;

/// Whether a text claims to be a project rather than a structure.
bool is_project(std::string_view text);

/// Reads and validates; errors carry a JSON pointer, or "line 3, column 7" where the text is not JSON.
Result<RodMeshProject> read_project(std::string_view text);

std::string write_project(const RodMeshProject& project);

/// JSON Schema (2020-12) of the format.
std::string project_schema();

}  // namespace lissom
