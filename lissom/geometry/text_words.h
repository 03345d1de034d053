#pragma once
/// Lines and words of text that other programs have written.

#include <string>
#include <string_view>

namespace lissom {

/// Blanks inside a line; a carriage return is one.
inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// Takes the next word off the front of `line`; empty at the end.
std::string_view next_word(std::string_view& line);

/// Takes the next line off the front of `text`, without its end.
std::string_view next_line(std::string_view& text);

/// A word as it may be shown to people: short and printable.
std::string shown_word(std::string_view word);

/// The whole word as a number, "nan" and "inf" included; false for anything else, and for what no double can hold.
bool read_number(std::string_view word, double& value);

/// The whole word as a whole number.
bool read_integer(std::string_view word, long long& value);

}  // namespace lissom
