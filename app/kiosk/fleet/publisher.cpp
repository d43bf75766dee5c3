// SPDX-License-Identifier: Apache-2.0
#include "kiosk/fleet/publisher.hpp"

#include <fmt/format.h>
#include <mosquitto.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text_file.hpp"

namespace quadrat::kiosk::fleet {
namespace {

constexpr int kAtLeastOnce = 1;
constexpr int kKeepAlive_s = 30;
constexpr int kQuiet_ms = 500;
constexpr std::chrono::seconds kLongestPatience{60};
constexpr int kMostAtOnce = 50;
constexpr std::size_t kLargestHealth = 1U << 20U;

std::string own_name(const std::string& named) {
    std::array<char, 65> host{};
    if (named.empty()) ::gethostname(host.data(), host.size() - 1);
    std::string name = named.empty() ? host.data() : named;
    // These would be other topics, or all of them.
    if (name.empty() || name.find_first_of("/+#") != std::string::npos)
        throw base::InputError(fmt::format("fleet.name is \"{}\"; it must be a word without / + and #", name));
    return name;
}

std::string first_line(const std::string& file) {
    const std::string text = base::read_text(file, {1U << 12U, 1U << 12U});
    return text.substr(0, text.find('\n'));
}

void require(int result, const char* what) {
    if (result != MOSQ_ERR_SUCCESS) throw base::InputError(fmt::format("{}: {}", what, mosquitto_strerror(result)));
}

}  // namespace

Broker broker_from(const std::string& address) {
    const auto refuse = [&]() -> base::InputError {
        return base::InputError(
            fmt::format("fleet.broker is \"{}\"; write mqtts://HOST:PORT, or mqtt://HOST:PORT", address));
    };
    Broker broker;
    std::string rest;
    if (address.starts_with("mqtts://")) {
        broker = {"", 8883, true};
        rest = address.substr(8);
    } else if (address.starts_with("mqtt://")) {
        broker = {"", 1883, false};
        rest = address.substr(7);
    } else {
        throw refuse();
    }
    const std::size_t colon = rest.rfind(':');
    broker.host = rest.substr(0, colon);
    if (colon != std::string::npos) {
        const std::string port = rest.substr(colon + 1);
        const bool is_number =
            !port.empty() && port.size() <= 5 && port.find_first_not_of("0123456789") == std::string::npos;
        broker.port = is_number ? std::stoi(port) : 0;
    }
    if (broker.host.empty() || broker.port < 1 || broker.port > 65535) throw refuse();
    return broker;
}

void Publisher::Free::operator()(mosquitto* client) const { mosquitto_destroy(client); }

Publisher::Publisher(const Configuration::Fleet& settings, std::filesystem::path state,
                     const std::filesystem::path& runtime)
    : state_(std::move(state)),
      health_file_(runtime / "health.json"),
      topics_("quadrat/" + own_name(settings.name) + "/"),
      broker_(broker_from(settings.broker)) {
    mosquitto_lib_init();
    client_.reset(mosquitto_new(("quadrat-" + own_name(settings.name)).c_str(), true, this));
    if (!client_) throw base::InputError("fleet: no memory for a connection");
    require(mosquitto_will_set(client_.get(), topic("status").c_str(), 7, "offline", kAtLeastOnce, true), "fleet.name");
    if (!settings.user.empty()) {
        const std::string password = settings.password_file.empty() ? "" : first_line(settings.password_file);
        require(mosquitto_username_pw_set(client_.get(), settings.user.c_str(), password.c_str()), "fleet.user");
    }
    if (broker_.is_encrypted) {
        const bool has_file = !settings.ca_file.empty();
        require(mosquitto_tls_set(client_.get(), has_file ? settings.ca_file.c_str() : nullptr,
                                  has_file ? nullptr : "/etc/ssl/certs", nullptr, nullptr, nullptr),
                "fleet.ca_file");
    }
    mosquitto_connect_callback_set(
        client_.get(), [](mosquitto*, void* self, int result) { static_cast<Publisher*>(self)->connected(result); });
    mosquitto_publish_callback_set(client_.get(), [](mosquitto*, void* self, int message) {
        static_cast<Publisher*>(self)->acknowledged(message);
    });
}

Publisher::~Publisher() {
    if (is_connected_) {
        publish(topic("status"), "offline", true);
        mosquitto_disconnect(client_.get());
        mosquitto_loop(client_.get(), kQuiet_ms, 1);
    }
    client_.reset();
    mosquitto_lib_cleanup();
}

// libmosquitto's own thread would never try again where the first try was refused.
void Publisher::connect() {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_try_) {
        std::this_thread::sleep_for(
            std::min<std::chrono::nanoseconds>(next_try_ - now, std::chrono::milliseconds{kQuiet_ms}));
        return;
    }
    next_try_ = now + patience_;
    patience_ = std::min(2 * patience_, kLongestPatience);
    const int result = mosquitto_connect(client_.get(), broker_.host.c_str(), broker_.port, kKeepAlive_s);
    has_socket_ = result == MOSQ_ERR_SUCCESS;
    if (!has_socket_) lose(result);
}

void Publisher::connected(int result) {
    is_connected_ = is_news_ = result == 0;
    if (is_connected_) {
        patience_ = std::chrono::seconds{1};
        is_trouble_told_ = false;
        base::log::info("fleet: connected to the broker");
    } else if (!std::exchange(is_trouble_told_, true)) {
        base::log::warn("fleet: the broker refuses: {}", mosquitto_connack_string(result));
    }
}

void Publisher::lose(int result) {
    const std::string why = result == MOSQ_ERR_ERRNO ? std::strerror(errno) : mosquitto_strerror(result);
    if (!std::exchange(is_trouble_told_, true))
        base::log::warn("fleet: no connection to {}:{} ({}); it is tried again", broker_.host, broker_.port, why);
    is_connected_ = has_socket_ = false;
    in_flight_.clear();  // what was not acknowledged is sent again
}

void Publisher::acknowledged(int message) {
    const auto sent = in_flight_.find(message);
    if (sent == in_flight_.end()) return;
    arrived_.insert(sent->second);
    in_flight_.erase(sent);
}

int Publisher::publish(const std::string& to, const std::string& payload, bool is_retained) {
    int message = 0;
    const int result = mosquitto_publish(client_.get(), &message, to.c_str(), static_cast<int>(payload.size()),
                                         payload.data(), kAtLeastOnce, is_retained);
    return result == MOSQ_ERR_SUCCESS ? message : 0;
}

void Publisher::look() {
    if (!has_socket_) return connect();
    if (const int result = mosquitto_loop(client_.get(), kQuiet_ms, 1); result != MOSQ_ERR_SUCCESS) return lose(result);
    if (!is_connected_) return;
    if (std::exchange(is_news_, false)) {
        publish(topic("status"), "online", true);
        health_at_ = {};
    }
    publish_health();
    publish_visits();
}

void Publisher::publish_health() {
    std::error_code error;
    const auto at = std::filesystem::last_write_time(health_file_, error);
    if (error || at == health_at_) return;
    try {
        if (publish(topic("health"), base::read_file(health_file_, kLargestHealth), true) != 0) health_at_ = at;
    } catch (const base::InputError&) {
        return;  // it is being replaced; the next look finds it
    }
}

void Publisher::publish_visits() {
    auto outbox = exhibit::Outbox::open(state_);
    if (!outbox) return;
    const auto waiting = outbox->waiting(kMostAtOnce);
    // In order, so that what is forgotten is all of what came before.
    std::int64_t done = 0;
    for (const auto& message : waiting) {
        if (arrived_.erase(message.id) == 0) break;
        done = message.id;
    }
    if (done > 0) {
        if (const auto trouble = outbox->forget(done)) base::log::warn("fleet: {}", *trouble);
        return;
    }
    for (const auto& message : waiting) {
        const bool is_sent =
            arrived_.contains(message.id) || std::any_of(in_flight_.begin(), in_flight_.end(),
                                                         [&](const auto& sent) { return sent.second == message.id; });
        if (is_sent) continue;
        if (const int number = publish(topic(message.topic), message.payload, false); number != 0)
            in_flight_[number] = message.id;
    }
}

}  // namespace quadrat::kiosk::fleet
