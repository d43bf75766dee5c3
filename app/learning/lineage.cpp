// SPDX-License-Identifier: Apache-2.0
#include "learning/lineage.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "base/log.hpp"
#include "genome/scene_code.hpp"

namespace quadrat::learning {
namespace {

// Throws InputError saying why not.
Lineage bred_again(const archive::Generation& kept, breeding::Breeder breeder) {
    if (breeder.name() != kept.breeder)
        throw base::InputError(fmt::format("the breeder is {} now, and was {}", breeder.name(), kept.breeder));
    Lineage lineage(breeding::Session(std::move(breeder), kept.seed));
    for (const archive::Deed& deed : kept.deeds) {
        if (!deed.liked.empty())
            lineage.begin_with(deed.liked);
        else if (deed.step)
            lineage.slide(deed.step->slider, deed.step->direction);
        else
            lineage.next(deed.pick);
    }
    if (archive::digest_of(lineage.session().offer()) != kept.digest)
        throw base::InputError("the breeding is tuned differently now, so the four would not be the same");
    return lineage;
}

}  // namespace

breeding::BreederOptions options_of_visit(breeding::BreederOptions options, int control_every, base::Seed session) {
    const bool can_be_compared =
        options.kind == breeding::BreederKind::Belief && options.genome == genome::Genome::Full;
    if (control_every > 0 && can_be_compared &&
        base::RandomStream(session.child("control")).below(static_cast<std::uint32_t>(control_every)) == 0)
        options.kind = breeding::BreederKind::Chance;
    return options;
}

void Lineage::next(const genome::Pick& answers) {
    session_.next(answers);
    deeds_.push_back({answers, std::nullopt});
}

void Lineage::slide(int slider, int direction) {
    if (static_cast<std::size_t>(slider) >= session_.breeder().sliders())
        throw base::InputError(fmt::format("there is no slider {}", slider));
    session_.slide(static_cast<std::size_t>(slider), direction);
    deeds_.push_back({{}, archive::SliderStep{slider, direction}});
}

void Lineage::undo() {
    if (session_.undo() && !deeds_.empty()) deeds_.pop_back();
}

void Lineage::begin_with(const std::string& liked) {
    session_ = session_.begun_with(genome::candidate_of_code(liked, "liked"));
    deeds_ = archive::deeds_of(liked, {});
}

void Lineage::return_to(int node, const std::vector<genome::Pick>& picks) {
    session_.return_to(node);
    deeds_ = archive::deeds_of(liked(), picks);
}

archive::Generation Lineage::generation(const genome::Pick& answers) const {
    archive::Generation generation;
    generation.round = session_.offer().round;
    generation.seed = session_.seed();
    generation.breeder = session_.breeder().name();
    generation.deeds = deeds_;
    generation.digest = archive::digest_of(session_.offer());
    generation.answers = answers;
    return generation;
}

void Founder::follow(const breeding::WordRanges& ranges, std::vector<genome::Aspect> locked) {
    rules_.breeder.ranges = ranges;
    rules_.locked = std::move(locked);
}

void Founder::learn(const School& school) {
    rules_.breeder.map = school.map();
    rules_.breeder.taste = school.taste();
}

breeding::Breeder Founder::breeder_for(base::Seed seed, const std::optional<breeding::WordMap>& map,
                                       const breeding::Taste& taste) const {
    breeding::BreederOptions options = options_of_visit(rules_.breeder, rules_.control_every, seed);
    options.map = map;
    options.taste = taste;
    breeding::Breeder breeder(options);
    for (const genome::Aspect aspect : rules_.locked) breeder.set_lock(aspect, breeding::Lock::Locked);
    return breeder;
}

Lineage Founder::found() {
    const base::Seed seed = seed_.child("visit").child(founded_++);
    return Lineage({breeder_for(seed, rules_.breeder.map, rules_.breeder.taste), seed});
}

std::optional<Lineage> Founder::resume(const archive::Generation& kept, const School& school) const {
    std::string why_not;
    const auto resumed = [&](const breeding::WordMap& map, const breeding::Taste& taste) -> std::optional<Lineage> {
        try {
            return bred_again(kept, breeder_for(kept.seed, map, taste));
        } catch (const base::InputError& error) {
            if (why_not.empty()) why_not = error.what();
            return std::nullopt;
        }
    };
    if (auto lineage = resumed(school.map(), school.taste())) return lineage;
    // The visit may have begun before the last lesson, which changed one of them or both.
    const breeding::Taste taste_before = school.taste_before();
    if (auto lineage = resumed(school.map(), taste_before)) return lineage;
    // It is made anew from what was taught: only where nothing else helps.
    if (const auto map_before = school.map_before()) {
        if (auto lineage = resumed(*map_before, school.taste())) return lineage;
        if (auto lineage = resumed(*map_before, taste_before)) return lineage;
    }
    base::log::warn("the interrupted visit is not taken up: {}", why_not);
    return std::nullopt;
}

}  // namespace quadrat::learning
