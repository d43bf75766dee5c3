// SPDX-License-Identifier: Apache-2.0
#include "archive/deeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/error.hpp"
#include "genome/scene_code.hpp"

namespace quadrat::archive {
namespace {

constexpr char kNone = '-';
constexpr char kLiked = '=';

[[noreturn]] void refuse(std::string_view word) {
    throw base::InputError(fmt::format("\"{}\" is neither three picks nor a turn of a slider", word));
}

Deed pick_from(std::string_view word) {
    Deed deed;
    if (word.size() != genome::kAspects.size()) refuse(word);
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (word[i] == kNone) continue;
        const auto candidate = static_cast<std::size_t>(word[i] - 'A');
        if (candidate >= genome::kCandidates) refuse(word);
        deed.pick[genome::kAspects[i]] = candidate;
    }
    return deed;
}

Deed step_from(std::string_view word) {
    SliderStep step;
    const char* const end = word.data() + word.size();
    const auto [way, error] = std::from_chars(word.data(), end, step.slider);
    if (error != std::errc{} || way + 1 != end || (*way != '+' && *way != '-')) refuse(word);
    step.direction = *way == '+' ? 1 : -1;
    return {{}, step};
}

Deed liking(std::string code) {
    Deed deed;
    deed.pick.each.fill(0);
    deed.liked = std::move(code);
    return deed;
}

Deed liking_from(std::string_view word) {
    const std::string code(word.substr(1));
    genome::recipe_of_code(code, "deeds");  // throws for what is none
    return liking(code);
}

Deed deed_from(std::string_view word) {
    if (word.front() == kLiked) return liking_from(word);
    return word.front() >= '0' && word.front() <= '9' ? step_from(word) : pick_from(word);
}

}  // namespace

std::vector<Deed> deeds_of(const std::string& liked, const std::vector<genome::Pick>& picks) {
    std::vector<Deed> deeds;
    if (!liked.empty()) deeds.push_back(liking(liked));
    for (const genome::Pick& pick : picks) deeds.push_back({pick, std::nullopt});
    return deeds;
}

std::vector<genome::Pick> picks_of(const std::vector<Deed>& deeds) {
    std::vector<genome::Pick> picks;
    for (const Deed& deed : deeds)
        if (deed.liked.empty()) picks.push_back(deed.pick);
    return picks;
}

std::string to_text(const std::vector<Deed>& deeds) {
    std::string text;
    for (const Deed& deed : deeds) {
        if (!text.empty()) text += ' ';
        if (!deed.liked.empty()) {
            text += kLiked + deed.liked;
            continue;
        }
        if (deed.step) {
            text += fmt::format("{}{}", deed.step->slider, deed.step->direction < 0 ? '-' : '+');
            continue;
        }
        for (const genome::Aspect aspect : genome::kAspects)
            text += deed.pick[aspect] ? static_cast<char>('A' + static_cast<char>(*deed.pick[aspect])) : kNone;
    }
    return text;
}

std::vector<Deed> deeds_from(std::string_view text) {
    std::vector<Deed> deeds;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        if (word.empty()) refuse(word);
        deeds.push_back(deed_from(word));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
    }
    return deeds;
}

}  // namespace quadrat::archive
