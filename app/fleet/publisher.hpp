// SPDX-License-Identifier: Apache-2.0
// The room `fleet`: how exhibits tell a broker of themselves. It reads what the others keep, and nothing reads it.
#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "archive/outbox.hpp"
#include "fleet/exchange.hpp"
#include "fleet/house_control.hpp"
#include "fleet/link.hpp"
#include "site/configuration.hpp"

namespace quadrat::fleet {

struct PublisherOptions {
    std::chrono::milliseconds quiet{500};  // that look() waits at most
    std::string version;                   // of the program
    std::optional<Orders> orders;          // what it takes; none where the settings want none
    Sharing sharing{};                     // of favourites, with other exhibits
};

// Tells a broker by MQTT how the exhibit is and what visitors did, in a process of its own: quadrat/NAME/status
// ("online", or "offline" as its last will; retained), …/health (what the exhibit last wrote of itself; retained),
// …/visits (each visit once or, after a lost acknowledgement, twice), …/publisher (who publishes under this name: how
// two exhibits of one name learn of each other, and say so in their logs), and what a HouseControl says and takes. A
// broker that is away is tried again for ever; visits wait in the state file meanwhile.
class Publisher {
  public:
    // Throws InputError where the settings cannot be used.
    Publisher(const site::Configuration::Fleet& settings, std::filesystem::path state,
              const std::filesystem::path& runtime, PublisherOptions options = {});

    // Again and again: keeps the connection, or tries for one, and publishes what is new. Waits for the network;
    // whoever must not wait has a process of its own.
    void look();

  private:
    enum class Word { Arrived, Here };
    void connected();
    void acknowledged(int message);
    void heard(const std::string& at, const std::string& text, bool is_retained);
    void introduce(Word word);
    void meet(const std::string& introduction);
    std::string topic(std::string_view name) const { return "quadrat/" + name_ + "/" + std::string(name); }
    void publish_health();
    void publish_visits();

    std::filesystem::path state_, health_file_;
    std::string name_;
    std::string id_;  // at the broker
    std::filesystem::file_time_type health_at_{};
    std::map<int, std::int64_t> in_flight_;  // of the outbox, by the broker's number
    std::set<std::int64_t> arrived_;
    std::set<std::string> rivals_;  // others of the same name, that were told of
    HouseControl control_;
    Exchange exchange_;
    Link link_;  // last: its events use what is above
};

}  // namespace quadrat::fleet
