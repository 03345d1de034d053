#pragma once
/// The `.lissom` document: JSON text <-> Model. docs/guide/document.md explains the format to users.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "lissom/core/result.h"
#include "lissom/model/model.h"

namespace lissom {

constexpr int kDocumentVersion = 1;                               ///< value of the key "lissom"
constexpr std::size_t kLargestDocument = std::size_t{256} << 20;  ///< bytes
constexpr int kDeepestDocument = 64;                              ///< nested brackets

/// Reads and validates. `folder` is where the document lies: files that it names are looked for there and below. Errors
/// carry a JSON pointer ("/rods/3/section/radius"), or "line 3, column 7" where the text is not JSON.
Result<Model> read_document(std::string_view text, const std::filesystem::path& folder = {});

/// How networks that were read from files are written.
enum class NetworkText {
  kFiles,  ///< networks read from a file name it again, unless their rods were changed since
  kRods,   ///< every rod with its points: a text that stands for itself
};

/// The document of a model: fixed order of fields, two-space indent, final newline, defaults left out. What the kind of a
/// support, curve or section does not use is not written. Reading it again gives the same model to the last bit, provided
/// that its directions are unit vectors. The numbers of the model have to be finite (`validate()` says so).
std::string write_document(const Model& model, NetworkText networks = NetworkText::kFiles);

/// JSON Schema (2020-12) of the format.
std::string document_schema();

}  // namespace lissom
