// SPDX-License-Identifier: Apache-2.0
#include "breeding/reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "breeding/session.hpp"
#include "genome/parameter_ids.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::ParameterId;

constexpr double kStill = 0.001;       // of a range
constexpr double kEnough = 0.5;        // of a range
constexpr double kOftenEnough = 0.01;  // of offers

// Countries and patterns of streets lie on a line, so that there is something between them; a visitor sees the nearer
// one.
bool is_kind(const genome::Parameter& p) {
    return p.unit == genome::kChoice || p.id == ParameterId::ground_country || p.id == ParameterId::settle_region ||
           p.id == ParameterId::settle_streets;
}

// A share that reaches below 0 is that of a feature most landscapes do without.
bool is_feature(const genome::Parameter& p) {
    return p.min < 0 &&
           (p.name.ends_with(".share") || p.id == ParameterId::bow_strength || p.id == ParameterId::air_preetham ||
            p.id == ParameterId::settle_age || p.id == ParameterId::hill_hybrid || p.id == ParameterId::hill_hetero ||
            p.id == ParameterId::hill_cells);
}

// Level ground where nobody lives, which bears a ring of stones; with houses on it, it is a settlement's.
constexpr std::string_view kWildSite = "site.share on, wild";

int number_of(float kind) { return static_cast<int>(std::lround(kind)); }

// What there is to be found, in the table's order.
std::vector<KindReach> all_kinds() {
    std::vector<KindReach> kinds;
    for (const genome::Parameter& p : genome::parameter_table()) {
        if (is_feature(p)) kinds.push_back({fmt::format("{} on", p.name)});
        if (p.id == ParameterId::site_share) kinds.push_back({std::string(kWildSite)});
        if (!is_kind(p)) continue;
        for (int kind = number_of(p.min); kind <= number_of(p.max); ++kind)
            kinds.push_back({fmt::format("{} {}{}", p.name, kind, p.id == ParameterId::tree_type ? ", grown" : "")});
    }
    return kinds;
}

void note_kinds(const genome::ParameterValues& values, std::map<std::string, bool>& found) {
    if (values[ParameterId::site_share] > 0 && values[ParameterId::settle_age] < 0)
        found[std::string(kWildSite)] = true;
    for (const genome::Parameter& p : genome::parameter_table()) {
        if (is_feature(p) && values[p.id] > 0) found[fmt::format("{} on", p.name)] = true;
        if (!is_kind(p)) continue;
        const int kind = number_of(values[p.id]);
        if (p.id != ParameterId::tree_type)
            found[fmt::format("{} {}", p.name, kind)] = true;
        else if (number_of(values[ParameterId::tree_habit]) == 0)
            found[fmt::format("{} {}, grown", p.name, kind)] = true;
    }
}

double difference(const genome::ParameterValues& a, const genome::ParameterValues& b, Aspect aspect) {
    double squares = 0;
    const auto ids = parameters_of(aspect, genome::Genome::Full);
    for (const ParameterId id : ids) {
        const genome::Parameter& p = parameter(id);
        const double d = (static_cast<double>(a[id]) - b[id]) / (static_cast<double>(p.max) - p.min);
        squares += d * d;
    }
    return std::sqrt(squares / static_cast<double>(ids.size()));
}

double mean_difference(const genome::Offer& offer) {
    double sum = 0;
    int pairs = 0;
    for (const Aspect aspect : genome::kAspects)
        for (std::size_t i = 0; i < genome::kCandidates; ++i)
            for (std::size_t k = 0; k < i; ++k, ++pairs)
                sum += difference(offer.candidates[i].values, offer.candidates[k].values, aspect);
    return sum / pairs;
}

genome::Pick any_pick(base::RandomStream& chance) {
    genome::Pick pick;
    for (const Aspect aspect : genome::kAspects) pick[aspect] = chance.below(genome::kCandidates);
    return pick;
}

class Search {
  public:
    Search() : kinds_(all_kinds()) {
        for (const genome::Parameter& p : genome::parameter_table()) reach_.parameters.push_back({p.id, p.max, p.min});
    }

    void visit(const BreederOptions& options, std::uint64_t number, int offers) {
        // The visit that `quadrat run --seed number` begins with.
        Session session(Breeder(options), base::Seed{number}.child("visit").child(0U));
        base::RandomStream chance{base::Seed{number}.child("reach")};
        reach_.difference += mean_difference(session.offer());
        ++visits_;
        for (int i = 0; i < offers; ++i) {
            if (i > 0) session.next(any_pick(chance));
            note(session.offer());
        }
    }

    Reach found() {
        reach_.difference /= std::max(visits_, 1);
        reach_.kinds = kinds_;
        for (KindReach& kind : reach_.kinds) kind.offers = times_[kind.name] / std::max(offers_, 1.0);
        return reach_;
    }

  private:
    void note(const genome::Offer& offer) {
        ++offers_;
        std::map<std::string, bool> found;
        for (const genome::Candidate& candidate : offer.candidates) {
            note_kinds(candidate.values, found);
            for (ParameterReach& p : reach_.parameters) {
                p.least = std::min(p.least, candidate.values[p.id]);
                p.most = std::max(p.most, candidate.values[p.id]);
            }
        }
        for (const auto& [name, is_there] : found) ++times_[name];
    }

    Reach reach_;
    std::vector<KindReach> kinds_;
    std::map<std::string, double> times_;
    int visits_ = 0;
    double offers_ = 0;
};

}  // namespace

double ParameterReach::share() const {
    const genome::Parameter& p = parameter(id);
    return std::max(0.0, (static_cast<double>(most) - least) / (static_cast<double>(p.max) - p.min));
}

double Reach::median_share() const {
    std::vector<double> shares;
    for (const ParameterReach& p : parameters) shares.push_back(p.share());
    if (shares.empty()) return 0;
    const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
    std::ranges::nth_element(shares, middle);
    return *middle;
}

double Reach::share_reaching(double share) const {
    const auto count = std::ranges::count_if(parameters, [&](const ParameterReach& p) { return p.share() >= share; });
    return parameters.empty() ? 0 : static_cast<double>(count) / static_cast<double>(parameters.size());
}

std::size_t Reach::still() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(parameters, [](const ParameterReach& p) { return p.share() < kStill; }));
}

Reach reach_of(const BreederOptions& options, const ReachSearch& search) {
    Search found;
    for (int i = 0; i < search.visits; ++i) found.visit(options, static_cast<std::uint64_t>(i) + 1, search.offers);
    return found.found();
}

std::string text_of(const Reach& reach, bool is_all) {
    std::string text;
    for (const ParameterReach& p : reach.parameters)
        if (is_all || p.share() < kEnough)
            text += fmt::format("{:<26} {:>8.3g} to {:<8.3g} {:3.0f} % of its range{}\n", parameter(p.id).name, p.least,
                                p.most, 100 * p.share(), p.share() < kStill ? ": stands still" : "");
    for (const KindReach& kind : reach.kinds)
        if (is_all || kind.offers < kOftenEnough)
            text += fmt::format("{:<26} in {:.1f} % of offers\n", kind.name, 100 * kind.offers);
    const auto rare =
        std::ranges::count_if(reach.kinds, [](const KindReach& kind) { return kind.offers < kOftenEnough; });
    text += fmt::format(
        "{} parameters: {} stand still, {:.0f} % reach half of their range, the median {:.2f}\n"
        "{} kinds: {} in less than 1 % of offers\n"
        "two of a first offer differ by {:.2f} of a range\n",
        reach.parameters.size(), reach.still(), 100 * reach.share_reaching(kEnough), reach.median_share(),
        reach.kinds.size(), rare, reach.difference);
    return text;
}

}  // namespace quadrat::breeding
