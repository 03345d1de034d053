#include "lissom/geometry/ply_parts.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <fmt/format.h>

#include "lissom/geometry/text_words.h"

namespace lissom {

namespace {

struct PlyTypeName {
  std::string_view name;
  PlyType type;
};
constexpr PlyTypeName kTypeNames[] = {
    {"char", PlyType::kInt8},      {"int8", PlyType::kInt8},     {"uchar", PlyType::kUint8},
    {"uint8", PlyType::kUint8},    {"short", PlyType::kInt16},   {"int16", PlyType::kInt16},
    {"ushort", PlyType::kUint16},  {"uint16", PlyType::kUint16}, {"int", PlyType::kInt32},
    {"int32", PlyType::kInt32},    {"uint", PlyType::kUint32},   {"uint32", PlyType::kUint32},
    {"float", PlyType::kFloat},    {"float32", PlyType::kFloat}, {"double", PlyType::kDouble},
    {"float64", PlyType::kDouble},
};

bool type_named(std::string_view name, PlyType& type) {
  for (const PlyTypeName& known : kTypeNames) {
    if (known.name == name) return type = known.type, true;
  }
  return false;
}

double meaning(PlyType type, std::uint64_t bits) {
  switch (type) {
    case PlyType::kInt8:
      return static_cast<std::int8_t>(bits);
    case PlyType::kInt16:
      return static_cast<std::int16_t>(bits);
    case PlyType::kInt32:
      return static_cast<std::int32_t>(bits);
    case PlyType::kFloat:
      return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    case PlyType::kDouble:
      return std::bit_cast<double>(bits);
    default:
      return static_cast<double>(bits);
  }
}

class PlyHeaderReader {
 public:
  PlyHeaderReader(std::string_view& bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  Result<PlyHeader> read() {
    bool formed = false;
    while (!bytes_.empty()) {
      std::string_view line = next_line(bytes_);
      ++header_.lines;
      const std::string_view key = next_word(line);
      if (header_.lines == 1 && key != "ply") return wrong("the file does not begin with \"ply\"");
      if (key == "end_header") return formed ? Result<PlyHeader>(header_) : wrong("the header has no format");
      Status s;
      if (key == "format") s = format(line), formed = true;
      if (key == "element") s = element(line);
      if (key == "property") s = property(line);
      if (!s) return s.error();
    }
    return wrong("the header has no end");
  }

 private:
  Error wrong(std::string message) const {
    return {ErrorCode::kSyntax, fmt::format("{}:{}", file_, std::max(1LL, header_.lines)), std::move(message),
            "the file is damaged or of another format; export the surface again"};
  }

  Status format(std::string_view line) {
    const std::string_view word = next_word(line);
    if (word == "ascii") return header_.form = PlyForm::kText, Status();
    if (word == "binary_little_endian") return header_.form = PlyForm::kLittleEndian, Status();
    if (word == "binary_big_endian") return header_.form = PlyForm::kBigEndian, Status();
    return wrong(fmt::format("there is no format \"{}\"", shown_word(word)));
  }

  Status element(std::string_view line) {
    PlyElement added;
    added.name = next_word(line);
    if (!read_integer(next_word(line), added.count) || added.count < 0) return wrong("the element has no count");
    if (header_.elements.size() >= 64) return wrong("the header has more than 64 elements");
    header_.elements.push_back(std::move(added));
    return {};
  }

  Status property(std::string_view line) {
    if (header_.elements.empty()) return wrong("the property belongs to no element");
    PlyProperty added;
    std::string_view type = next_word(line);
    if (type == "list") {
      added.list = true;
      if (!type_named(next_word(line), added.count_type)) return wrong("the list has a count of no known type");
      type = next_word(line);
    }
    if (!type_named(type, added.type)) return wrong(fmt::format("there is no type \"{}\"", shown_word(type)));
    added.name = next_word(line);
    if (header_.elements.back().properties.size() >= 256) return wrong("the element has more than 256 properties");
    header_.elements.back().properties.push_back(std::move(added));
    return {};
  }

  std::string_view& bytes_;
  const std::string& file_;
  PlyHeader header_;
};

}  // namespace

int ply_bytes(PlyType type) {
  constexpr int kBytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[static_cast<int>(type)];
}

int PlyElement::find(std::initializer_list<std::string_view> names) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (std::find(names.begin(), names.end(), properties[i].name) != names.end()) return static_cast<int>(i);
  }
  return -1;
}

Result<PlyHeader> read_ply_header(std::string_view& bytes, const std::string& file) {
  return PlyHeaderReader(bytes, file).read();
}

PlyNumbers::Got PlyNumbers::word(double& value) {
  std::string_view found;
  while ((found = next_word(rest_)).empty()) {
    if (data_.empty()) return Got::kEnd;
    rest_ = next_line(data_);
    ++line_;
  }
  if (read_number(found, value)) return Got::kNumber;
  wrong_word_ = shown_word(found);
  return Got::kWord;
}

PlyNumbers::Got PlyNumbers::number(PlyType type, double& value) {
  const std::size_t size = static_cast<std::size_t>(ply_bytes(type));
  if (data_.size() < size) return Got::kEnd;
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = form_ == PlyForm::kLittleEndian ? size - 1 - i : i;
    bits = bits << 8 | static_cast<unsigned char>(data_[at]);
  }
  data_.remove_prefix(size);
  value = meaning(type, bits);
  return Got::kNumber;
}

}  // namespace lissom
