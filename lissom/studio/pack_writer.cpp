#include "lissom/studio/pack_writer.h"

#include <bit>
#include <cstring>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

static_assert(std::endian::native == std::endian::little,
              "packs are little-endian, as all machines that browsers run on");
constexpr std::size_t kWord = 4;

}  // namespace

PackWriter& PackWriter::add(const char* name, std::span<const float> values, int columns) {
  return add(name, "f32", values.data(), values.size(), columns);
}

PackWriter& PackWriter::add(const char* name, std::span<const std::uint32_t> values, int columns) {
  return add(name, "u32", values.data(), values.size(), columns);
}

PackWriter& PackWriter::add(const char* name, const char* type, const void* values, std::size_t count, int columns) {
  LISSOM_ASSERT(columns > 0 && count % static_cast<std::size_t>(columns) == 0);
  header_["arrays"].push_back(
      {{"name", name}, {"type", type}, {"shape", {count / static_cast<std::size_t>(columns), columns}}});
  const std::size_t at = body_.size();
  body_.resize(at + kWord * count);
  if (count > 0) std::memcpy(body_.data() + at, values, kWord * count);
  return *this;
}

std::shared_ptr<const std::string> PackWriter::finish() const {
  std::string header = header_.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  header.resize((header.size() + kWord - 1) / kWord * kWord, ' ');
  const auto length = static_cast<std::uint32_t>(header.size());
  auto pack = std::make_shared<std::string>("LSM1");
  pack->reserve(2 * kWord + header.size() + body_.size());
  pack->append(reinterpret_cast<const char*>(&length), kWord);
  pack->append(header);
  pack->append(body_);
  return pack;
}

}  // namespace lissom
