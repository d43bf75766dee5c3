// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "firmware-io/joined_contacts.hpp"

namespace quadrat::firmware_io {

// Several sources as one stream in order of time. A button that is down on two of them is down once, until both let go.
// Present while any source is; its reason lists those that are absent, separated by "; ".
// Finished when a script has ended and no other source has anything coming.
class MergedButtons final : public ButtonSource {
  public:
    explicit MergedButtons(std::vector<std::unique_ptr<ButtonSource>> sources);

    std::vector<ButtonEdge> poll(Instant now) override;
    SourceStatus status() const override;
    const Contacts& contacts() const override { return joined_.contacts(); }
    void set_lamps(const Lamps& lamps) override;
    void key(char key, Motion motion, Instant at) override;
    std::optional<Instant> next_event_at() const override;
    bool is_finished() const override;

  private:
    std::vector<std::unique_ptr<ButtonSource>> sources_;
    JoinedContacts joined_;
};

}  // namespace quadrat::firmware_io
