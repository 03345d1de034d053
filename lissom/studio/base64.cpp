#include "lissom/studio/base64.h"

#include <algorithm>
#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cctype>

namespace lissom {

namespace {

bool is_base64(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '/'; }

}  // namespace

std::optional<std::string> from_base64(std::string_view text) {
  if (text.size() % 4 != 0) return std::nullopt;
  std::size_t padding = 0;
  while (padding < 2 && text.ends_with('=')) {
    text.remove_suffix(1);
    ++padding;
  }
  if (!std::all_of(text.begin(), text.end(), is_base64)) return std::nullopt;
  // Whole groups of four and bytes; what is left of the last group holds fewer bits than a byte.
  using namespace boost::archive::iterators;
  using Bytes = transform_width<binary_from_base64<std::string::const_iterator>, 8, 6>;
  const std::string padded = std::string(text) + std::string(padding, 'A');
  std::string bytes(Bytes(padded.begin()), Bytes(padded.end()));
  bytes.resize(bytes.size() - padding);
  return bytes;
}

}  // namespace lissom
