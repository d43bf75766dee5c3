// SPDX-License-Identifier: Apache-2.0
#include "fleet/exchange.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"

namespace quadrat::fleet {
namespace {

constexpr std::string_view kBegin = "quadrat/";
constexpr std::string_view kList = "/favourites";
constexpr std::chrono::seconds kShareEvery{60};
constexpr std::chrono::seconds kTakeEvery{60};
constexpr std::chrono::seconds kFirst{2};  // for what the broker holds to have come

// Nobody else is to write in our name; where somebody did, ours takes its place.
std::vector<std::string> pictures_of(const std::string& list) {
    std::vector<std::string> pictures;
    try {
        for (const Favourite& one : favourites_from(list))
            if (!one.picture.empty()) pictures.push_back(one.picture);
    } catch (const base::InputError& error) {
        base::log::debug("fleet: {}", error.what());
    }
    return pictures;
}

}  // namespace

Exchange::Exchange(std::string name, Sharing sharing)
    : name_(std::move(name)), sharing_(std::move(sharing)), guests_(name_) {}

void Exchange::connected(Link& link) {
    told_.clear();
    held_.reset();
    shared_at_.reset();
    connected_at_.reset();
    pictures_told_.clear();
    awaited_.clear();
    // What the broker holds of us may be of another day, when more was shared.
    link.subscribe(sharing_.take ? "quadrat/+/favourites" : list_topic());
}

bool Exchange::heard(Link& link, const std::string& topic, const std::string& payload) {
    if (!topic.starts_with(kBegin)) return false;
    if (topic == list_topic()) {
        held_ = payload;
        return true;
    }
    if (topic.ends_with(kList) && topic.size() > kBegin.size() + kList.size()) {
        if (sharing_.take)
            guests_.hear(topic.substr(kBegin.size(), topic.size() - kBegin.size() - kList.size()), payload);
        return true;
    }
    if (topic.find(std::string(kList) + "/") == std::string::npos) return false;
    take_picture(link, topic, payload);
    return true;
}

void Exchange::look(Link& link, Moment now) {
    if (!connected_at_) connected_at_ = now;
    if (now - *connected_at_ < kFirst) return;
    share(link, now);
    take(link, now);
}

// Its picture goes first, so that whoever reads the list finds it.
Favourite Exchange::told_with_picture(Link& link, const Sharing::Own& one) const {
    if (pictures_told_.contains(one.id)) return {one.code, one.id};
    if (one.picture.empty()) return {one.code, ""};
    try {
        const std::string bytes = base::read_file(one.picture, kLargestPicture);
        if (trouble_of_picture(bytes).empty() && link.publish(list_topic() + "/" + one.id, bytes, true) != 0)
            return {one.code, one.id};
    } catch (const base::InputError& error) {
        base::log::debug("fleet: {}", error.what());
    }
    return {one.code, ""};
}

void Exchange::share(Link& link, Moment now) {
    if (shared_at_ && now - *shared_at_ < kShareEvery) return;
    shared_at_ = now;
    std::vector<Sharing::Own> own = sharing_.own ? sharing_.own() : std::vector<Sharing::Own>{};
    own.resize(std::min(own.size(), kMostShared));
    std::vector<Favourite> favourites;
    std::set<std::string> pictures;
    for (const Sharing::Own& one : own) {
        favourites.push_back(told_with_picture(link, one));
        if (!favourites.back().picture.empty()) pictures.insert(favourites.back().picture);
    }
    const std::string text = favourites.empty() ? "" : to_text(favourites);
    const std::string held = std::exchange(held_, std::nullopt).value_or(told_);
    if (held != text && link.publish(list_topic(), text, true) != 0) told_ = text;
    if (held == text) told_ = text;
    for (const std::string& id : pictures_of(held)) pictures_told_.insert(id);
    for (const std::string& id : pictures_told_)
        if (!pictures.contains(id)) link.publish(list_topic() + "/" + id, "", true);
    pictures_told_ = std::move(pictures);
}

void Exchange::take(Link& link, Moment now) {
    if (!sharing_.take) return;
    has_news_ = guests_.look(now) || has_news_;
    if (!has_news_ || (taken_at_ && now - *taken_at_ < kTakeEvery)) return;
    has_news_ = false;
    taken_at_ = now;
    sharing_.take(guests_.chosen());
    for (const auto& [topic, guest] : awaited_) link.unsubscribe(topic);
    awaited_.clear();
    for (const Guest& guest : guests_.chosen()) {
        if (guest.picture.empty() || sharing_.has_picture(guest)) continue;
        const std::string topic = "quadrat/" + guest.from + "/favourites/" + guest.picture;
        awaited_[topic] = guest;
        link.subscribe(topic);
    }
}

// One is enough: what comes after it at the same place is of no use.
void Exchange::take_picture(Link& link, const std::string& topic, const std::string& payload) {
    const auto awaited = awaited_.find(topic);
    if (awaited == awaited_.end() || payload.empty()) return;
    if (const std::string trouble = trouble_of_picture(payload); trouble.empty())
        sharing_.take_picture(awaited->second, payload);
    else
        base::log::warn("fleet: a picture that {} shares is not taken: {}", awaited->second.from, trouble);
    link.unsubscribe(topic);
    awaited_.erase(awaited);
}

}  // namespace quadrat::fleet
