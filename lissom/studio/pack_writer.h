#pragma once
/// Packs: a JSON header and numbers in one message (docs/studio/protocol.md).

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace lissom {

class PackWriter {
 public:
  /// `header`: an object; the list of arrays is added to it.
  explicit PackWriter(nlohmann::json header) : header_(std::move(header)) {}

  /// `columns` numbers in each row.
  PackWriter& add(const char* name, std::span<const float> values, int columns);
  PackWriter& add(const char* name, std::span<const std::uint32_t> values, int columns);

  std::shared_ptr<const std::string> finish() const;

 private:
  PackWriter& add(const char* name, const char* type, const void* values, std::size_t count, int columns);

  nlohmann::json header_;
  std::string body_;
};

}  // namespace lissom
