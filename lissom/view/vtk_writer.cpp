#include "lissom/view/vtk_writer.h"

#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <vector>

#include "lissom/view/text.h"

namespace lissom {

static_assert(std::endian::native == std::endian::little, "files are declared little-endian");
static_assert(sizeof(Vec3) == 3 * sizeof(double));

VtkWriter::VtkWriter(std::string_view type, std::optional<double> time) : type_(type) {
  text_ = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<{0}>\n",
      type_);
  if (time) {
    text_ += "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">";
    append_number(text_, *time);
    text_ += "</DataArray>\n</FieldData>\n";
  }
}

void VtkWriter::open(std::string_view element, std::string_view attributes) {
  text_ += fmt::format("<{}{}{}>\n", element, attributes.empty() ? "" : " ", attributes);
}

void VtkWriter::close(std::string_view element) { text_ += fmt::format("</{}>\n", element); }

void VtkWriter::array(std::string_view name, std::span<const double> values) {
  data("Float64", name, 1, values.data(), values.size_bytes());
}
void VtkWriter::array(std::string_view name, std::span<const Vec3> values) {
  data("Float64", name, 3, values.data(), values.size_bytes());
}
void VtkWriter::array(std::string_view name, std::span<const int64_t> values) {
  data("Int64", name, 1, values.data(), values.size_bytes());
}
void VtkWriter::array(std::string_view name, std::span<const uint8_t> values) {
  data("UInt8", name, 1, values.data(), values.size_bytes());
}

void VtkWriter::data(std::string_view type, std::string_view name, int components, const void* bytes, size_t size) {
  std::vector<uint8_t> block(sizeof(uint64_t) + size);
  const uint64_t header = size;
  std::memcpy(block.data(), &header, sizeof header);
  if (size > 0) std::memcpy(block.data() + sizeof header, bytes, size);
  text_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">", type,
                       xml_escaped(name), components);
  text_ += base64(block);
  text_ += "</DataArray>\n";
}

std::string VtkWriter::finish() {
  text_ += fmt::format("</{}>\n</VTKFile>\n", type_);
  return std::move(text_);
}

std::string base64(std::span<const uint8_t> bytes) {
  static constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t left = bytes.size() - i;
    const uint32_t word = static_cast<uint32_t>(bytes[i]) << 16 |
                          (left > 1 ? static_cast<uint32_t>(bytes[i + 1]) << 8 : 0) | (left > 2 ? bytes[i + 2] : 0u);
    text += kLetters[word >> 18];
    text += kLetters[word >> 12 & 63];
    text += left > 1 ? kLetters[word >> 6 & 63] : '=';
    text += left > 2 ? kLetters[word & 63] : '=';
  }
  return text;
}

}  // namespace lissom
