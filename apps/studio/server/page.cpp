#include "apps/studio/server/page.h"

#include <algorithm>
#include <zlib.h>

namespace lissom {

const PageFile* find_file(Page page, std::string_view target) {
  std::string_view path = target.substr(0, target.find('?'));
  if (path == "/") path = "/index.html";
  const auto found = std::find_if(page.begin(), page.end(), [&](const PageFile& file) { return file.path == path; });
  return found == page.end() ? nullptr : &*found;
}

bool never_changes(const PageFile& file) { return file.path.starts_with("/assets/"); }

std::string decompress(const PageFile& file) {
  z_stream stream{};
  constexpr int kGzip = 16 + MAX_WBITS;
  if (inflateInit2(&stream, kGzip) != Z_OK) return {};
  stream.next_in = const_cast<unsigned char*>(file.bytes.data());  // zlib reads it only
  stream.avail_in = static_cast<uInt>(file.bytes.size());
  std::string plain;
  char piece[16384];
  int status = Z_OK;
  while (status == Z_OK) {
    stream.next_out = reinterpret_cast<unsigned char*>(piece);
    stream.avail_out = sizeof piece;
    status = inflate(&stream, Z_NO_FLUSH);
    plain.append(piece, sizeof piece - stream.avail_out);
  }
  inflateEnd(&stream);
  return status == Z_STREAM_END ? plain : std::string();
}

}  // namespace lissom
