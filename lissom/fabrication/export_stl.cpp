#include <bit>
#include <cstdint>
#include <cstring>

#include "lissom/fabrication/exporters.h"

namespace lissom {

namespace {

constexpr std::size_t kHeader = 80, kPerTriangle = 50;  // bytes

void put(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
}

void put(std::string& bytes, const Eigen::Vector3f& x) {
  for (int i = 0; i < 3; ++i) put(bytes, std::bit_cast<std::uint32_t>(x[i]));
}

}  // namespace

Result<std::string> export_stl(const PrintObjects& objects) {
  if (objects.objects.size() > 1) {
    return Error{ErrorCode::kConflict, {}, "an STL file holds a single material", "write a .3mf file"};
  }
  std::string bytes = "binary STL in millimetres, by lissom";  // must not begin with "solid": that is the text format
  bytes.resize(kHeader, ' ');
  for (const PrintObject& object : objects.objects) {
    const Surface& s = object.surface;
    bytes.reserve(kHeader + 4 + s.triangles.size() * kPerTriangle);
    put(bytes, static_cast<std::uint32_t>(s.triangles.size()));
    for (const std::array<int, 3>& t : s.triangles) {
      const Vec3 normal = (s.vertices[t[1]] - s.vertices[t[0]]).cross(s.vertices[t[2]] - s.vertices[t[0]]);
      put(bytes, normal.normalized().cast<float>());
      for (const int v : t) put(bytes, (1e3 * s.vertices[v]).cast<float>());
      bytes += std::string(2, '\0');
    }
  }
  return bytes;
}

}  // namespace lissom
