#pragma once
/// A page for tests: talks to a studio in the same process.

#include <chrono>
#include <condition_variable>
#include <cstring>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lissom/studio/studio.h"

namespace lissom::samples {

using Json = nlohmann::json;

/// A pack, taken apart.
struct ReadPack {
  Json header;
  std::string body;

  explicit ReadPack(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "LSM1");
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 4, 4);
    EXPECT_EQ(length % 4, 0u);
    header = Json::parse(bytes.substr(8, length));
    body = bytes.substr(8 + length);
  }
  std::string kind() const { return header["pack"]; }
  std::vector<float> floats(const std::string& name) const {
    std::size_t at = 0;
    for (const Json& array : header["arrays"]) {
      const std::size_t count = array["shape"][0].get<std::size_t>() * array["shape"][1].get<std::size_t>();
      if (array["name"] == name) {
        std::vector<float> values(count);
        std::memcpy(values.data(), body.data() + at, 4 * count);
        return values;
      }
      at += 4 * count;
    }
    ADD_FAILURE() << "no array " << name;
    return {};
  }
};

class StudioPage {
 public:
  explicit StudioPage(StudioDoor& door) : door_(door) {
    number_ = door.connect([this](const StudioMessage& message) { take(message); });
  }
  ~StudioPage() { door_.disconnect(number_); }
  StudioPage(const StudioPage&) = delete;
  StudioPage& operator=(const StudioPage&) = delete;

  /// Sends without waiting; the id.
  int send(Json body) {
    body["id"] = ++last_id_;
    door_.receive(number_, body.dump());
    return last_id_;
  }
  void send_raw(const std::string& text) { door_.receive(number_, text); }

  Json answer_to(int id, std::chrono::seconds patience = std::chrono::seconds(60)) {
    Json found;
    wait(
        [&] {
          for (const Json& text : texts_) {
            if (text.contains("id") && text["id"] == id) {
              found = text;
              return true;
            }
          }
          return false;
        },
        patience);
    return found;
  }
  Json ask(Json body) { return answer_to(send(std::move(body))); }
  /// The same, and it has to go well.
  Json good(Json body) {
    Json answer = ask(std::move(body));
    EXPECT_TRUE(answer.value("ok", false)) << answer.dump();
    return answer;
  }
  std::string refused(Json body) {
    const Json answer = ask(std::move(body));
    EXPECT_FALSE(answer.value("ok", true)) << answer.dump();
    if (!answer.contains("error")) return {};
    EXPECT_FALSE(answer["error"]["message"].get<std::string>().empty());
    return answer["error"]["message"];
  }

  /// The last event of a kind that passes; waits for one.
  Json event(
      const std::string& kind, const std::function<bool(const Json&)>& passes = [](const Json&) { return true; }) {
    Json found;
    wait([&] {
      for (auto text = texts_.rbegin(); text != texts_.rend(); ++text) {
        if (!text->contains("event") || (*text)["event"] != kind || !passes(*text)) continue;
        found = *text;
        return true;
      }
      return false;
    });
    return found;
  }
  ReadPack pack(
      const std::string& kind,
      const std::function<bool(const ReadPack&)>& passes = [](const ReadPack&) { return true; }) {
    std::string found;
    wait([&] {
      for (auto bytes = packs_.rbegin(); bytes != packs_.rend(); ++bytes) {
        const ReadPack pack(*bytes);
        if (pack.kind() != kind || !passes(pack)) continue;
        found = *bytes;
        return true;
      }
      return false;
    });
    return ReadPack(found);
  }
  Json job_end(const std::string& name) {
    return event("job", [&](const Json& job) { return job["job"] == name && job["state"] != "running"; });
  }
  void forget() {
    const std::scoped_lock lock(in_use_);
    texts_.clear();
    packs_.clear();
  }
  int count(const std::string& kind) {
    const std::scoped_lock lock(in_use_);
    int number = 0;
    for (const std::string& bytes : packs_) number += ReadPack(bytes).kind() == kind;
    return number;
  }

 private:
  void take(const StudioMessage& message) {
    const std::scoped_lock lock(in_use_);
    if (message.kind == StudioMessage::Kind::kText) {
      texts_.push_back(Json::parse(*message.bytes));
    } else {
      packs_.push_back(*message.bytes);
    }
    arrived_.notify_all();
  }
  void wait(const std::function<bool()>& there, std::chrono::seconds patience = std::chrono::seconds(60)) {
    std::unique_lock lock(in_use_);
    const bool came = arrived_.wait_for(lock, patience, there);
    ASSERT_TRUE(came) << "nothing came";
  }

  StudioDoor& door_;
  int number_ = 0, last_id_ = 0;
  std::mutex in_use_;
  std::condition_variable arrived_;
  std::vector<Json> texts_;
  std::vector<std::string> packs_;
};

/// A folder of its own, removed in the end.
class StudioFolder {
 public:
  explicit StudioFolder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() /
              ("lissom-studio-" + name + "-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "-" +
               std::to_string(std::chrono::steady_clock::now().time_since_epoch().count()))) {
    std::filesystem::create_directories(path_);
  }
  ~StudioFolder() { std::filesystem::remove_all(path_); }
  StudioFolder(const StudioFolder&) = delete;
  StudioFolder& operator=(const StudioFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace lissom::samples
