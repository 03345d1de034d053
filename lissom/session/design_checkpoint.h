#pragma once
/// A file from which an inverse design goes on.

#include <string>

#include "lissom/core/result.h"
#include "lissom/model/model.h"
#include "lissom/session/design_run.h"

namespace lissom {

/// What a checkpoint has to agree with: the document with its brief, but for how many iterations are allowed.
std::string design_fingerprint(const Model& model);

std::string checkpoint_text(const DesignCheckpoint& checkpoint, const std::string& fingerprint);

/// `where`: the file, for errors. kConflict where it was made from another document or with other settings.
Result<DesignCheckpoint> read_checkpoint(const std::string& text, const std::string& fingerprint,
                                         const std::string& where);

}  // namespace lissom
