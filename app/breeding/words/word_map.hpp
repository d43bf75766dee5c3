// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "breeding/words/atlas.hpp"
#include "breeding/words/basis.hpp"
#include "breeding/words/described_scene.hpp"
#include "genome/parameter_table.hpp"
#include "genome/words.hpp"

namespace quadrat::breeding {

// Something that is said of an aspect and is no word of it: weights·words = value.
struct Direction {
    genome::Aspect aspect = genome::Aspect::Land;
    Point weights;  // one a word of the aspect, in vocabulary order
    double value = 0;
};

// From words to parameters: "Affective scene generation" (Hultquist, Gain & Cairns 2006), section 3, a radial-basis-
// function network a parameter, over the words of the parameter's aspect; with a linear part, radii by density, weights
// by example, and parameters made consistent with one another. Trained from the same scenes in the same order it is the
// same map, bit for bit. A value that is cheap to copy.
class WordMap {
  public:
    // Trains; 0.1 s for 400 scenes. Those trusted fully come back in their own words. Without scenes: the defaults.
    explicit WordMap(std::vector<DescribedScene> scenes);

    // The aspect's parameters for its words; the other aspects' stay as they are in `values`.
    void realise(genome::Aspect aspect, const genome::Description& words, genome::ParameterValues& values) const;
    genome::ParameterValues operator()(const genome::Description& words) const;

    // Words left out take what scenes described with the given ones, and so far along the directions, are expected to
    // be called too.
    genome::Description completed(const genome::PartialDescription& words, std::span<const Direction> along = {}) const;

    // How far off a scene's parameter is when told from all other scenes: root mean square, in ranges. What the words
    // leave open, chance may fill.
    double spread(genome::ParameterId id) const;
    double leave_one_out(genome::Aspect aspect) const;  // the mean of it over the aspect's parameters

    const std::vector<DescribedScene>& scenes() const;

    // What breeders know beside the map: made with it.
    const Atlas& atlas(genome::Aspect aspect) const;

    // Of one training: the same values, not just equal ones.
    friend bool operator==(const WordMap&, const WordMap&) = default;

  private:
    struct Trained;
    std::shared_ptr<const Trained> trained_;
};

// The map of default_scenes(), trained once.
const WordMap& default_word_map();

}  // namespace quadrat::breeding
