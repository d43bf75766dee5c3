// SPDX-License-Identifier: Apache-2.0
#include "fleet/house_control.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/log.hpp"

namespace quadrat::fleet {

void HouseControl::connected(Link& link) {
    told_.clear();
    looked_at_.reset();
    if (how_.orders) link.subscribe(topic("set/+"));
}

std::string HouseControl::trouble_with(const std::string& what, const std::string& value, OrderPace::Moment now) {
    if (std::string trouble = trouble_of_order(what, value); !trouble.empty()) return trouble;
    if (!pace_.may(what, now)) return "it was asked for just now; ask again later";
    try {
        how_.orders->carry_out(what, value);
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "";
}

bool HouseControl::heard(Link& link, const std::string& at, const std::string& value, bool is_retained) {
    const std::string prefix = topic("set/");
    if (!how_.orders || !at.starts_with(prefix)) return false;
    const std::string what = at.substr(prefix.size());
    // A broker hands a retained one to us at every connection: the exhibit would start anew for ever.
    const std::string trouble = is_retained ? "it is retained by the broker, and would be done again and again; send "
                                              "it without, and an empty one to have the broker forget it"
                                            : trouble_with(what, value, OrderPace::Moment::clock::now());
    const std::string answer = answer_json(what, value, trouble);
    if (!trouble.empty()) base::log::warn("fleet: not done: {}", answer);
    link.publish(topic("answer"), answer, false);
    looked_at_.reset();
    return true;
}

void HouseControl::look(Link& link, OrderPace::Moment now) {
    constexpr std::chrono::seconds kBetween{1};
    if (looked_at_ && now - *looked_at_ < kBetween) return;
    looked_at_ = now;
    std::map<std::string, std::string> all;
    if (how_.orders)
        for (const auto& [what, value] : how_.orders->state()) all[topic("state/" + what)] = value;
    if (!how_.discovery.empty())
        all.merge(discovery_of(how_.discovery, how_.name, how_.version, how_.orders ? &*how_.orders : nullptr));
    for (const auto& [at, value] : all) {
        const auto told = told_.find(at);
        if (told != told_.end() && told->second == value) continue;
        if (link.publish(at, value, true) != 0) told_[at] = value;
    }
}

}  // namespace quadrat::fleet
