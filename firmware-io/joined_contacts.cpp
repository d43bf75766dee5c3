// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/joined_contacts.hpp"

#include <algorithm>

namespace quadrat::firmware_io {

bool JoinedContacts::is_news(const ButtonEdge& edge) {
    std::size_t& down_on = down_on_[index_of(edge.button)];
    if (edge.motion == Motion::Down) return down_on++ == 0;
    return --down_on == 0;
}

std::vector<ButtonEdge> JoinedContacts::join(std::vector<ButtonEdge> edges, std::span<const Contacts* const> contacts) {
    std::stable_sort(edges.begin(), edges.end(), [](const ButtonEdge& a, const ButtonEdge& b) { return a.at < b.at; });
    std::erase_if(edges, [&](const ButtonEdge& edge) { return !is_news(edge); });
    for (ButtonEdge& edge : edges) {
        // A stream may learn late of an edge that lies before one that another has already delivered.
        edge.at = last_at_ = std::max(edge.at, last_at_);
        Contact& contact = contacts_[index_of(edge.button)];
        contact.is_down = edge.motion == Motion::Down;
        if (contact.is_down) contact.down_since = edge.at;
    }
    for (std::size_t i = 0; i < kButtons.size(); ++i) {
        Contact& joined = contacts_[i];
        joined.is_closed = false;
        joined.raw_edges = retired_edges_[i];
        for (const Contacts* of : contacts) {
            const Contact& contact = (*of)[i];
            joined.raw_edges += contact.raw_edges;
            if (!contact.is_closed) continue;
            joined.closed_since =
                joined.is_closed ? std::min(joined.closed_since, contact.closed_since) : contact.closed_since;
            joined.is_closed = true;
        }
    }
    return edges;
}

void JoinedContacts::retire(const Contacts& contacts) {
    for (std::size_t i = 0; i < kButtons.size(); ++i) retired_edges_[i] += contacts[i].raw_edges;
}

}  // namespace quadrat::firmware_io
