// SPDX-License-Identifier: Apache-2.0
// J. Ganssle, "A Guide to Debouncing" (2004, rev. 2014): typical trains last below 10 ms with gaps far below that.
#include "firmware-io/debounce.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::firmware_io {

Debouncer::Debouncer(DebounceOptions options) : options_{options}, taken_until_{Instant::min()} {}

void Debouncer::set_raw(std::size_t i, bool is_closed, Instant at) {
    Contact& contact = contacts_[i];
    Charge& charge = charges_[i];
    const Instant elapsed = at - charge.level_at;
    charge.level = contact.is_closed ? std::min(options_.period, charge.level + std::min(elapsed, options_.period))
                                     : std::max(Instant{0}, charge.level - std::min(elapsed, options_.period));
    charge.level_at = at;
    charge.raw_since = at;
    contact.is_closed = is_closed;
    if (is_closed) contact.closed_since = at;
}

void Debouncer::contact(Button button, bool is_closed, Instant at) {
    const std::size_t i = index_of(button);
    if (contacts_[i].is_closed == is_closed) return;
    at = std::max({at, taken_until_, charges_[i].raw_since});
    settle(i, at);
    ++contacts_[i].raw_edges;
    set_raw(i, is_closed, at);
    settle(i, at);
}

void Debouncer::found(Button button, bool is_closed, Instant at) {
    const std::size_t i = index_of(button);
    if (contacts_[i].is_closed == is_closed) return;
    if (!is_closed || contacts_[i].is_down) return contact(button, is_closed, at);
    set_raw(i, true, std::max({at, taken_until_, charges_[i].raw_since}));
    charges_[i].is_armed = false;
}

void Debouncer::lost(Instant at) {
    for (std::size_t i = 0; i < kButtons.size(); ++i) {
        const Instant moment = std::max({at, taken_until_, charges_[i].raw_since});
        settle(i, moment);
        if (contacts_[i].is_down) {
            contacts_[i].is_down = false;
            settled_.push_back({kButtons[i], Motion::Up, moment});
        }
        contacts_[i].is_closed = false;
        charges_[i] = {true, moment, Instant{0}, moment};
    }
}

// The moment when the button's state follows its contact, if the contact stays as it is.
std::optional<Instant> Debouncer::settles_at(std::size_t i) const {
    const Contact& contact = contacts_[i];
    const Charge& charge = charges_[i];
    if (!charge.is_armed) {
        if (contact.is_closed) return std::nullopt;
        return charge.raw_since + options_.period;
    }
    if (contact.is_closed == contact.is_down) return std::nullopt;
    if (options_.form == DebounceForm::Integrator)
        return charge.level_at + (contact.is_closed ? options_.period - charge.level : charge.level);
    return contact.is_closed ? charge.raw_since : charge.raw_since + options_.period;
}

void Debouncer::settle(std::size_t i, Instant until) {
    const auto at = settles_at(i);
    if (!at || *at > until) return;
    Contact& contact = contacts_[i];
    if (!charges_[i].is_armed) {
        charges_[i] = {true, charges_[i].raw_since, Instant{0}, *at};
        return;
    }
    contact.is_down = contact.is_closed;
    if (contact.is_down) contact.down_since = *at;
    settled_.push_back({kButtons[i], contact.is_down ? Motion::Down : Motion::Up, *at});
}

std::vector<ButtonEdge> Debouncer::take(Instant now) {
    for (std::size_t i = 0; i < kButtons.size(); ++i) settle(i, now);
    taken_until_ = std::max(taken_until_, now);
    std::stable_sort(settled_.begin(), settled_.end(),
                     [](const ButtonEdge& a, const ButtonEdge& b) { return a.at < b.at; });
    return std::exchange(settled_, {});
}

std::optional<Instant> Debouncer::next_event_at() const {
    std::optional<Instant> next;
    if (!settled_.empty()) next = settled_.front().at;
    for (std::size_t i = 0; i < kButtons.size(); ++i) {
        const auto at = settles_at(i);
        if (at && (!next || *at < *next)) next = at;
    }
    return next;
}

}  // namespace quadrat::firmware_io
