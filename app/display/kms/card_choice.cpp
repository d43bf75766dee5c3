// SPDX-License-Identifier: Apache-2.0
#include "display/kms/card_choice.hpp"

#include <fmt/core.h>

#include <optional>

namespace quadrat::display {
namespace {

bool can_show(const Connector& connector) { return connector.use != ConnectorUse::Writeback; }

bool is_usable(const Card& card) {
    bool has_connector = false;
    for (const Connector& connector : card.connectors) has_connector = has_connector || can_show(connector);
    return card.is_atomic && card.problem.empty() && has_connector;
}

// Smaller is better; nothing: not a candidate. Unknown is what some analogue and panel drivers say of a screen they
// cannot feel; with modes it is worth trying when no other is sure.
std::optional<int> rank_of(const Connector& connector) {
    if (!can_show(connector) || connector.plug == Plug::Disconnected || connector.modes.empty()) return std::nullopt;
    const int uncertain = connector.plug == Plug::Unknown ? 2 : 0;
    return uncertain + (connector.use == ConnectorUse::Virtual ? 1 : 0);
}

std::string listed(std::span<const Card> cards) {
    std::string text;
    for (const Card& card : cards)
        for (const Connector& connector : card.connectors)
            if (can_show(connector)) text += (text.empty() ? "" : ", ") + connector.name;
    return text;
}

std::string why_no_card(std::span<const Card> cards) {
    if (cards.empty())
        return "no graphics card in /dev/dri (with Raspberry Pi OS: dtoverlay=vc4-kms-v3d in config.txt)";
    std::string text;
    for (const Card& card : cards) {
        const std::string why = !card.problem.empty()     ? card.problem
                                : card.connectors.empty() ? "has no connectors (it only renders)"
                                : !card.is_atomic         ? "has no atomic modesetting"
                                                          : "has no connector for a screen";
        text += fmt::format("{}{} ({}) {}", text.empty() ? "" : "; ", card.path, card.driver, why);
    }
    return text;
}

std::string why_no_screen(const Card& card) {
    std::string text;
    for (const Connector& connector : card.connectors) {
        if (!can_show(connector)) continue;
        const char* state = connector.plug == Plug::Disconnected ? "has no screen" : "names no modes yet";
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", connector.name, state);
    }
    return text;
}

// Nothing: no card has a connector of that name.
std::optional<CardChoice> choose_named(std::span<const Card> cards, std::string_view wanted) {
    for (std::size_t c = 0; c < cards.size(); ++c) {
        if (!is_usable(cards[c])) continue;
        for (std::size_t i = 0; i < cards[c].connectors.size(); ++i) {
            const Connector& connector = cards[c].connectors[i];
            if (connector.name != wanted || !can_show(connector)) continue;
            if (rank_of(connector)) return ChosenConnector{c, i};
            return NoScreen{c, fmt::format("{} has no screen (it is the configured connector)", wanted)};
        }
    }
    return std::nullopt;
}

CardChoice choose_any(std::span<const Card> cards) {
    std::optional<std::size_t> any_card;
    std::optional<int> best_rank;
    ChosenConnector best;
    for (std::size_t c = 0; c < cards.size(); ++c) {
        if (!is_usable(cards[c])) continue;
        if (!any_card) any_card = c;
        for (std::size_t i = 0; i < cards[c].connectors.size(); ++i) {
            const auto rank = rank_of(cards[c].connectors[i]);
            if (!rank || (best_rank && *best_rank <= *rank)) continue;
            best_rank = rank;
            best = {c, i};
        }
    }
    if (best_rank) return best;
    if (any_card) return NoScreen{*any_card, why_no_screen(cards[*any_card])};
    return NoCard{why_no_card(cards)};
}

}  // namespace

CardChoice choose_card(std::span<const Card> cards, std::string_view wanted_connector) {
    if (wanted_connector.empty()) return choose_any(cards);
    if (auto named = choose_named(cards, wanted_connector)) return *named;
    CardChoice choice = choose_any(cards);
    const std::string why = fmt::format("there is no connector \"{}\"; there are {}", wanted_connector, listed(cards));
    if (auto* chosen = std::get_if<ChosenConnector>(&choice)) chosen->warning = why;
    if (auto* none = std::get_if<NoScreen>(&choice)) none->reason = why;
    return choice;
}

}  // namespace quadrat::display
