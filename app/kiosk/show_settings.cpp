// SPDX-License-Identifier: Apache-2.0
#include "kiosk/show_settings.hpp"

#include <cmath>

#include "breeding/sliders.hpp"
#include "genome/scene_code.hpp"

namespace quadrat::kiosk {
namespace {

constexpr int kRoundsThatSuit = 4;  // of fewer nobody wants to miss one

std::chrono::milliseconds milliseconds_of(double seconds) {
    return std::chrono::milliseconds(std::llround(seconds * 1000.0));
}

}  // namespace

exhibit::Timings timings_of(const site::Configuration& configuration) {
    exhibit::Timings timings;
    timings.patience = milliseconds_of(configuration.visit.patience_s);
    timings.countdown = milliseconds_of(configuration.visit.countdown_s);
    timings.finale = milliseconds_of(configuration.visit.finale_s);
    timings.long_press = milliseconds_of(configuration.visit.long_press_s);
    timings.describe = milliseconds_of(configuration.visit.describe_s);
    timings.rounds = configuration.visit.rounds;
    const bool is_classic = configuration.breeding.genome == "classic";
    // The classic genome has no words to speak in.
    timings.describe_words = is_classic ? 0 : configuration.visit.describe_words;
    timings.describe_every = configuration.visit.describe_every;
    if (timings.rounds >= kRoundsThatSuit) {
        timings.rounds_early = configuration.visit.rounds_early;
        timings.rounds_more = configuration.visit.rounds_more;
    }
    timings.turns = exhibit::turns_named(configuration.visit.turns);
    timings.is_wall = configuration.attract.is_wall;
    timings.finale_asks = configuration.visit.shows_family;
    timings.can_print = !configuration.postcard.printer.empty();
    timings.prints_all = configuration.postcard.when == "always";
    timings.can_breed_on = configuration.attract.breeds_on;
    timings.languages = static_cast<int>(configuration.visit.languages.size());
    if (configuration.breeding.breeder == "sliders") {
        timings.asking = exhibit::Asking::Sliders;
        timings.sliders =
            static_cast<int>(breeding::slider_count(is_classic ? genome::Genome::Classic : genome::Genome::Full));
    }
    return timings;
}

std::vector<genome::Aspect> locked_in(const site::Configuration& configuration) {
    std::vector<genome::Aspect> locked;
    for (const std::string& name : configuration.breeding.locked) locked.push_back(genome::aspect_named(name).value());
    return locked;
}

nursery::Chosen chosen_by(const site::Configuration& configuration) {
    nursery::Chosen chosen;
    chosen.shows_year = configuration.attract.has_year;
    // As this program writes it: an older one wrote the same landscape in another code.
    for (const std::string& code : configuration.attract.hidden)
        chosen.hidden.push_back(genome::code_of(genome::recipe_of_code(code, "attract.hidden")));
    for (const auto* codes : {&configuration.attract.favourites, &configuration.attract.guests})
        for (const std::string& code : *codes)
            chosen.favourites.push_back(genome::recipe_of_code(code, "attract.favourites"));
    return chosen;
}

breeding::BreederOptions breeder_options_of(const site::Configuration& configuration) {
    breeding::BreederOptions options;
    options.kind = breeding::breeder_named(configuration.breeding.breeder);
    options.genome = configuration.breeding.genome == "classic" ? genome::Genome::Classic : genome::Genome::Full;
    for (const auto& [name, ends] : configuration.words)
        options.ranges[static_cast<std::size_t>(genome::word_named(name).value())] = {static_cast<float>(ends[0]),
                                                                                      static_cast<float>(ends[1])};
    options.pbil.learning_rate = configuration.breeding.learning_rate;
    options.pbil.mutation = configuration.breeding.mutation;
    options.pbil.mutation_form = configuration.breeding.mutation_form == "random" ? breeding::MutationForm::Random
                                                                                  : breeding::MutationForm::TowardHalf;
    return options;
}

}  // namespace quadrat::kiosk
