// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "scene/parameters_fwd.hpp"

namespace quadrat::sound {

// What can be heard of a landscape.
enum class Voice : std::size_t {
    Wind,     // about stone and over open ground
    Leaves,   // broad leaves in it
    Needles,  // needles and grass in it
    Stream,   // water that runs
    Surf,     // water that breaks on a shore
    Rain,
    Thunder,
    Songbirds,
    Gulls,
    Owls,
    Frogs,
    Crickets,
    Cicadas,
    Bells,  // of a village
    count
};
inline constexpr std::size_t kVoices = static_cast<std::size_t>(Voice::count);
std::string_view name_of(Voice voice);

// How much of each, 0 none to 1.
class Surroundings {
  public:
    float operator[](Voice voice) const { return shares_[static_cast<std::size_t>(voice)]; }
    void set(Voice voice, float share);  // clamped
    friend bool operator==(const Surroundings&, const Surroundings&) = default;

  private:
    std::array<float, kVoices> shares_{};
};

// From its genes: by the hour, the weather, what grows, how near water is and whether people live there.
Surroundings surroundings_of(const scene::SceneParameters& parameters);

// The mean of some; silence for none.
Surroundings blend(std::span<const Surroundings> several);

// From one to the other, share 0 to 1.
Surroundings between(const Surroundings& from, const Surroundings& to, float share);

}  // namespace quadrat::sound
