// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "sound/frame.hpp"

namespace quadrat::sound {

// What sound is played on. One thread.
class Output {
  public:
    virtual ~Output() = default;

    enum class Outcome {
        Played,
        Late,  // played, after a gap: it had run dry
        Gone,  // it takes no sound any more: unplugged, or stuck. It is of no use from here on
    };
    // Takes all of the block. Waits while it has enough, at most about a second.
    virtual Outcome play(Block block) = 0;
    virtual std::string trouble() const = 0;  // why it is gone, or ""
};

// Nothing: it cannot be opened now, and `trouble` says why in one line.
using OpenOutput = std::function<std::unique_ptr<Output>(std::string& trouble)>;

// A card by ALSA's name for it, "default", "plughw:CARD=Headphones". Does not wait for one that others play on.
std::unique_ptr<Output> open_alsa(const std::string& device, std::string& trouble);

// Whether that card is there, without a sound and without taking it from whoever plays on it. "": it is, else why not.
std::string trouble_with_alsa(const std::string& device);

}  // namespace quadrat::sound
