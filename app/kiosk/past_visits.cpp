// SPDX-License-Identifier: Apache-2.0
#include "kiosk/past_visits.hpp"

#include <algorithm>
#include <optional>

#include "base/error.hpp"
#include "breeding/session.hpp"
#include "exhibit/state_file.hpp"
#include "exhibit/word_answers.hpp"
#include "kiosk/school.hpp"

namespace quadrat::kiosk {
namespace {

// Nothing where the four do not come out as they were.
struct BredAgain {
    breeding::PastVisit rounds;
    breeding::Session session;  // after the last pick
};
std::optional<BredAgain> bred_again(const exhibit::Generation& last, const breeding::WordMap& map,
                                    const breeding::Taste& taste) {
    breeding::BreederOptions options;
    options.taste = taste;
    options.kind = breeding::breeder_named(last.breeder);
    options.genome = genome::Genome::Full;
    options.map = map;
    breeding::Session session(breeding::Breeder(options), last.seed);
    breeding::PastVisit visit;
    for (const exhibit::Deed& deed : last.deeds) {
        visit.push_back({session.offer(), deed.pick});
        session.next(deed.pick);
    }
    if (exhibit::digest_of(session.offer()) != last.digest) return std::nullopt;
    visit.push_back({session.offer(), last.answers});
    session.next(last.answers);
    return BredAgain{std::move(visit), std::move(session)};
}

bool is_of_sliders(const exhibit::Generation& last) {
    return last.breeder == "sliders" ||
           std::ranges::any_of(last.deeds, [](const exhibit::Deed& deed) { return deed.step.has_value(); });
}

// By the map and taste of now, of before the last lesson, or of a site that has learnt nothing.
class Nursery {
  public:
    explicit Nursery(const std::filesystem::path& folder)
        : words_(site_words(folder)), before_(previous_site_words(folder)), taste_(site_taste(folder)) {}

    std::optional<BredAgain> bred(const exhibit::Generation& last) const {
        try {
            for (const breeding::Taste& taste : {taste_, breeding::Taste{}}) {
                if (auto visit = bred_again(last, words_.map, taste)) return visit;
                if (!before_) continue;
                if (auto visit = bred_again(last, before_->map, taste)) return visit;
            }
        } catch (const base::InputError&) {  // a breeder that this program does not have
        }
        return std::nullopt;
    }

  private:
    SiteWords words_;
    std::optional<SiteWords> before_;
    breeding::Taste taste_;
};

}  // namespace

PastVisits past_visits_in(const std::filesystem::path& folder) {
    const Nursery nursery(folder);
    PastVisits past;
    for (const exhibit::Generation& last : exhibit::last_generations_in(folder)) {
        if (is_of_sliders(last)) {
            ++past.by_sliders;
        } else if (auto visit = nursery.bred(last)) {
            past.visits.push_back(std::move(visit->rounds));
        } else {
            ++past.tuned_differently;
        }
    }
    return past;
}

std::vector<EndedVisit> ended_visits_in(const std::filesystem::path& folder, std::int64_t after, std::size_t most) {
    const Nursery nursery(folder);
    std::vector<EndedVisit> ended;
    const auto all = exhibit::last_generations_in(folder);
    for (auto last = all.rbegin(); last != all.rend() && last->visit > after && ended.size() < most; ++last) {
        if (is_of_sliders(*last)) continue;
        const auto visit = nursery.bred(*last);
        if (!visit) continue;
        EndedVisit& one = ended.emplace_back();
        one.bred = visit->session.favourite();
        for (const breeding::PastRound& round : visit->rounds)
            for (const genome::Aspect aspect : genome::kAspects)
                one.judged[aspect] = one.judged[aspect] || round.pick[aspect].has_value();
    }
    return ended;
}

std::int64_t last_visit_in(const std::filesystem::path& folder) {
    if (!std::filesystem::exists(folder / exhibit::kStateFile)) return 0;
    const auto all = exhibit::last_generations_in(folder);
    return all.empty() ? 0 : all.back().visit;
}

}  // namespace quadrat::kiosk
