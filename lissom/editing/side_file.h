#pragma once
/// Side files: what a session keeps of work that is not saved, for the case that it is killed.

#include <filesystem>
#include <string>
#include <string_view>

#include "lissom/core/result.h"

namespace lissom {

struct SideFile {
  std::string name;       ///< of the project
  std::string file;       ///< below the folder; empty: it has none yet
  double when = 0;        ///< s since 1970
  int steps = 0;          ///< done and not saved
  std::string owner;      ///< the session that writes it (this_session()); empty: none any more
  std::string document;   ///< text_hash() of the document at hand
  std::string disk_hash;  ///< of the file when it was last read or written; empty: there was none
  std::string state;      ///< what the caller needs besides
  std::string history;    ///< as History::write() made it
};

std::string write_side_file(const SideFile& side);
Result<SideFile> read_side_file(std::string_view text);

/// Tells this process from all others of this machine, now and since it was started; empty where that cannot be told.
std::string this_session();
/// Whether the process that called itself so is still there.
bool session_lives(const std::string& session);

}  // namespace lissom
