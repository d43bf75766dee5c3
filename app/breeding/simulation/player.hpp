// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "breeding/session.hpp"
#include "breeding/simulation/visitor.hpp"

namespace quadrat::breeding {

// One way of coming to a landscape, played by a simulated visitor.
class Player {
  public:
    virtual ~Player() = default;
    Player() = default;
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    virtual void play_round(const SimulatedVisitor& visitor, base::RandomStream& chance) = 0;
    virtual genome::ParameterValues taken_home() const = 0;

    // How far the best aspects of the four last shown were, put together; nothing where none are shown.
    virtual std::optional<double> best_shown() const { return std::nullopt; }
};

enum class Method {
    NoPick,        // the average scene
    Random,        // paper 2003, 2.1.1: four by chance, the best so far is kept
    BiasedRandom,  // 2.1.2: by chance within what archetypes span
    Exhaustive,    // 2.1.3: bit strings in order
    Pbil,
    PbilGaussian,
    Belief,
    SlidersSkilled1,  // moves a round; knows which slider is most wrong
    SlidersSkilled3,
    SlidersNovice3,  // sliders in any order
    SlidersNovice10,
    BestArchetype,  // the nearest of those known in each aspect: no one can see that well
    Projection,     // the wish said in words by someone who knows it: as far as words can reach
};
std::vector<Method> all_methods();
std::string_view name_of(Method method);

// What a player may know of the world: the map of the archetypes it knows.
std::unique_ptr<Player> player(Method method, const SimulatedVisitor& visitor, const WordMap& map, base::Seed seed);

}  // namespace quadrat::breeding
