/// Documents damaged at random have to end in a model or in an error with a text. 2,000 damaged documents by default;
/// LISSOM_MUTANTS=20000 for the long run (under sanitizers).

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "lissom/core/file_io.h"
#include "lissom/model/document.h"

namespace lissom {
namespace {

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string mutate(std::string text, const std::string& other) {
    const int changes = 1 + below(4);
    for (int i = 0; i < changes && !text.empty(); ++i) change(text, other);
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

  void change(std::string& text, const std::string& other) {
    static const std::vector<std::string> values = {
        "NaN",         "1e999",  "-0",          "-1e308",   "1e-400",     "99999999999999999999",
        "0",           "-1",     "null",        "true",     "\"\"",       "\"1e308 km\"",
        "[]",          "{}",     "\"\\ud800\"", "\"-5 %\"", "2147483648", "1e300",
        "\"\\u0000\"", "\"all\""};
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
        text.replace(begin, size, values[random_() % values.size()]);
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
};

TEST(DocumentFuzz, DamagedDocumentsAreReadOrRefusedWithAReason) {
  std::vector<std::string> documents;
  for (const char* name : {"cantilever", "everything", "gridshell", "smallest"}) {
    documents.push_back(read_file("tests/documents/good/" + std::string(name) + ".lissom").value());
  }
  const char* wanted = std::getenv("LISSOM_MUTANTS");
  const int mutants = wanted ? std::atoi(wanted) : 2000;
  ASSERT_GT(mutants, 0);
  int accepted = 0, refused = 0;
  for (int i = 0; i < mutants; ++i) {
    Mutator mutator(static_cast<unsigned>(i));
    const std::size_t n = documents.size(), which = static_cast<std::size_t>(i) % n;
    const std::string text = mutator.mutate(documents[which], documents[(which + 1) % n]);
    const Result<Model> model = read_document(text);
    if (!model) {
      EXPECT_FALSE(model.error().message.empty()) << text;
      ++refused;
      continue;
    }
    const std::string written = write_document(model.value());
    const Result<Model> again = read_document(written);
    EXPECT_TRUE(again) << again.error().text() << "\nfrom\n" << text << "\nwritten\n" << written;
    ++accepted;
  }
  EXPECT_EQ(accepted + refused, mutants);
  EXPECT_GT(accepted, mutants / 100) << "nearly all mutants are refused: the test no longer reaches deep";
  EXPECT_GT(refused, mutants / 2);
}

}  // namespace
}  // namespace lissom
