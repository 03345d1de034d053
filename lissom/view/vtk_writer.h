#pragma once
/// XML of the VTK file formats: elements and inline base64 arrays [VTK file formats, "XML file formats"].

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lissom/core/types.h"

namespace lissom {

class VtkWriter {
 public:
  explicit VtkWriter(std::string_view type, std::optional<double> time);

  void open(std::string_view element, std::string_view attributes = {});
  void close(std::string_view element);

  void array(std::string_view name, std::span<const double> values);
  void array(std::string_view name, std::span<const Vec3> values);
  void array(std::string_view name, std::span<const int64_t> values);
  void array(std::string_view name, std::span<const uint8_t> values);

  std::string finish();

 private:
  void data(std::string_view type, std::string_view name, int components, const void* bytes, size_t size);

  std::string text_;
  std::string type_;
};

/// RFC 4648, with padding.
std::string base64(std::span<const uint8_t> bytes);

}  // namespace lissom
