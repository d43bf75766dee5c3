// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "fleet/back_off.hpp"
#include "site/broker_address.hpp"
#include "site/configuration.hpp"

struct mosquitto;

namespace quadrat::fleet {

struct LinkOptions {
    std::string client_id;
    std::string will_topic;                // said "offline" there, retained, when the connection ends in whatever way
    std::chrono::milliseconds quiet{500};  // that look() waits at most
};

// What happens on a connection; called from within look().
struct LinkEvents {
    std::function<void()> connected;
    std::function<void(int message)> acknowledged;
    // `is_retained`: it was said before we listened, and the broker kept it.
    std::function<void(const std::string& topic, const std::string& payload, bool is_retained)> heard;
    std::function<void()> lost;
};

// One connection to a broker by MQTT, tried again for ever: each time after twice as long, until one has lasted for
// minutes. The log has why there is none, in words that name the remedy, once for each change of the reason.
class Link {
  public:
    // Throws InputError where the settings cannot be used: address, user, password and certificates are looked at
    // before anything is connected.
    Link(const site::Configuration::Fleet& settings, const LinkOptions& options, LinkEvents events);
    ~Link();  // says "offline" and goes
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;

    // Keeps the connection, or tries for one. Waits for the network, as long as `quiet` says. True: connected.
    bool look();
    // The number that will be acknowledged, or 0.
    int publish(const std::string& topic, const std::string& payload, bool is_retained);
    void subscribe(const std::string& topic);
    void unsubscribe(const std::string& topic);

  private:
    struct Free {
        void operator()(mosquitto* client) const;
    };
    void secure(const site::Configuration::Fleet& settings);
    void listen();
    void connect();
    void connected(int result);
    void noted(int level, const char* text);
    void lose(int result);
    std::string reason_of(int result, int error_number, bool was_connected) const;
    std::string hint_of(int result) const;
    void warn(const std::string& reason);

    LinkEvents events_;
    std::string will_topic_;
    std::chrono::milliseconds quiet_;
    std::unique_ptr<mosquitto, Free> client_;
    site::Broker broker_;
    std::string ca_file_;
    BackOff back_off_;
    BackOff::Moment connected_at_{};
    bool has_socket_ = false;
    bool is_connected_ = false;
    bool is_told_connected_ = false;  // since the last reason that was told
    int cut_short_ = 0;               // connections in a row that the broker ended before they had lasted
    std::string refusal_;             // the broker's, of this attempt
    std::string library_says_;        // its last error of this attempt
    std::string told_;                // the last reason
};

}  // namespace quadrat::fleet
