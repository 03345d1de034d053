#pragma once
/// What was done to a document, step by step, and the document after each step. Steps are shared snapshots, so that going
/// back and forth restores documents to the last byte. As a file, a history is the first document and one JSON patch
/// (RFC 6902) for each step, over the list of the document's lines: patches over its tree would lose the order of points and
/// the last digits of numbers.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/model/model.h"

namespace lissom {

/// The oldest steps are forgotten beyond these.
struct HistoryLimits {
  int steps = 1000;
  std::size_t bytes = std::size_t{64} << 20;  ///< of all documents, as texts
  int models = 50;  ///< kept before and after the present step; the others are read from their texts when needed
};

class History {
 public:
  struct Step {
    std::string title;   ///< "Move point b1-l"
    std::string edit;    ///< JSON of the edit; empty for what is none
    double seconds = 0;  ///< when, since 1970
  };

  /// Begins with a document as opened: step 0.
  explicit History(Model first, HistoryLimits limits = {});

  int at() const { return at_; }  ///< number of steps done
  int size() const { return static_cast<int>(steps_.size()) - 1; }
  bool can_undo() const { return at_ > 0; }
  bool can_redo() const { return at_ < size(); }
  const Step& step(int number) const;  ///< from 1 to size()

  /// The document at hand, and its canonical text (write_document).
  const std::shared_ptr<const Model>& model() const;
  const std::string& text() const;

  /// A new step after the present one; what was undone is cut off. False when the document is the same: then nothing is added.
  bool add(Step step, Model after);
  /// Refused where there is no such step.
  Status undo();
  Status redo();
  Status go_to(int step);

  int saved_at() const { return saved_at_; }  ///< the step whose document is on the disk; -1: none of them
  bool saved() const { return saved_at_ == at_; }
  void mark_saved() { saved_at_ = at_; }

  /// The file `<name>.history.json`.
  std::string write() const;
  /// Reads such a file; it stands at the step where it was written. Files that documents name are looked for in `folder`.
  static Result<History> read(std::string_view json, const std::filesystem::path& folder, HistoryLimits limits = {});
  /// Stands at the newest step that has this document. Where none has, another program has changed it: then it becomes one
  /// more step after all others, "Changed elsewhere", and the answer is false.
  bool meet(Model document, double seconds);

 private:
  struct Entry {
    Step step;
    std::shared_ptr<const std::string> text;
    std::shared_ptr<const Model> model;  ///< null where only the text is kept
    std::string patch;                   ///< RFC 6902, from the lines of the entry before; of the first: empty
  };

  History() = default;
  /// Makes the document of a step, where it is known as a text only.
  Status load(int step);
  void append(Entry entry);
  /// Documents far from the present one are kept as texts alone.
  void forget_far_models();
  void forget_oldest();

  std::vector<Entry> steps_;  ///< the first is the document as opened
  int at_ = 0, saved_at_ = -1;
  std::size_t bytes_ = 0;
  HistoryLimits limits_;
  std::filesystem::path folder_;
};

}  // namespace lissom
