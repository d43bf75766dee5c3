// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "site/settings.hpp"

namespace quadrat::staff {

// What staff are told of the settings.
struct SettingsNews {
    site::SettingsFrom from = site::SettingsFrom::File;
    std::vector<site::Mistake> mistakes;  // of the file, as it is now
    std::string after_restart;            // keys that the file has changed and a running exhibit cannot: "screen.mode"
};

// Follows which settings a running exhibit has, and since when, until they have proved themselves.
class SettingsInUse {
  public:
    using Instant = std::chrono::nanoseconds;
    static constexpr Instant kProof = std::chrono::minutes{1};

    explicit SettingsInUse(site::Settings begun_with);

    // The file has changed, and is followed but for these keys, or is not.
    void follow(std::string toml, std::string after_restart);
    void refuse(std::vector<site::Mistake> mistakes);

    // To be kept as the last that worked, once: when a picture has been on the screen for a minute with all of them in
    // use. `is_shown`: just now.
    std::optional<std::string> take_proved(Instant now, bool is_shown);

    const SettingsNews& news() const { return news_; }
    // Nobody knows better than the defaults what this site wants: people there must see that.
    bool needs_sign() const { return news_.from == site::SettingsFrom::Defaults && !news_.mistakes.empty(); }

  private:
    SettingsNews news_;
    std::string toml_;
    bool is_settled_ = false;  // kept, or nothing that could be
    std::optional<Instant> shown_since_;
};

// What is wrong with the settings and what mends it, a line each, for the service screen; none while nothing is.
std::vector<std::string> lines_for_staff(const SettingsNews& news);

}  // namespace quadrat::staff
