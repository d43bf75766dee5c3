// SPDX-License-Identifier: Apache-2.0
#include "fleet/favourites.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.hpp"
#include "base/log.hpp"
#include "base/seed.hpp"
#include "genome/scene_code.hpp"

namespace quadrat::fleet {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestCode = 2048;
constexpr std::size_t kLongestName = 200;

bool is_picture_name(const std::string& text) {
    return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

// As this program writes it: whatever stands around a code in what was sent goes no further.
std::string code_in(const json& one) {
    const auto code = one.find("code");
    if (code == one.end() || !code->is_string()) throw base::InputError("a landscape has no code");
    const auto& text = code->get_ref<const std::string&>();
    if (text.size() > kLongestCode) throw base::InputError("a code is too long");
    return genome::code_of(genome::recipe_of_code(text, "a landscape"));
}

std::string picture_in(const json& one) {
    const auto picture = one.find("picture");
    if (picture == one.end()) return "";
    if (!picture->is_string() || !is_picture_name(picture->get_ref<const std::string&>()))
        throw base::InputError("a picture's name is not 16 hexadecimal digits");
    return picture->get<std::string>();
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8U | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

}  // namespace

std::string to_text(const std::vector<Favourite>& favourites) {
    json list = json::array();
    for (const Favourite& one : favourites) {
        json row{{"code", one.code}};
        if (!one.picture.empty()) row["picture"] = one.picture;
        list.push_back(std::move(row));
    }
    return json{{"favourites", std::move(list)}}.dump();
}

std::vector<Favourite> favourites_from(std::string_view text) {
    if (text.empty()) return {};
    if (text.size() > kLongestList) throw base::InputError(fmt::format("it has more than {} bytes", kLongestList));
    const json said = json::parse(text, nullptr, false);
    const auto list = said.is_object() ? said.find("favourites") : said.end();
    if (!said.is_object() || list == said.end() || !list->is_array())
        throw base::InputError("it is no list of favourites");
    if (list->size() > kMostShared) throw base::InputError(fmt::format("it has more than {} landscapes", kMostShared));
    std::vector<Favourite> favourites;
    std::set<std::string> seen;
    for (const json& one : *list) {
        if (!one.is_object()) throw base::InputError("a landscape has no code");
        Favourite favourite{code_in(one), picture_in(one)};
        if (seen.insert(favourite.code).second) favourites.push_back(std::move(favourite));
    }
    return favourites;
}

std::string trouble_of_picture(std::string_view bytes) {
    constexpr std::string_view kBegin("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    constexpr std::size_t kHead = 24;
    if (bytes.size() > kLargestPicture) return fmt::format("it has more than {} bytes", kLargestPicture);
    if (bytes.size() < kHead || !bytes.starts_with(kBegin)) return "it is no PNG";
    for (const std::size_t at : {std::size_t{16}, std::size_t{20}})
        if (const std::uint32_t side = number_at(bytes, at); side < 1 || side > kWidestPicture)
            return fmt::format("it is {} pixels wide or high, and may have {}", side, kWidestPicture);
    return "";
}

Guests::Order Guests::order_of(const std::string& sender) const {
    return {base::Seed{}.child(name_).child(sender).value, sender};
}

void Guests::hear(const std::string& sender, std::string_view text) {
    const bool is_name = !sender.empty() && sender.size() <= kLongestName &&
                         std::ranges::none_of(sender, [](unsigned char c) { return c < ' ' || c == 127; });
    if (!is_name || sender == name_) return;
    // One byte too many is kept, so that it is told.
    senders_[order_of(sender)].heard = std::string(text.substr(0, kLongestList + 1));
    if (senders_.size() > kMostSenders) senders_.erase(std::prev(senders_.end()));
}

void Guests::read(const std::string& name, Sender& sender, Moment now) {
    sender.read_at = now;
    const std::string text = *std::exchange(sender.heard, std::nullopt);
    try {
        sender.favourites = favourites_from(text);
        sender.is_told = false;
    } catch (const base::InputError& error) {
        if (std::exchange(sender.is_told, true)) return;
        base::log::warn("fleet: what {} shares is left as it was: {}", name, error.what());
    }
}

bool Guests::look(Moment now) {
    for (auto& [order, sender] : senders_)
        if (sender.heard && (!sender.read_at || now - *sender.read_at >= kBetween)) read(order.second, sender, now);
    std::vector<Guest> chosen = choose();
    if (chosen == chosen_) return false;
    chosen_ = std::move(chosen);
    return true;
}

// The first of each, then the second of each, and so on.
std::vector<Guest> Guests::choose() const {
    std::vector<Guest> all;
    std::set<std::string> seen;
    for (std::size_t turn = 0; turn < kMostShared; ++turn)
        for (const auto& [order, sender] : senders_) {
            if (all.size() == kMost || turn >= sender.favourites.size()) continue;
            const Favourite& one = sender.favourites[turn];
            if (seen.insert(one.code).second) all.push_back({one.code, order.second, one.picture});
        }
    return all;
}

}  // namespace quadrat::fleet
