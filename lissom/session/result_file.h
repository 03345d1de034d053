#pragma once
/// Result files: a solved pose with everything that is needed to look at it, to judge it and to go on from it. They carry
/// their document, so that one file is enough, and numbers in full: what is read back is the same to the last bit.

#include <filesystem>
#include <string>
#include <string_view>

#include "lissom/core/result.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/mechanics/system.h"
#include "lissom/session/document_file.h"
#include "lissom/session/warnings.h"

namespace lissom {

constexpr int kResultVersion = 1;  ///< value of the key "lissom_result"

/// The file of a pose solved by `solve` (SI units).
std::string result_text(const Document& document, const Pose& pose, const System& system,
                        const std::vector<std::string>& removed_motions, const Equilibrium& equilibrium,
                        const std::vector<Warning>& warnings);

/// One line of JSON that sums it up, as `lissom solve --json` prints it (SI units).
std::string result_summary(const Pose& pose, const System& system, const std::vector<std::string>& removed_motions,
                           const Equilibrium& equilibrium, const std::vector<Warning>& warnings,
                           const std::vector<std::filesystem::path>& files);

struct SavedResult {
  Document document;  ///< as it was when the result was made
  std::string pose;
  std::string verdict;  ///< name
  State state;
};

/// `name` is what the file is called in errors and what the document is called when it has no name.
Result<SavedResult> read_result(std::string_view text, const std::string& name);

/// Whether `state` fits the system: same numbers of nodes, edges and joints, and finite. Errors say what differs.
Status check_state(const System& system, const State& state);

}  // namespace lissom
