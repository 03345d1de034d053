#pragma once
/// Text in files that others read: names made safe, numbers exact and free of the locale.

#include <string>
#include <string_view>

namespace lissom {

/// Names come from documents: control characters and broken UTF-8 become question marks.
std::string printable(std::string_view text);

/// `printable`, with the characters that XML reserves replaced.
std::string xml_escaped(std::string_view text);

/// Shortest digits that read back as the same number.
void append_number(std::string& text, double value);
void append_number(std::string& text, float value);
void append_number(std::string& text, int value);

}  // namespace lissom
