#pragma once
/// A description with the name that people know it by, from a file or from a scene.

#include <filesystem>
#include <string>

#include "lissom/core/result.h"
#include "lissom/model/model.h"

namespace lissom {

struct Document {
  std::string name;              ///< of the file without folder and ending, or of the scene: results are named after it
  std::filesystem::path folder;  ///< where it lies; empty: the current folder
  Model model;

  std::filesystem::path default_output() const { return folder / "out"; }
};

/// Reads a `.lissom` file. Errors name the file first.
Result<Document> read_document_file(const std::filesystem::path& path);

/// 16 hexadecimal digits that tell one description from another: FNV-1a over its canonical text.
std::string document_hash(const Model& model);

/// `text` with everything but letters, digits, '-', '_' and '.' turned into '-': safe as part of a file name.
std::string file_name_part(const std::string& text);

}  // namespace lissom
