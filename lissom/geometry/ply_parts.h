#pragma once
/// Stanford PLY below the meaning of its elements: the header, and the numbers behind it. Text, and binary in both byte
/// orders.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"

namespace lissom {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

/// Bytes of a number in a binary file.
int ply_bytes(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat;
  bool list = false;
  PlyType count_type = PlyType::kUint8;  ///< of a list
};

struct PlyElement {
  std::string name;
  long long count = 0;
  std::vector<PlyProperty> properties;

  /// Number of the first property that has one of these names, or -1.
  int find(std::initializer_list<std::string_view> names) const;
};

enum class PlyForm { kText, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyForm form = PlyForm::kText;
  std::vector<PlyElement> elements;
  long long lines = 0;
};

/// Takes the header off the front of `bytes`.
Result<PlyHeader> read_ply_header(std::string_view& bytes, const std::string& file);

/// The numbers behind a header, one after the other.
class PlyNumbers {
 public:
  PlyNumbers(std::string_view data, PlyForm form, long long line) : data_(data), form_(form), line_(line) {}

  enum class Got { kNumber, kEnd, kWord };
  Got next(PlyType type, double& value) { return form_ == PlyForm::kText ? word(value) : number(type, value); }

  long long line() const { return line_; }  ///< of a text
  std::size_t left() const { return data_.size() + rest_.size(); }
  const std::string& wrong_word() const { return wrong_word_; }  ///< after Got::kWord

 private:
  Got word(double& value);
  Got number(PlyType type, double& value);

  std::string_view data_, rest_;  // what is left behind this line, and of this line
  PlyForm form_;
  long long line_;
  std::string wrong_word_;
};

}  // namespace lissom
