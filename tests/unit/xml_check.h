#pragma once
/// A small strict check of markup, for tests of what is written as XHTML.

#include <cctype>
#include <string>
#include <vector>

namespace lissom::samples {

/// What is wrong with the first place that is not well-formed XML: tags that do not match, attributes without quotes or given
/// twice, loose "<", ">" in tags and "&", control characters. Empty: nothing. Comments and CDATA are not expected.
inline std::string xml_fault(const std::string& text) {
  std::vector<std::string> open;
  const auto entity_ok = [&](size_t at) {
    for (const char* known : {"&amp;", "&lt;", "&gt;", "&quot;"}) {
      if (text.compare(at, std::string(known).size(), known) == 0) return true;
    }
    return false;
  };
  const auto fault = [&](const std::string& what, size_t at) { return what + " at: " + text.substr(at, 60); };
  size_t at = 0;
  if (text.rfind("<!DOCTYPE html>", 0) == 0) at = 15;
  bool rooted = false;
  while (at < text.size()) {
    const char c = text[at];
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n') return fault("control character", at);
    if (c == '&' && !entity_ok(at)) return fault("loose &", at);
    if (c != '<') {
      if (open.empty() && std::isspace(static_cast<unsigned char>(c)) == 0)
        return fault("text outside of the root", at);
      ++at;
      continue;
    }
    const size_t start = at++;
    const bool closing = at < text.size() && text[at] == '/';
    if (closing) ++at;
    std::string name;
    while (at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0) name += text[at++];
    if (name.empty()) return fault("loose <", start);
    std::vector<std::string> attributes;
    bool empty = false;
    while (at < text.size() && text[at] != '>') {
      if (text[at] == '/' && at + 1 < text.size() && text[at + 1] == '>') {
        empty = true;
        ++at;
        continue;
      }
      if (text[at] != ' ' || closing) return fault("no space before an attribute", start);
      ++at;
      std::string key;
      while (at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '-')) {
        key += text[at++];
      }
      if (key.empty() || text.compare(at, 2, "=\"") != 0) return fault("attribute without a quoted value", start);
      for (const std::string& known : attributes) {
        if (known == key) return fault("attribute given twice", start);
      }
      attributes.push_back(key);
      for (at += 2; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '<' || (text[at] == '&' && !entity_ok(at))) return fault("loose character in an attribute", at);
      }
      ++at;
    }
    if (at >= text.size()) return fault("tag without end", start);
    ++at;
    if (closing) {
      if (open.empty() || open.back() != name) return fault("tag closes nothing", start);
      open.pop_back();
    } else {
      if (open.empty() && rooted) return fault("second root", start);
      rooted = true;
      if (!empty) open.push_back(name);
    }
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

}  // namespace lissom::samples
