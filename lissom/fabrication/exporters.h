#pragma once
/// Files that printers take. Adding one: a file `export_<name>.cpp`, and a line in exporters.cpp.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/geometry/surface.h"

namespace lissom {

/// One object of one material.
struct PrintObject {
  std::string material;  ///< name
  Surface surface;       ///< m; darkness is not used
};

/// Lies where it is printed: no coordinate below zero.
struct PrintObjects {
  std::string title;
  std::vector<PrintObject> objects;
};

struct Exporter {
  std::string_view ending;  ///< ".3mf"
  std::string_view description;
  /// The bytes of a file, the same for the same objects: files carry no dates. Errors have no `where`.
  Result<std::string> (*bytes)(const PrintObjects& objects);
};

/// All of them, the one to recommend first.
std::span<const Exporter> exporters();

/// By the ending of a file name, in any case; kUnsupported, with all endings, for others.
Result<const Exporter*> exporter_for(const std::string& file);

/// 3MF [core specification 1.3]: millimetres, one object per material, identity transforms, coordinates as single floats.
Result<std::string> export_3mf(const PrintObjects& objects);

/// Binary STL in millimetres, normals by the right-hand rule. kConflict with more than one material, for it holds none.
Result<std::string> export_stl(const PrintObjects& objects);

}  // namespace lissom
