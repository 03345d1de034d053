#include "lissom/session/document_file.h"

#include <cctype>
#include <cstdint>
#include <fmt/format.h>

#include "lissom/core/file_io.h"
#include "lissom/model/document.h"

namespace lissom {

Result<Document> read_document_file(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, kLargestDocument);
  if (!text) return text.error();
  Result<Model> model = read_document(text.value(), path.parent_path());
  if (!model) {
    Error error = model.error();
    error.where = error.where.empty() ? path.string() : path.string() + ": " + error.where;
    return error;
  }
  return Document{path.stem().string(), path.parent_path(), std::move(model).value()};
}

std::string document_hash(const Model& model) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : write_document(model, NetworkText::kRods))
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return fmt::format("{:016x}", hash);
}

std::string file_name_part(const std::string& text) {
  std::string part;
  for (const char c : text) {
    const bool safe = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.';
    if (safe) {
      part += c;
    } else if (!part.empty() && part.back() != '-') {
      part += '-';
    }
  }
  while (!part.empty() && part.back() == '-') part.pop_back();
  return part.empty() ? "unnamed" : part;
}

}  // namespace lissom
