// SPDX-License-Identifier: Apache-2.0
#include "desk/sessions.hpp"

#include <algorithm>

#include "desk/passphrase.hpp"

namespace quadrat::desk {
namespace {

constexpr std::size_t kTokenBytes = 32;

}  // namespace

std::string Sessions::begin(Instant now) {
    if (sessions_.size() >= kMost)
        sessions_.erase(
            std::ranges::min_element(sessions_, {}, [](const auto& session) { return session.second.asked; }));
    std::string cookie = hexadecimal(random_(kTokenBytes));
    sessions_[cookie] = {now, now, hexadecimal(random_(kTokenBytes))};
    return cookie;
}

const Sessions::Session* Sessions::find(const std::string& cookie, Instant now) {
    std::erase_if(sessions_, [now](const auto& session) {
        return now - session.second.asked >= kIdle || now - session.second.began >= kLongest;
    });
    const auto found = sessions_.find(cookie);
    if (found == sessions_.end()) return nullptr;
    found->second.asked = now;
    return &found->second;
}

std::optional<Instant> Sessions::wait_of(const std::string& peer, Instant now) {
    while (!failures_.empty() && now - failures_.front().at >= kForgiven) failures_.pop_front();
    const auto of_peer = [&peer](const Failure& failure) { return failure.peer == peer; };
    if (std::ranges::count_if(failures_, of_peer) >= kTries)
        return std::ranges::find_if(failures_, of_peer)->at + kForgiven - now;
    if (failures_.size() >= kTriesOfAll) return failures_.front().at + kForgiven - now;
    return std::nullopt;
}

void Sessions::failed(const std::string& peer, Instant now) { failures_.push_back({peer, now}); }

}  // namespace quadrat::desk
