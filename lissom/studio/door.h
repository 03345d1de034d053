#pragma once
/// What a server of the studio's page needs to know of the studio: messages in, messages out (docs/studio/protocol.md).

#include <functional>
#include <memory>
#include <string>

namespace lissom {

/// A message on its way to a page.
struct StudioMessage {
  enum class Kind {
    kText,  ///< JSON
    kPack,  ///< binary
  };
  /// Of the messages of one lane that still wait for a slow page only the newest is worth sending.
  enum class Lane {
    kOrdered,  ///< all of them, in order
    kShape,
    kPreview,
  };
  std::shared_ptr<const std::string> bytes;
  Kind kind = Kind::kText;
  Lane lane = Lane::kOrdered;
};

/// All of it may be called from any thread and returns at once.
class StudioDoor {
 public:
  /// Called from threads of the studio, never after disconnect() has returned; must not block.
  using Send = std::function<void(const StudioMessage&)>;

  StudioDoor() = default;
  StudioDoor(const StudioDoor&) = delete;
  StudioDoor& operator=(const StudioDoor&) = delete;
  virtual ~StudioDoor() = default;

  /// A page has come; the number that it is known by.
  virtual int connect(Send send) = 0;
  /// A text message of a page. Whatever is wrong with it is answered to that page.
  virtual void receive(int page, std::string text) = 0;
  virtual void disconnect(int page) = 0;
};

}  // namespace lissom
