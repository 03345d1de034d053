#pragma once
/// The report of a finished run, from what the run knows.

#include <string>

#include "lissom/session/design_report.h"
#include "lissom/session/design_run.h"

namespace lissom {

/// Without title, document, files, command and version.
DesignReport report_of(const DesignRun& run);

}  // namespace lissom
