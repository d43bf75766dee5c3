// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "base/worker.hpp"
#include "genome/speech.hpp"
#include "nursery/gallery.hpp"

namespace quadrat::nursery {

// A gallery on a screen of its own: all of a collection hangs there in turn, and nobody breeds. What hangs is read anew
// now and then, beside the frames.
class Wall {
  public:
    // What is to hang, in its order; called on another thread, where it may wait for a disk. Must not throw.
    using Read = std::function<std::vector<Work>()>;
    static constexpr std::chrono::seconds kReadEvery{60};

    explicit Wall(Read read) : read_(std::move(read)) {}

    // Once a frame.
    void look(Gallery& gallery, base::Instant now);
    // Of the one that is shown: its words, "" where there are none; and its code after an address, "" without one.
    std::string caption(const genome::Language& language) const;
    std::string address(const std::string& url) const;

  private:
    Read read_;
    std::vector<Work> works_;
    std::optional<genome::Recipe> shown_;
    std::optional<base::Instant> read_at_, opened_at_;
    base::Worker reader_{{.name = "wall"}};
    base::Begun<std::vector<Work>> reading_;
};

}  // namespace quadrat::nursery
