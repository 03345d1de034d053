#pragma once
/// Damages text at random, and takes what is still accepted as far as the forces of a first step. Same seed, same damage.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <gtest/gtest.h>
#include <iostream>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lissom/equilibrium/static_problem.h"
#include "lissom/mechanics/system.h"
#include "lissom/model/sampling.h"

namespace lissom {

/// How many damaged texts a test tries: 2,000, or LISSOM_MUTANTS.
inline int mutant_count() {
  const char* wanted = std::getenv("LISSOM_MUTANTS");
  return wanted ? std::atoi(wanted) : 2000;
}

/// Changes 1 to 4 places of a text; `values` are what numbers and words are replaced by.
class Mutator {
 public:
  Mutator(unsigned seed, std::span<const char* const> values) : random_(seed), values_(values) {}

  std::string mutate(std::string text, const std::string& other) {
    const int changes = 1 + below(4);
    const bool gentle = below(2) == 0;
    for (int i = 0; i < changes && !text.empty(); ++i) {
      if (gentle) {
        change_number(text, other);
      } else {
        change(text, other);
      }
    }
    return text;
  }

 private:
  int below(std::size_t n) { return static_cast<int>(random_() % n); }
  std::size_t place(const std::string& text) { return random_() % text.size(); }

  /// Begin and end of a run of characters that form a number or a word, near a random place.
  std::pair<std::size_t, std::size_t> token(const std::string& text) {
    const char* const inside = "0123456789+-.eEabcdfghijklmnopqrstuvwxyz_";
    const std::size_t begin = text.find_first_of(inside, place(text));
    if (begin == std::string::npos) return {0, 1};
    const std::size_t end = text.find_first_not_of(inside, begin);
    return {begin, (end == std::string::npos ? text.size() : end) - begin};
  }

  /// Begin and length of a number near a random place.
  std::pair<std::size_t, std::size_t> number(const std::string& text) {
    const std::size_t begin = text.find_first_of("0123456789", place(text));
    if (begin == std::string::npos) return {0, 0};
    const std::size_t end = text.find_first_not_of("0123456789.", begin);
    return {begin, (end == std::string::npos ? text.size() : end) - begin};
  }

  /// Keeps the form of the text, so that its meaning is reached: a number becomes another one, of this text or the other, or
  /// changes by a factor; or a whole line is left out, doubled or moved.
  void change_number(std::string& text, const std::string& other) {
    static constexpr const char* kNumbers[] = {"0",   "1",    "2",      "3",       "0.5",   "7",    "100",      "1e-3",
                                               "1e6", "1e-9", "12345",  "-1",      "-0.25", "1e17", "4e-14",    "0.1",
                                               "50",  "359",  "999999", "2000000", "1e-18", "360",  "0.333333", "1e30"};
    const auto [begin, size] = number(text);
    switch (below(6)) {
      case 0:
      case 1:
        text.replace(begin, size, kNumbers[random_() % std::size(kNumbers)]);
        break;
      case 2: {
        const auto [from, length] = number(text);
        text.replace(begin, size, text.substr(from, length));
        break;
      }
      case 3: {
        const auto [from, length] = number(other);
        text.replace(begin, size, other.substr(from, length));
        break;
      }
      case 4:
        text.insert(begin + size, 1, "0519."[random_() % 5]);
        break;
      default: {
        const std::size_t start = text.rfind('\n', place(text)) + 1;  // 0 in the first line
        const std::size_t end = std::min(text.find('\n', start), text.size() - 1) + 1;
        const std::string line = text.substr(start, end - start);
        if (below(2)) text.erase(start, end - start);
        if (!text.empty() && below(2)) text.insert(text.rfind('\n', place(text)) + 1, line);
      }
    }
  }

  void change(std::string& text, const std::string& other) {
    switch (below(11)) {
      case 0:
        text[place(text)] = static_cast<char>(random_());
        break;
      case 1:
        text[place(text)] ^= static_cast<char>(1 << below(8));
        break;
      case 2:
        text.erase(place(text), 1 + random_() % 20);
        break;
      case 3:
        text.insert(place(text), text.substr(place(text), 1 + random_() % 200));
        break;
      case 4:
        text.resize(place(text));
        break;
      case 5: {
        const auto [begin, size] = token(text);
        text.replace(begin, size, values_[random_() % values_.size()]);
        break;
      }
      case 6: {
        const auto [a, size] = token(text);
        const std::string first = text.substr(a, size);
        const auto [b, other_size] = token(text);
        const std::string second = text.substr(b, other_size);
        text.replace(b, other_size, first);
        if (a < text.size()) text.replace(a, std::min(size, text.size() - a), second);
        break;
      }
      case 7:
        text.insert(place(text), std::string(1 + random_() % 300, below(2) ? '[' : '{'));
        break;
      case 8: {
        const std::size_t from = random_() % other.size();
        text.insert(place(text), other.substr(from, 1 + random_() % 300));
        break;
      }
      case 9:
        text.insert(place(text), 1, "{}[],:\"\\/ \n"[random_() % 11]);
        break;
      default: {
        const auto [begin, size] = token(text);
        text.erase(begin, size);
      }
    }
  }

  std::mt19937_64 random_;
  std::span<const char* const> values_;
};

/// What became of a model that was accepted.
struct Journey {
  bool large = false;    ///< more nodes than the test has time for
  bool refused = false;  ///< with a message, on the way to a system or to a pose
};

/// Discretises, builds the pose's problem and evaluates its Hessian where the model is small; nothing may be silently NaN.
inline Journey taken_further(const Model& model) {
  constexpr double kMostNodesHere = 1500;
  Journey journey;
  double nodes = 0;
  for (const Rod& rod : model.rods) {
    const Result<int> edges = edge_count(rod, 1, "");
    if (edges) nodes += edges.value() + 1;
  }
  if (nodes > kMostNodesHere && nodes <= 2'000'000) {
    journey.large = true;
    return journey;
  }
  const Result<System> system = make_system(model);
  if (!system) {
    EXPECT_FALSE(system.error().message.empty());
    journey.refused = true;
    return journey;
  }
  for (const EdgeRest& edge : system.value().rest.edges) {
    EXPECT_TRUE(std::isfinite(edge.stretch) && edge.stretch > 0 && edge.length > 0);
  }
  for (std::size_t i = 0; i < model.poses.size(); ++i) {
    const Result<StaticProblem> problem =
        make_static_problem(model, system.value(), model.poses[i], "/poses/" + std::to_string(i));
    if (!problem) {
      EXPECT_FALSE(problem.error().message.empty());
      journey.refused = true;
      continue;
    }
    VecX gradient;
    std::vector<double> values;
    AssemblyBuffers buffers;
    problem.value().potential.hessian(drawn_state(system.value()), gradient, values, buffers);
    EXPECT_TRUE(gradient.allFinite());
    for (const double value : values) {
      EXPECT_TRUE(std::isfinite(value));
      if (!std::isfinite(value)) break;
    }
  }
  return journey;
}

/// Longest time that one mutant took, by the processor's clock.
class Stopwatch {
 public:
  void start() { start_ = std::clock(); }
  void stop() { longest_ = std::max(longest_, double(std::clock() - start_) / CLOCKS_PER_SEC); }
  double longest() const { return longest_; }

 private:
  std::clock_t start_ = 0;
  double longest_ = 0;  ///< s
};

/// s, that a mutant may take; instrumented programs are many times slower.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kLongest = 10;
#else
constexpr double kLongest = 1;
#endif

/// What became of all mutants of a test.
struct FuzzTally {
  int refused = 0, accepted = 0, large = 0, refused_later = 0;
  Stopwatch watch;

  void refuse(const Error& error, const std::string& text) {
    EXPECT_FALSE(error.message.empty()) << text;
    ++refused;
  }
  void accept(const Model& model) {
    const Journey journey = taken_further(model);
    large += journey.large;
    refused_later += journey.refused;
    ++accepted;
  }
  /// At least one in `deep` gets through to the end, at least one in `caught` is refused, and none takes long.
  void check(const char* what, int mutants, int deep, int caught) const {
    std::cout << mutants << " " << what << ": " << refused << " refused, " << accepted << " accepted (" << large
              << " too large for this test, " << refused_later << " refused later), longest " << watch.longest()
              << " s\n";
    EXPECT_EQ(accepted + refused, mutants);
    EXPECT_GT(accepted - large - refused_later, mutants / deep) << "the test no longer reaches deep";
    EXPECT_GT(refused, mutants / caught);
    EXPECT_LT(watch.longest(), kLongest);
  }
};

}  // namespace lissom
