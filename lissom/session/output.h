#pragma once
/// Where a command puts its files, and which it has written.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "lissom/core/result.h"

namespace lissom {

class Output {
 public:
  /// The folder is made by prepare(), or when the first file is written.
  explicit Output(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& folder() const { return folder_; }
  /// What was written since this was last asked.
  std::vector<std::filesystem::path> take_written() { return std::exchange(written_, {}); }

  /// Makes the folder and tries to write there: long work should not end in a folder that cannot take its result.
  Status prepare() const;
  /// Replaces `name` in the folder as a whole or not at all.
  Status write(const std::filesystem::path& name, const std::string& bytes);
  /// The same for bytes that may not have come about.
  Status write(const std::filesystem::path& name, const Result<std::string>& bytes);

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> written_;
};

}  // namespace lissom
