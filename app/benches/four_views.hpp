// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <memory>

#include "benches/benches.hpp"
#include "nursery/growing.hpp"
#include "stage/easel.hpp"

namespace quadrat::benches {

// Four scenes by chance, each in its quarter.
class FourViews {
    nursery::Landscapes four_;
    std::unique_ptr<nursery::Nursery> growing_;  // begins before what is drawn with, as in the exhibit

  public:
    explicit FourViews(const Options& options, std::uint64_t seed = 11);

    void look(float seconds);  // where their flights are then
    // A frame as it is drawn now. Waits for the GPU.
    render::Drawn draw();
    // Other scenes.
    void grow(std::uint64_t seed);
    void show(const nursery::Scenes& four);

    stage::Easel easel;
    nursery::Scenes scenes;
    render::Frame picture;
    std::chrono::steady_clock::time_point first_seen;  // in their first light, drawn

  private:
    std::unique_ptr<nursery::Nursery> begin(std::uint64_t seed);
    void show_what_grows();
    void bring(const nursery::Scenes& grown);
    void keep_within(const Options& options);
};

}  // namespace quadrat::benches
