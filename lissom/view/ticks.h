#pragma once
/// Round numbers for axes, legends and rulers.

#include <string>
#include <vector>

namespace lissom {

/// Places of ticks inside a range and what to write at them. Written value times 10^exponent = value.
struct Ticks {
  std::vector<double> at;
  std::vector<std::string> labels;
  int exponent = 0;
};

/// Multiples of 1, 2 or 5 times a power of ten within [low, high], about `wanted` of them. Very large and very small
/// numbers share a power of ten. A range without extent gives one tick.
Ticks linear_ticks(double low, double high, int wanted);

/// Powers of ten within [low, high], 0 < low; thinned out when there are more than `wanted`. Ranges below two decades
/// get 2 and 5 in between.
Ticks log_ticks(double low, double high, int wanted);

/// Three significant digits with a true minus sign: "1.25", "-4.5x10^-6" with superscripts.
std::string number_text(double value, int digits = 3);

/// "10" with superscript exponent.
std::string power_of_ten(int exponent);

/// Largest of 1, 2, 5 times a power of ten that is not above x > 0.
double round_below(double x);

/// A length in the unit that suits it: "50 mm", "2 m", "200 um" with the Greek letter.
std::string length_text(double metres);

}  // namespace lissom
