// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "display/kms/card.hpp"

namespace quadrat::display {

struct NoCard {
    std::string reason;  // one line, with the remedy where one is known
};
struct NoScreen {
    std::size_t card = 0;  // the one to keep open and to ask again
    std::string reason;
};
struct ChosenConnector {
    std::size_t card = 0;
    std::size_t connector = 0;
    std::string warning = {};  // when it is not the named one; empty otherwise
};
using CardChoice = std::variant<NoCard, NoScreen, ChosenConnector>;

// By what a card can do, never by its number: the first with a connected screen, real ones before virtual ones, and a
// screen that has modes before one that has none yet. A named connector is the only one taken, wherever it is;
// a name that no card has, though, is a slip of the pen, and no reason for a dark screen.
CardChoice choose_card(std::span<const Card> cards, std::string_view wanted_connector);

}  // namespace quadrat::display
