// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <set>

#include "exhibit/outbox.hpp"
#include "kiosk/configuration.hpp"

struct mosquitto;

namespace quadrat::kiosk::fleet {

struct Broker {
    std::string host;
    int port = 0;
    bool is_encrypted = false;
    friend bool operator==(const Broker&, const Broker&) = default;
};
// "mqtts://broker.example:8883", "mqtt://10.0.0.1". Throws InputError: what is wrong and what would be right.
Broker broker_from(const std::string& address);

// Tells a broker by MQTT how the exhibit is and what visitors did, in a process of its own: quadrat/NAME/status
// ("online", or "offline" as its last will; retained), …/health (what the exhibit last wrote of itself; retained),
// …/visits (each visit once or, after a lost acknowledgement, twice). A broker that is away is tried again for ever;
// visits wait in the state file meanwhile.
class Publisher {
  public:
    // Throws InputError where the settings cannot be used.
    Publisher(const Configuration::Fleet& settings, std::filesystem::path state, const std::filesystem::path& runtime);
    ~Publisher();  // says "offline" and goes

    // Again and again: keeps the connection, or tries for one, and publishes what is new. Waits for the network, half a
    // second where all is quiet; whoever must not wait has a process of its own.
    void look();

  private:
    struct Free {
        void operator()(mosquitto* client) const;
    };
    void connect();
    void connected(int result);
    void lose(int result);
    void acknowledged(int message);
    std::string topic(std::string_view name) const { return topics_ + std::string(name); }
    int publish(const std::string& topic, const std::string& payload, bool is_retained);
    void publish_health();
    void publish_visits();

    std::filesystem::path state_, health_file_;
    std::string topics_;  // "quadrat/NAME/"
    std::unique_ptr<mosquitto, Free> client_;
    Broker broker_;
    std::filesystem::file_time_type health_at_{};
    std::chrono::steady_clock::time_point next_try_{};
    std::chrono::seconds patience_{1};
    bool has_socket_ = false;
    bool is_trouble_told_ = false;  // once, until it is connected again
    bool is_connected_ = false;
    bool is_news_ = false;                   // connected, and not yet told how it is
    std::map<int, std::int64_t> in_flight_;  // of the outbox, by the broker's number
    std::set<std::int64_t> arrived_;
};

}  // namespace quadrat::kiosk::fleet
