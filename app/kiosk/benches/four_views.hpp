// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kiosk/benches/benches.hpp"
#include "kiosk/easel.hpp"
#include "kiosk/growing.hpp"

namespace quadrat::kiosk::benches {

// Four scenes by chance, each in its quarter.
struct FourViews {
    explicit FourViews(const Options& options, std::uint64_t seed = 11);

    void look(float seconds);  // where their flights are then
    // A frame as it is drawn now. Waits for the GPU.
    render::Drawn draw();
    // Other scenes.
    void grow(std::uint64_t seed);

    Easel easel;
    Scenes scenes;
    render::Frame picture;

  private:
    void keep_within(const Options& options);
};

}  // namespace quadrat::kiosk::benches
