#pragma once
/// The fields of an edit, read strictly: every edit says what it needs, the first mistake is remembered with its place.

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"
#include "lissom/model/plan.h"

namespace lissom {

/// What is read after a mistake means nothing; ask failed() before it is used.
class EditReader {
 public:
  using Json = nlohmann::json;
  /// `where`: the place of the object; `plan` has the names; the first mistake goes to `status`. All outlive the reader.
  EditReader(const Json& object, std::string where, const Plan& plan, Status& status)
      : json_(&object), where_(std::move(where)), plan_(&plan), status_(&status) {}

  bool failed() const { return !*status_; }
  const Error& error() const { return status_->error(); }
  void fail(ErrorCode code, std::string_view key, std::string message, std::string hint = {});

  /// Refuses every other field.
  void only(std::span<const std::string_view> keys);
  bool has(std::string_view key) const { return json_->contains(std::string(key)); }
  bool is_null(std::string_view key) const { return has(key) && (*json_)[std::string(key)].is_null(); }
  bool is_list(std::string_view key) const { return has(key) && (*json_)[std::string(key)].is_array(); }

  int point(std::string_view key);                                       ///< by name, into Plan::points
  int rod(std::string_view key);                                         ///< into Plan::rods
  std::vector<int> points(std::string_view key, std::size_t least = 1);  ///< different ones
  std::vector<int> rods(std::string_view key, std::size_t least = 1);
  Vec2 place(std::string_view key);       ///< m, from mm
  Vec2 pair(std::string_view key);        ///< two plain numbers
  double length(std::string_view key);    ///< m, from mm
  double angle(std::string_view key);     ///< rad, from degrees
  double number(std::string_view key);    ///< plain
  double positive(std::string_view key);  ///< plain, above zero
  int whole(std::string_view key);        ///< a whole number
  bool flag(std::string_view key);
  std::string text(std::string_view key);
  std::string name(std::string_view key);  ///< text that is not empty
  /// Which of the words it is.
  std::size_t choice(std::string_view key, std::span<const std::string_view> words);
  /// The objects of a list.
  std::vector<EditReader> items(std::string_view key, std::size_t least = 1);
  /// The object there.
  EditReader object(std::string_view key);
  /// The lists of points of a list of lists.
  std::vector<std::vector<int>> point_lists(std::string_view key, std::size_t least, std::size_t most);

  /// The same for what may be left out.
  std::optional<double> optional_length(std::string_view key);
  std::optional<double> optional_angle(std::string_view key);
  std::optional<double> optional_number(std::string_view key);
  std::optional<std::string> optional_name(std::string_view key);

 private:
  const Json* find(std::string_view key);
  std::string at(std::string_view key) const;
  double finite(const Json& value, const std::string& where);
  Vec2 two(std::string_view key, double (EditReader::*read)(const Json&, const std::string&));
  double metres(const Json& value, const std::string& where);
  int named(const Json& value, const std::string& where, const std::vector<std::string>& names, const char* what);
  std::vector<int> list(const Json& value, const std::string& where, const std::vector<std::string>& names,
                        const char* what, std::size_t least, std::size_t most);
  void wrong(const std::string& where, std::string_view expected, const Json& value);
  void fail_at(ErrorCode code, std::string where, std::string message, std::string hint = {});
  std::vector<std::string> point_names() const;
  std::vector<std::string> rod_names() const;

  const Json* json_;
  std::string where_;
  const Plan* plan_;
  Status* status_;
};

}  // namespace lissom
