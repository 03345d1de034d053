#pragma once
/// Files for ParaView.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lissom/session/output.h"
#include "lissom/view/rod_drawing.h"

namespace lissom {

enum class ParaView { kNo, kYes };

/// Writes STEM-0000.vtu, STEM-0001.vtu, ... and the collection STEM.pvd that ParaView opens as a series. `times` are
/// seconds, or load factors.
Status write_series(const std::string& stem, const std::vector<double>& times,
                    const std::function<Result<Drawing>(int)>& drawing, Output& output);

}  // namespace lissom
