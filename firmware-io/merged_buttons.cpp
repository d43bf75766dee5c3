// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/merged_buttons.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::firmware_io {

MergedButtons::MergedButtons(std::vector<std::unique_ptr<ButtonSource>> sources)
    : sources_{std::move(sources)}, last_at_{Instant::min()} {}

bool MergedButtons::is_news(const ButtonEdge& edge) {
    std::size_t& down_on = down_on_[index_of(edge.button)];
    if (edge.motion == Motion::Down) return down_on++ == 0;
    return --down_on == 0;
}

std::vector<ButtonEdge> MergedButtons::poll(Instant now) {
    std::vector<ButtonEdge> all;
    for (const auto& source : sources_) {
        const auto edges = source->poll(now);
        all.insert(all.end(), edges.begin(), edges.end());
    }
    std::stable_sort(all.begin(), all.end(), [](const ButtonEdge& a, const ButtonEdge& b) { return a.at < b.at; });
    std::erase_if(all, [&](const ButtonEdge& edge) { return !is_news(edge); });
    for (ButtonEdge& edge : all) {
        // A source may learn late of an edge that lies before one that another source has already delivered.
        edge.at = last_at_ = std::max(edge.at, last_at_);
        Contact& contact = contacts_[index_of(edge.button)];
        contact.is_down = edge.motion == Motion::Down;
        if (contact.is_down) contact.down_since = edge.at;
    }
    join_contacts();
    return all;
}

void MergedButtons::join_contacts() {
    for (std::size_t i = 0; i < kButtons.size(); ++i) {
        Contact& joined = contacts_[i];
        joined.is_closed = false;
        joined.raw_edges = 0;
        for (const auto& source : sources_) {
            const Contact& contact = source->contacts()[i];
            joined.raw_edges += contact.raw_edges;
            if (!contact.is_closed) continue;
            joined.closed_since =
                joined.is_closed ? std::min(joined.closed_since, contact.closed_since) : contact.closed_since;
            joined.is_closed = true;
        }
    }
}

SourceStatus MergedButtons::status() const {
    SourceStatus merged{sources_.empty() ? Presence::Present : Presence::Absent, {}};
    std::string present;
    for (const auto& source : sources_) {
        const SourceStatus status = source->status();
        if (status.presence == Presence::Present) merged.presence = Presence::Present;
        std::string& reasons = status.presence == Presence::Present ? present : merged.reason;
        if (!status.reason.empty()) reasons += (reasons.empty() ? "" : "; ") + status.reason;
    }
    if (merged.reason.empty()) merged.reason = present;
    return merged;
}

void MergedButtons::set_lamps(const Lamps& lamps) {
    for (const auto& source : sources_) source->set_lamps(lamps);
}

void MergedButtons::key(char key, Motion motion, Instant at) {
    for (const auto& source : sources_) source->key(key, motion, at);
}

std::optional<Instant> MergedButtons::next_event_at() const {
    std::optional<Instant> next;
    for (const auto& source : sources_) {
        const auto at = source->next_event_at();
        if (at && (!next || *at < *next)) next = at;
    }
    return next;
}

bool MergedButtons::is_finished() const {
    const auto has_ended = [](const auto& source) { return source->is_finished(); };
    return std::any_of(sources_.begin(), sources_.end(), has_ended) && !next_event_at();
}

}  // namespace quadrat::firmware_io
