// SPDX-License-Identifier: Apache-2.0
#include "learning/past_visits.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "archive/state_file.hpp"
#include "archive/word_answers.hpp"
#include "base/error.hpp"
#include "breeding/session.hpp"
#include "genome/scene_code.hpp"
#include "learning/school.hpp"

namespace quadrat::learning {
namespace {

// Nothing where the four do not come out as they were.
struct BredAgain {
    breeding::PastVisit rounds;
    breeding::Session session;  // after the last pick
};
std::optional<BredAgain> bred_again(const archive::Generation& last, const breeding::WordMap& map,
                                    const breeding::Taste& taste) {
    breeding::BreederOptions options;
    options.taste = taste;
    options.kind = breeding::breeder_named(last.breeder);
    options.genome = genome::Genome::Full;
    options.map = map;
    breeding::Session session(breeding::Breeder(options), last.seed);
    breeding::PastVisit visit;
    for (const archive::Deed& deed : last.deeds) {
        if (deed.liked.empty()) visit.push_back({session.offer(), deed.pick});
        if (deed.liked.empty())
            session.next(deed.pick);
        else
            session = session.begun_with(genome::candidate_of_code(deed.liked, "deeds"));
    }
    if (archive::digest_of(session.offer()) != last.digest) return std::nullopt;
    visit.push_back({session.offer(), last.answers});
    session.next(last.answers);
    return BredAgain{std::move(visit), std::move(session)};
}

bool is_of_sliders(const archive::Generation& last) {
    return last.breeder == "sliders" ||
           std::ranges::any_of(last.deeds, [](const archive::Deed& deed) { return deed.step.has_value(); });
}

// By the map and taste of now, of before the last lesson, or of a site that has learnt nothing.
class Rearing {
  public:
    explicit Rearing(const std::filesystem::path& folder)
        : words_(site_words(folder)),
          before_(previous_site_words(folder)),
          tastes_{site_taste(folder), previous_site_taste(folder), {}} {}

    std::optional<BredAgain> bred(const archive::Generation& last) const {
        try {
            for (const breeding::Taste& taste : tastes_) {
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
    std::array<breeding::Taste, 3> tastes_;
};

}  // namespace

PastVisits past_visits_in(const std::filesystem::path& folder) {
    const Rearing rearing(folder);
    PastVisits past;
    for (const archive::Generation& last : archive::last_generations_in(folder)) {
        if (is_of_sliders(last)) {
            ++past.by_sliders;
        } else if (auto visit = rearing.bred(last)) {
            past.visits.push_back(std::move(visit->rounds));
        } else {
            ++past.tuned_differently;
        }
    }
    return past;
}

std::vector<EndedVisit> ended_visits_in(const std::filesystem::path& folder, std::int64_t after, std::size_t most) {
    const Rearing rearing(folder);
    std::vector<EndedVisit> ended;
    const auto open = archive::open_visit_in(folder);
    const auto all = archive::last_generations_in(folder);
    for (auto last = all.rbegin(); last != all.rend() && last->visit > after && ended.size() < most; ++last) {
        if (is_of_sliders(*last) || last->breeder == "chance" || last->visit == open) continue;
        const auto visit = rearing.bred(*last);
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
    if (!std::filesystem::exists(folder / archive::kStateFile)) return 0;
    auto all = archive::last_generations_in(folder);
    if (!all.empty() && archive::open_visit_in(folder) == all.back().visit) all.pop_back();
    return all.empty() ? 0 : all.back().visit;
}

}  // namespace quadrat::learning
