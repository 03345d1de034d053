/// Stanford PLY: vertices with colours, and faces; other elements and properties are read over.
#include <cmath>
#include <fmt/format.h>

#include "lissom/geometry/ply_parts.h"
#include "lissom/geometry/surface_reading.h"
#include "lissom/geometry/text_words.h"

namespace lissom {

namespace {

class PlyReader {
 public:
  PlyReader(const PlyHeader& header, std::string_view data, const std::string& file)
      : header_(header),
        file_(file),
        numbers_(data, header.form, header.lines),
        reading_(file, header.form == PlyForm::kText ? "PLY text" : "binary PLY",
                 header.form == PlyForm::kText ? SurfaceReading::Places::kLines : SurfaceReading::Places::kElements) {}

  Result<RawSurface> read() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;  // takes no bytes
      if (Status s = check_size(element); !s) return s.error();
      const bool vertices = element.name == "vertex" || element.name == "vertices";
      const bool faces = element.name == "face" || element.name == "faces";
      Columns columns;
      if (Status s = find_columns(element, vertices, faces, columns); !s) return s.error();
      for (long long i = 0; i < element.count; ++i) {
        if (Status s = item(element, i); !s) return s.error();
        const Status taken = vertices ? vertex(columns, i) : faces ? face(i) : Status();
        if (!taken) return taken.error();
      }
    }
    return reading_.finish();
  }

 private:
  struct Columns {
    int x[3] = {-1, -1, -1}, rgb[3] = {-1, -1, -1};
    double full = 1;  ///< of a colour channel
  };

  Error wrong(ErrorCode code, const PlyElement& element, long long i, std::string message, std::string hint) const {
    return {code,
            header_.form == PlyForm::kText ? fmt::format("{}:{}", file_, numbers_.line())
                                           : fmt::format("{}, {} {}", file_, shown_word(element.name), i),
            std::move(message), std::move(hint)};
  }

  /// What the header announces has to fit into the bytes that there are.
  Status check_size(const PlyElement& element) const {
    long long least = 0;
    for (const PlyProperty& p : element.properties) {
      least += header_.form == PlyForm::kText ? 2 : ply_bytes(p.list ? p.count_type : p.type);
    }
    const auto left = static_cast<long long>(numbers_.left());
    if (element.count <= (left + 1) / least) return {};
    return wrong(ErrorCode::kFile, element, 0,
                 fmt::format("{} items of \"{}\" do not fit into the {} bytes that follow", element.count,
                             shown_word(element.name), left),
                 "the file was cut off, or its header is damaged; export the surface "
                 "again");
  }

  Status find_columns(const PlyElement& element, bool vertices, bool faces, Columns& columns) {
    if (vertices) {
      for (int i = 0; i < 3; ++i) {
        constexpr std::string_view kAxes[] = {"x", "y", "z"}, kLong[] = {"red", "green", "blue"},
                                   kShort[] = {"r", "g", "b"},
                                   kDiffuse[] = {"diffuse_red", "diffuse_green", "diffuse_blue"};
        columns.x[i] = element.find({kAxes[i]});
        columns.rgb[i] = element.find({kLong[i], kShort[i], kDiffuse[i]});
        if (columns.x[i] < 0) {
          return Error{ErrorCode::kSyntax, file_, fmt::format("the vertices have no property \"{}\"", kAxes[i]),
                       "export the surface again"};
        }
      }
      if (columns.rgb[0] >= 0 && element.properties[columns.rgb[0]].type == PlyType::kUint8) columns.full = 255;
      if (columns.rgb[0] >= 0 && element.properties[columns.rgb[0]].type == PlyType::kUint16) columns.full = 65535;
    }
    list_ = faces ? element.find({"vertex_indices", "vertex_index"}) : -1;
    if (!faces || (list_ >= 0 && element.properties[list_].list)) return {};
    return Error{ErrorCode::kSyntax, file_, "the faces have no list \"vertex_indices\"",
                 "export the surface as triangles or polygons"};
  }

  /// All properties of an item: scalars in values_, the list of corners in corners_.
  Status item(const PlyElement& element, long long i) {
    values_.assign(element.properties.size(), 0);
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      double value = 0;
      if (Status s = number(property.list ? property.count_type : property.type, element, i, value); !s) return s;
      values_[p] = value;
      if (!property.list) continue;
      if (!(value >= 0 && value <= static_cast<double>(numbers_.left()) && value == std::floor(value))) {
        return wrong(ErrorCode::kSyntax, element, i,
                     fmt::format("a list of {} entries does not fit into the file", value),
                     "the file is damaged; export the surface again");
      }
      const bool kept = static_cast<int>(p) == list_;
      if (kept) corners_.clear();
      for (long long k = 0; k < static_cast<long long>(value); ++k) {
        double entry = 0;
        if (Status s = number(property.type, element, i, entry); !s) return s;
        if (kept)
          corners_.push_back(std::abs(entry) < 1e15 && entry == std::floor(entry) ? static_cast<long long>(entry) : -1);
      }
    }
    return {};
  }

  Status number(PlyType type, const PlyElement& element, long long i, double& value) {
    switch (numbers_.next(type, value)) {
      case PlyNumbers::Got::kNumber:
        return {};
      case PlyNumbers::Got::kEnd:
        return wrong(ErrorCode::kFile, element, i,
                     fmt::format("the file ends in {} {} of {}", shown_word(element.name), i, element.count),
                     "it was cut off; export the surface again");
      default:
        return wrong(ErrorCode::kSyntax, element, i, fmt::format("\"{}\" is not a number", numbers_.wrong_word()),
                     "export the surface again");
    }
  }

  Status vertex(const Columns& columns, long long i) {
    const long long place = header_.form == PlyForm::kText ? numbers_.line() : i;
    if (Status s = reading_.add_point({values_[columns.x[0]], values_[columns.x[1]], values_[columns.x[2]]}, place);
        !s) {
      return s;
    }
    if (columns.rgb[0] >= 0 && columns.rgb[1] >= 0 && columns.rgb[2] >= 0) {
      reading_.paint(Vec3(values_[columns.rgb[0]], values_[columns.rgb[1]], values_[columns.rgb[2]]) / columns.full);
    }
    return {};
  }

  Status face(long long i) {
    return reading_.add_polygon(corners_, header_.form == PlyForm::kText ? numbers_.line() : i);
  }

  const PlyHeader& header_;
  const std::string& file_;
  PlyNumbers numbers_;
  SurfaceReading reading_;
  int list_ = -1;
  std::vector<double> values_;
  std::vector<long long> corners_;
};

}  // namespace

Result<RawSurface> read_surface_ply(std::string_view bytes, const std::string& file) {
  const Result<PlyHeader> header = read_ply_header(bytes, file);
  if (!header) return header.error();
  return PlyReader(header.value(), bytes, file).read();
}

}  // namespace lissom
