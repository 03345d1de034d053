#pragma once
/// Charts over time of a motion, and its strip: the structure at equal distances in time, side by side.

#include <string>
#include <vector>

#include "lissom/motion/motion.h"
#include "lissom/session/picture_strip.h"
#include "lissom/view/chart.h"

namespace lissom {

/// Energies over time; what stays 0 is left out.
Chart energy_chart(const std::string& title, const MotionResult& result);

/// Angular momentum, and turn, of each watch.
Chart momentum_chart(const std::string& title, const MotionResult& result, const std::vector<std::string>& watches);
Chart turn_chart(const std::string& title, const MotionResult& result, const std::vector<std::string>& watches);

/// Records of a strip of at most `panels`, the first and the last among them.
std::vector<int> strip_records(const MotionResult& result, int panels);

/// `drawings`: one for each of the `shown` records. Captions tell the time, and the turn when one place is watched.
Result<std::string> draw_strip(const PictureStrip& strip, const MotionResult& result, const std::vector<int>& shown,
                               std::vector<Drawing> drawings, ImageFormat format);

}  // namespace lissom
