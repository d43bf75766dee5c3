// SPDX-License-Identifier: Apache-2.0
#include "fleet/publisher.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "fleet/identity.hpp"

namespace quadrat::fleet {
namespace {

using nlohmann::json;

constexpr int kMostAtOnce = 50;
constexpr std::size_t kLargestHealth = 1U << 20U;
constexpr std::size_t kMostRivals = 20;  // more are no mishap, and need no more lines in the log

std::string host_name() {
    std::array<char, 65> host{};
    ::gethostname(host.data(), host.size() - 1);
    return host.data();
}

std::string own_name(const std::string& named) {
    std::string name = named.empty() ? host_name() : named;
    // These would be other topics, or all of them.
    if (name.empty() || name.find_first_of("/+#") != std::string::npos)
        throw base::InputError(fmt::format("fleet.name is \"{}\"; it must be a word without / + and #", name));
    return name;
}

// What anybody may have sent, for the log: printable, and not long.
std::string word_in(const json& object, const char* key) {
    constexpr std::size_t kLongest = 80;
    const auto found = object.find(key);
    if (found == object.end() || !found->is_string()) return {};
    std::string text = found->get<std::string>().substr(0, kLongest);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c >= '\x7f'; }, '?');
    return text;
}

}  // namespace

Publisher::Publisher(const site::Configuration::Fleet& settings, std::filesystem::path state,
                     const std::filesystem::path& runtime, PublisherOptions options)
    : state_(std::move(state)),
      health_file_(runtime / "health.json"),
      name_(own_name(settings.name)),
      id_(client_id(state_)),
      control_({name_, settings.discovery, std::move(options.version), std::move(options.orders)}),
      exchange_(name_, std::move(options.sharing)),
      link_(settings, {id_, topic("status"), options.quiet},
            {[this] { connected(); }, [this](int message) { acknowledged(message); },
             [this](const std::string& at, const std::string& text, bool is_retained) { heard(at, text, is_retained); },
             // What was not acknowledged is sent again.
             [this] { in_flight_.clear(); }}) {}

void Publisher::connected() {
    link_.publish(topic("status"), "online", true);
    health_at_ = {};
    link_.subscribe(topic("status"));
    link_.subscribe(topic("publisher"));
    control_.connected(link_);
    exchange_.connected(link_);
    introduce(Word::Arrived);
}

void Publisher::heard(const std::string& at, const std::string& text, bool is_retained) {
    if (control_.heard(link_, at, text, is_retained)) return;
    if (exchange_.heard(link_, at, text)) return;
    if (at == topic("publisher")) return meet(text);
    // The last will of another of our name, or our own of before this machine had another card: the broker keeps it.
    if (text == "offline") link_.publish(topic("status"), "online", true);
}

void Publisher::acknowledged(int message) {
    const auto sent = in_flight_.find(message);
    if (sent == in_flight_.end()) return;
    arrived_.insert(sent->second);
    in_flight_.erase(sent);
}

void Publisher::introduce(Word word) {
    const json introduction = {{"id", id_},
                               {"host", host_name()},
                               {"state", state_.string()},
                               {"is", word == Word::Arrived ? "arrived" : "here"}};
    link_.publish(topic("publisher"), introduction.dump(-1, ' ', false, json::error_handler_t::replace), false);
}

// Whoever arrives under our name is answered, so that it learns of us too; an answer is not.
void Publisher::meet(const std::string& text) {
    constexpr std::size_t kLongest = 4096;
    const json introduction = text.size() > kLongest ? json() : json::parse(text, nullptr, false);
    if (!introduction.is_object()) return;
    const std::string id = word_in(introduction, "id");
    if (id.empty() || id == id_) return;
    if (word_in(introduction, "is") == "arrived") introduce(Word::Here);
    if (rivals_.size() >= kMostRivals || !rivals_.insert(id).second) return;
    base::log::warn(
        "fleet: another exhibit publishes under the same name, {}: host {}, state {}; each overwrites what the other "
        "says: give one of them another fleet.name",
        name_, word_in(introduction, "host"), word_in(introduction, "state"));
}

void Publisher::look() {
    if (!link_.look()) return;
    publish_health();
    publish_visits();
    const auto now = OrderPace::Moment::clock::now();
    control_.look(link_, now);
    exchange_.look(link_, now);
}

void Publisher::publish_health() {
    std::error_code error;
    const auto at = std::filesystem::last_write_time(health_file_, error);
    if (error || at == health_at_) return;
    try {
        if (link_.publish(topic("health"), base::read_file(health_file_, kLargestHealth), true) != 0) health_at_ = at;
    } catch (const base::InputError&) {
        return;  // it is being replaced; the next look finds it
    }
}

void Publisher::publish_visits() {
    auto outbox = archive::Outbox::open(state_);
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
        if (const int number = link_.publish(topic(message.topic), message.payload, false); number != 0)
            in_flight_[number] = message.id;
    }
}

}  // namespace quadrat::fleet
