#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <utility>
#include <zip.h>

#include "lissom/fabrication/exporters.h"

namespace lissom {

namespace {

/// One file inside the archive.
struct Part {
  const char* name;
  std::string text;
};

constexpr const char* kXml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

std::string content_types() {
  return std::string(kXml) +
         "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
         " <Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
         " <Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
         "</Types>\n";
}

std::string relationships() {
  return std::string(kXml) +
         "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
         " <Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
         "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
         "</Relationships>\n";
}

void add_mesh(const Surface& surface, std::string& xml) {
  const auto out = std::back_inserter(xml);
  xml += "   <mesh>\n    <vertices>\n";
  for (const Vec3& x : surface.vertices) {
    const Eigen::Vector3f mm = (1e3 * x).cast<float>();
    fmt::format_to(out, "     <vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", mm.x(), mm.y(), mm.z());
  }
  xml += "    </vertices>\n    <triangles>\n";
  for (const std::array<int, 3>& t : surface.triangles) {
    fmt::format_to(out, "     <triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", t[0], t[1], t[2]);
  }
  xml += "    </triangles>\n   </mesh>\n";
}

/// Colours only tell materials apart on the screen.
std::string colour(std::size_t material) {
  constexpr const char* kColours[] = {"#8FA3B8", "#D98E5F", "#7FB285", "#C77DA0", "#C9B458"};
  return kColours[material % std::size(kColours)];
}

std::string model(const PrintObjects& objects) {
  std::string xml = kXml;
  xml +=
      "<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n";
  xml += " <metadata name=\"Title\">" + escaped(objects.title) + "</metadata>\n";
  xml += " <metadata name=\"Application\">lissom</metadata>\n <resources>\n  <basematerials id=\"1\">\n";
  for (std::size_t i = 0; i < objects.objects.size(); ++i) {
    xml += "   <base name=\"" + escaped(objects.objects[i].material) + "\" displaycolor=\"" + colour(i) + "\"/>\n";
  }
  xml += "  </basematerials>\n";
  std::string build;
  for (std::size_t i = 0; i < objects.objects.size(); ++i) {
    xml += fmt::format("  <object id=\"{}\" type=\"model\" name=\"{}\" pid=\"1\" pindex=\"{}\">\n", i + 2,
                       escaped(objects.objects[i].material), i);
    add_mesh(objects.objects[i].surface, xml);
    xml += "  </object>\n";
    build += fmt::format("  <item objectid=\"{}\"/>\n", i + 2);
  }
  return xml + " </resources>\n <build>\n" + build + " </build>\n</model>\n";
}

Error zip_error(const std::string& what) {
  return {ErrorCode::kFile, {}, "the archive cannot be made: " + what, "is there enough memory?"};
}

struct SourceEnd {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};

Result<std::string> content(zip_source_t* source) {
  zip_stat_t stat;
  if (zip_source_open(source) != 0 || zip_source_stat(source, &stat) != 0) return zip_error("it cannot be read back");
  std::string bytes(stat.size, '\0');
  const bool read = zip_source_read(source, bytes.data(), stat.size) == static_cast<zip_int64_t>(stat.size);
  zip_source_close(source);
  if (!read) return zip_error("it cannot be read back");
  return bytes;
}

/// An archive in memory; all files bear the first date that the format knows, so that bytes depend on nothing else.
Result<std::string> zipped(const std::vector<Part>& parts) {
  constexpr zip_uint16_t kTime = 0, kDate = 1 << 5 | 1;  // 1980-01-01 00:00
  constexpr zip_uint32_t kEffort = 6;
  const std::unique_ptr<zip_source_t, SourceEnd> source(zip_source_buffer_create(nullptr, 0, 0, nullptr));
  if (!source) return zip_error("no memory");
  zip_source_keep(source.get());  // closing the archive gives one hold back
  zip_t* archive = zip_open_from_source(source.get(), ZIP_TRUNCATE, nullptr);
  if (archive == nullptr) {
    zip_source_free(source.get());
    return zip_error("no memory");
  }
  for (const Part& part : parts) {
    zip_source_t* data = zip_source_buffer(archive, part.text.data(), part.text.size(), 0);
    const zip_int64_t index = data == nullptr ? -1 : zip_file_add(archive, part.name, data, ZIP_FL_ENC_UTF_8);
    const auto at = static_cast<zip_uint64_t>(index);
    if (index < 0 || zip_set_file_compression(archive, at, ZIP_CM_DEFLATE, kEffort) != 0 ||
        zip_file_set_dostime(archive, at, kTime, kDate, 0) != 0) {
      if (index < 0 && data != nullptr) zip_source_free(data);
      const std::string why = zip_strerror(archive);
      zip_discard(archive);
      return zip_error(why);
    }
  }
  if (zip_close(archive) != 0) {
    const std::string why = zip_strerror(archive);
    zip_discard(archive);
    return zip_error(why);
  }
  return content(source.get());
}

}  // namespace

Result<std::string> export_3mf(const PrintObjects& objects) {
  return zipped({{"[Content_Types].xml", content_types()},
                 {"_rels/.rels", relationships()},
                 {"3D/3dmodel.model", model(objects)}});
}

}  // namespace lissom
