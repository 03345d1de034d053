#include "lissom/fabrication/exporters.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace lissom {

namespace {

constexpr Exporter kExporters[] = {
    {".3mf", "3MF with unit and materials; what slicers open at true size", export_3mf},
    {".stl", "binary STL in mm, of one material", export_stl},
};

}  // namespace

std::span<const Exporter> exporters() { return kExporters; }

Result<const Exporter*> exporter_for(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  std::string known;
  for (const Exporter& exporter : kExporters) {
    if (exporter.ending == ending) return &exporter;
    known += (known.empty() ? "" : ", ") + std::string(exporter.ending);
  }
  return Error{ErrorCode::kUnsupported, file, "files for printers end in " + known, "name the file like that"};
}

}  // namespace lissom
