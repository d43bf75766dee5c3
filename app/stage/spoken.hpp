// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/clock.hpp"
#include "exhibit/visit.hpp"
#include "genome/speech.hpp"
#include "site/configuration.hpp"

namespace quadrat::stage {

// The language of the moment: the site's, or the one that a visitor chose, until their visit ends.
class Spoken {
  public:
    explicit Spoken(const site::Configuration& configuration) { follow(configuration); }

    // What the site has changed; a visitor keeps theirs if it is still offered.
    void follow(const site::Configuration& configuration);
    int offered() const { return static_cast<int>(offered_.size()); }

    void choose(int which);
    void resume(const std::string& code);  // after a plug was pulled; of no effect for one that is not offered
    void end_visit() { now_ = own_; }

    const std::string& code() const { return now_; }
    // A prompt, by its key, in the site's own words where it has some.
    std::string said(const std::string& key) const { return site::text(texts_, key, now_); }
    const genome::Language& language() const { return genome::language(now_); }
    // What the screen speaks: while nobody is there, or is asked which, one of those that are offered after the other.
    const std::string& shown(exhibit::Screen screen, base::Instant now) const;
    // In each language's own name, on the buttons.
    std::array<std::string, 4> labels(int first_language) const;
    std::array<std::string, 4> codes(int first_language) const;  // of those; "" for none

  private:
    site::Configuration texts_;  // the site's, and nothing else of it
    std::string own_;
    std::string now_;
    std::vector<std::string> offered_;
};

}  // namespace quadrat::stage
