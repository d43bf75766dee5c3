// SPDX-License-Identifier: Apache-2.0
#include "fleet/link.hpp"

#include <fmt/format.h>
#include <mosquitto.h>
#include <netdb.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "base/log.hpp"
#include "fleet/certificates.hpp"
#include "fleet/identity.hpp"

namespace quadrat::fleet {
namespace {

constexpr int kAtMostOnce = 0;
constexpr int kAtLeastOnce = 1;
constexpr int kKeepAlive_s = 30;
// So often ended by the broker soon after they began, connections are not lost by chance.
constexpr int kFewCutShort = 2;

void require(int result, const char* what) {
    if (result != MOSQ_ERR_SUCCESS) throw base::InputError(fmt::format("{}: {}", what, mosquitto_strerror(result)));
}

site::Broker broker_of(const site::Configuration::Fleet& settings) {
    try {
        return site::parse_broker(settings.broker);
    } catch (const std::invalid_argument& error) {
        throw base::InputError(fmt::format("fleet.broker {}", error.what()));
    }
}

}  // namespace

void Link::Free::operator()(mosquitto* client) const { mosquitto_destroy(client); }

Link::Link(const site::Configuration::Fleet& settings, const LinkOptions& options, LinkEvents events)
    : events_(std::move(events)),
      will_topic_(options.will_topic),
      quiet_(options.quiet),
      broker_(broker_of(settings)),
      ca_file_(settings.ca_file) {
    mosquitto_lib_init();
    client_.reset(mosquitto_new(options.client_id.c_str(), true, this));
    if (!client_) throw base::InputError("fleet: no memory for a connection");
    require(mosquitto_will_set(client_.get(), will_topic_.c_str(), 7, "offline", kAtLeastOnce, true), "fleet.name");
    secure(settings);
    listen();
}

Link::~Link() {
    if (std::exchange(is_connected_, false)) {
        publish(will_topic_, "offline", true);
        mosquitto_disconnect(client_.get());
        mosquitto_loop(client_.get(), static_cast<int>(quiet_.count()), 1);
    }
    client_.reset();
    mosquitto_lib_cleanup();
}

void Link::secure(const site::Configuration::Fleet& settings) {
    if (settings.user.empty() && !settings.password_file.empty())
        throw base::InputError(
            "fleet.password_file is named without fleet.user; name the user whose password it holds");
    if (!settings.user.empty()) {
        const std::string password = settings.password_file.empty() ? "" : password_in(settings.password_file);
        require(mosquitto_username_pw_set(client_.get(), settings.user.c_str(),
                                          settings.password_file.empty() ? nullptr : password.c_str()),
                "fleet.user");
    }
    if (!broker_.is_encrypted) {
        if (!ca_file_.empty())
            base::log::warn("fleet: fleet.ca_file is not used, because mqtt:// is not encrypted; write mqtts://");
        return;
    }
    const bool has_file = !ca_file_.empty();
    if (has_file) require_certificates(ca_file_);
    require(mosquitto_tls_set(client_.get(), has_file ? ca_file_.c_str() : nullptr,
                              has_file ? nullptr : "/etc/ssl/certs", nullptr, nullptr, nullptr),
            "fleet.ca_file");
}

void Link::listen() {
    mosquitto_connect_callback_set(
        client_.get(), [](mosquitto*, void* self, int result) { static_cast<Link*>(self)->connected(result); });
    mosquitto_publish_callback_set(client_.get(), [](mosquitto*, void* self, int message) {
        static_cast<Link*>(self)->events_.acknowledged(message);
    });
    mosquitto_message_callback_set(client_.get(), [](mosquitto*, void* self, const mosquitto_message* message) {
        const auto* link = static_cast<Link*>(self);
        const auto length = static_cast<std::size_t>(message->payloadlen);
        // Its own last word comes back to it, and needs no answer.
        if (link->is_connected_)
            link->events_.heard(message->topic, {static_cast<const char*>(message->payload), length}, message->retain);
    });
    mosquitto_log_callback_set(client_.get(), [](mosquitto*, void* self, int level, const char* text) {
        static_cast<Link*>(self)->noted(level, text);
    });
}

int Link::publish(const std::string& topic, const std::string& payload, bool is_retained) {
    int message = 0;
    const int result = mosquitto_publish(client_.get(), &message, topic.c_str(), static_cast<int>(payload.size()),
                                         payload.data(), kAtLeastOnce, is_retained);
    return result == MOSQ_ERR_SUCCESS ? message : 0;
}

void Link::subscribe(const std::string& topic) {
    mosquitto_subscribe(client_.get(), nullptr, topic.c_str(), kAtMostOnce);
}

void Link::unsubscribe(const std::string& topic) { mosquitto_unsubscribe(client_.get(), nullptr, topic.c_str()); }

bool Link::look() {
    if (!has_socket_) {
        connect();
        return false;
    }
    if (const int result = mosquitto_loop(client_.get(), static_cast<int>(quiet_.count()), 1);
        result != MOSQ_ERR_SUCCESS)
        lose(result);
    if (!is_connected_) return false;
    if (back_off_.stands(connected_at_, BackOff::Moment::clock::now())) {
        cut_short_ = 0;
        told_.clear();
    }
    return true;
}

// libmosquitto's own thread would never try again where the first try was refused.
void Link::connect() {
    const auto now = BackOff::Moment::clock::now();
    if (now < back_off_.next_try()) {
        std::this_thread::sleep_for(std::min<std::chrono::nanoseconds>(back_off_.next_try() - now, quiet_));
        return;
    }
    back_off_.tried(now);
    refusal_.clear();
    library_says_.clear();
    const int result = mosquitto_connect(client_.get(), broker_.host.c_str(), broker_.port, kKeepAlive_s);
    has_socket_ = result == MOSQ_ERR_SUCCESS;
    if (!has_socket_) lose(result);
}

void Link::connected(int result) {
    if (result != 0) {
        refusal_ = fmt::format("it refuses: {}", mosquitto_connack_string(result));
        constexpr int kWrongPassword = 4, kNotAuthorised = 5;
        if (result == kWrongPassword || result == kNotAuthorised)
            refusal_ += "; look at fleet.user and fleet.password_file";
        return;
    }
    is_connected_ = true;
    connected_at_ = BackOff::Moment::clock::now();
    if (!std::exchange(is_told_connected_, true))
        base::log::info("fleet: connected to the broker {}", to_text(broker_));
    events_.connected();
}

void Link::noted(int level, const char* text) {
    if (level != MOSQ_LOG_ERR) return;
    library_says_ = text;
}

void Link::lose(int result) {
    const int error_number = errno;
    const auto now = BackOff::Moment::clock::now();
    const bool was_connected = std::exchange(is_connected_, false);
    has_socket_ = false;
    const bool is_cut_short = was_connected && now - connected_at_ < BackOff::kLasting;
    cut_short_ = is_cut_short ? cut_short_ + 1 : 0;
    if (was_connected) back_off_.lost(now);
    std::string reason = reason_of(result, error_number, was_connected);
    if (was_connected) reason = "lost: " + reason;
    if (cut_short_ >= kFewCutShort)
        reason =
            "the broker lets us in and soon ends the connection: does another `quadrat publish` run on this state "
            "folder, or on a copy of this machine with the same name?";
    warn(reason + (was_connected ? "" : hint_of(result)));
    events_.lost();
}

std::string Link::reason_of(int result, int error_number, bool was_connected) const {
    if (!refusal_.empty()) return refusal_;
    if (result == MOSQ_ERR_EAI) return fmt::format("its name is not found: {}", ::gai_strerror(error_number));
    // By EPROTO libmosquitto means that OpenSSL failed, whose reason is in its log.
    const bool is_of_tls = broker_.is_encrypted && error_number == EPROTO;
    if (result == MOSQ_ERR_ERRNO && !is_of_tls) return std::strerror(error_number);
    if (broker_.is_encrypted && !was_connected)
        if (std::string trouble = tls_trouble(broker_, ca_file_); !trouble.empty()) return trouble;
    return library_says_.empty() ? mosquitto_strerror(result)
                                 : fmt::format("{} {}", mosquitto_strerror(result), library_says_);
}

// A broker that wants a certificate of each client says so only when the handshake is over. Whoever hears no MQTT, or
// MQTT in the clear where it wants it encrypted, hangs up.
std::string Link::hint_of(int result) const {
    if (library_says_.find("certificate required") != std::string::npos)
        return "; an exhibit has no certificate of its own: let the broker ask for a user and a password instead";
    const bool has_hung_up =
        result == MOSQ_ERR_CONN_LOST || result == MOSQ_ERR_PROTOCOL || result == MOSQ_ERR_MALFORMED_PACKET;
    if (broker_.is_encrypted || !has_hung_up || !refusal_.empty()) return {};
    return "; where it wants encryption, write mqtts:// in fleet.broker";
}

void Link::warn(const std::string& reason) {
    if (reason == told_) return;
    told_ = reason;
    is_told_connected_ = false;
    base::log::warn("fleet: no connection to {} ({}); it is tried again", to_text(broker_), reason);
}

}  // namespace quadrat::fleet
