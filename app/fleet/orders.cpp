// SPDX-License-Identifier: Apache-2.0
#include "fleet/orders.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/text_file.hpp"

namespace quadrat::fleet {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 5> kKnown{"language", "restart", "standby", "theme", "wake"};

std::string text_of(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

// An identifier may hold letters, digits, _ and -.
std::string id_of(const std::string& name) {
    std::string id = "quadrat_";
    for (const char c : name) {
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
        id += is_plain ? std::string(1, c) : fmt::format("_{:02x}", static_cast<unsigned char>(c));
    }
    return id;
}

}  // namespace

bool OrderPace::may(const std::string& what, Moment now) {
    const auto last = last_.find(what);
    if (last != last_.end() && now - last->second < (what == "restart" ? kBetweenRestarts : kBetween)) return false;
    last_[what] = now;
    return true;
}

std::string trouble_of_order(std::string_view what, std::string_view value) {
    if (std::ranges::find(kKnown, what) == kKnown.end())
        return fmt::format("nobody knows how to do that; there are {}", fmt::join(kKnown, ", "));
    if (value.size() > kLongestOrder) return fmt::format("it has more than {} bytes", kLongestOrder);
    if (std::string trouble = base::trouble_of_encoding(value); !trouble.empty()) return trouble;
    if (std::ranges::any_of(value, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 127; }))
        return "it has control characters";
    if (what == "standby" && value != "on" && value != "off") return "write on or off";
    if ((what == "theme" || what == "language") && value.empty()) return "write which";
    return "";
}

std::string answer_json(const std::string& what, const std::string& value, const std::string& trouble) {
    return text_of({{"set", what.substr(0, kLongestOrder)},
                    {"to", value.substr(0, kLongestOrder)},
                    {"done", trouble.empty()},
                    {"why", trouble}});
}

std::map<std::string, std::string> discovery_of(const std::string& prefix, const std::string& name,
                                                const std::string& version, const Orders* orders) {
    const std::string id = id_of(name), ours = "quadrat/" + name + "/";
    const json device{{"identifiers", json::array({id})},
                      {"name", name},
                      {"manufacturer", "Quadrat"},
                      {"model", "Quadrat"},
                      {"sw_version", version}};
    std::map<std::string, std::string> all;
    const auto add = [&](const char* kind, const char* what, json more) {
        more.update({{"unique_id", fmt::format("{}_{}", id, what)},
                     {"object_id", fmt::format("{}_{}", id, what)},
                     {"device", device},
                     {"availability_topic", ours + "status"},
                     {"payload_available", "online"},
                     {"payload_not_available", "offline"}});
        all[fmt::format("{}/{}/{}/{}/config", prefix, kind, id, what)] = text_of(more);
    };
    add("sensor", "verdict",
        {{"name", "Verdict"},
         {"state_topic", ours + "health"},
         {"value_template", "{{ value_json.verdict }}"},
         {"json_attributes_topic", ours + "health"}});
    add("sensor", "visits",
        {{"name", "Visits since the start"},
         {"state_topic", ours + "health"},
         {"value_template", "{{ value_json.visits }}"},
         {"state_class", "total_increasing"}});
    if (orders == nullptr) return all;
    add("switch", "standby",
        {{"name", "Stand-by"},
         {"command_topic", ours + "set/standby"},
         {"state_topic", ours + "state/standby"},
         {"payload_on", "on"},
         {"payload_off", "off"}});
    add("button", "restart",
        {{"name", "Restart"},
         {"command_topic", ours + "set/restart"},
         {"payload_press", "now"},
         {"device_class", "restart"}});
    for (const auto& [what, called] : {std::pair{"theme", "Theme"}, {"language", "Language"}})
        add("select", what,
            {{"name", called},
             {"command_topic", fmt::format("{}set/{}", ours, what)},
             {"state_topic", fmt::format("{}state/{}", ours, what)},
             {"options", orders->choices(what)}});
    return all;
}

}  // namespace quadrat::fleet
