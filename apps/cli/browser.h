#pragma once
/// Opening a page in the browser of whoever sits at the terminal.

#include <string>

namespace lissom::cli {

/// Whether somebody looks: standard output is a terminal and the session has a display.
bool somebody_looks();

/// Asks the system to open an address; returns at once. False when there is no such program.
bool open_in_browser(const std::string& address);

}  // namespace lissom::cli
