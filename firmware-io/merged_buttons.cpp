// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/merged_buttons.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::firmware_io {

MergedButtons::MergedButtons(std::vector<std::unique_ptr<ButtonSource>> sources) : sources_{std::move(sources)} {}

std::vector<ButtonEdge> MergedButtons::poll(Instant now) {
    std::vector<ButtonEdge> all;
    std::vector<const Contacts*> contacts;
    for (const auto& source : sources_) {
        const auto edges = source->poll(now);
        all.insert(all.end(), edges.begin(), edges.end());
        contacts.push_back(&source->contacts());
    }
    return joined_.join(std::move(all), contacts);
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
