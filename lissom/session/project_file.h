#pragma once
/// A project with the files that it names.

#include <filesystem>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/model/rod_mesh.h"
#include "lissom/posing/posed_mesh.h"

namespace lissom {

struct Project {
  std::string name;              ///< of the file without folder and ending
  std::filesystem::path folder;  ///< where it lies: files that it names are found there and below
  RodMeshProject description;
  ProjectFiles files;
  std::vector<std::string> notes;  ///< what was mended of the surface
  std::string hash;                ///< 16 hexadecimal digits that tell this project, its files included, from another
};

/// Reads a project and its files. Errors name the file first.
Result<Project> read_project_file(const std::filesystem::path& path);

}  // namespace lissom
