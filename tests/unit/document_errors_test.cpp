/// Wrong documents, one mistake each, and what is said about them: tests/documents/bad/expected.tsv lists file, code,
/// place, message and hint, separated by tabs.

#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

#include "lissom/core/file_io.h"
#include "lissom/model/document.h"

namespace lissom {
namespace {
namespace fs = std::filesystem;

const fs::path kFolder = "tests/documents/bad";
const char* const kCodes[] = {"file",  "syntax",   "unknown",  "type",       "unit",
                              "range", "geometry", "conflict", "unsupported"};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// Expected line by file name.
std::map<std::string, std::string> expected() {
  std::map<std::string, std::string> lines;
  const Result<std::string> table = read_file(kFolder / "expected.tsv");
  EXPECT_TRUE(table);
  if (!table) return lines;
  for (const std::string& line : split(table.value(), '\n')) {
    if (line.empty()) continue;
    const std::size_t tab = line.find('\t');
    EXPECT_TRUE(lines.emplace(line.substr(0, tab), line.substr(tab + 1)).second) << "listed twice: " << line;
  }
  return lines;
}

TEST(DocumentErrors, EveryWrongDocumentIsExplainedAsExpected) {
  const std::map<std::string, std::string> lines = expected();
  EXPECT_GE(lines.size(), 60u);
  for (const auto& [name, line] : lines) {
    SCOPED_TRACE(name);
    EXPECT_EQ(split(line, '\t').size(), 4u);
    const Result<std::string> text = read_file(kFolder / name);
    ASSERT_TRUE(text);
    const Result<Model> model = read_document(text.value(), kFolder);
    ASSERT_FALSE(model) << "was accepted";
    const Error& error = model.error();
    EXPECT_EQ(std::string(kCodes[static_cast<int>(error.code)]) + '\t' + error.where + '\t' + error.message + '\t' +
                  error.hint,
              line);
  }
}

TEST(DocumentErrors, EveryWrongDocumentIsListed) {
  const std::map<std::string, std::string> lines = expected();
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".lissom") continue;
    EXPECT_TRUE(lines.contains(entry.path().filename().string())) << entry.path();
  }
}

/// Messages are sentences for people: no full stop, a start that is not shouted, no trace of the parser.
TEST(DocumentErrors, MessagesFollowTheStyle) {
  for (const auto& [name, line] : expected()) {
    SCOPED_TRACE(name);
    const std::string message = split(line, '\t').at(2);
    EXPECT_FALSE(message.empty());
    EXPECT_FALSE(message.ends_with('.'));
    EXPECT_FALSE(message[0] >= 'A' && message[0] <= 'Z');
    EXPECT_EQ(message.find("json.exception"), std::string::npos);
    EXPECT_EQ(message.find("nlohmann"), std::string::npos);
  }
}

}  // namespace
}  // namespace lissom
