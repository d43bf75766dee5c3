// SPDX-License-Identifier: Apache-2.0
#include "breeding/simulation/seeing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable_math.hpp"
#include "breeding/belief/coordinates.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::kAspects;

constexpr double kDrift = 0.1;            // of the way to the second wish, each time taste moves
constexpr std::array kDriftRounds{3, 6};  // when it does
constexpr double kChangesMind = 0.2;      // share of visitors, once a visit, in one aspect
constexpr double kBored = 0.02;           // a picture seen before looks so much farther each time, up to
constexpr int kMostBored = 3;
constexpr double kSame = 0.15;  // distance below which a picture is the same again
constexpr double kMeaningless = 0.1;

double apart(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += static_cast<double>(a[i] - b[i]) * static_cast<double>(a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

// Kinds are those of the archetype that the rest is nearest to: nobody wishes for what lies between two.
void settle_kinds(genome::ParameterValues& values, Aspect aspect) {
    const Place at = place_of(values, genome::Genome::Full, aspect);
    const std::vector<DescribedScene>& named = archetypes(aspect);
    const auto nearest = std::ranges::min_element(named, {}, [&](const DescribedScene& scene) {
        return squared_distance(place_of(scene.values, genome::Genome::Full, aspect), at);
    });
    for (const genome::ParameterId id : parameters_of(aspect, genome::Genome::Full))
        if (parameter(id).unit == genome::kChoice) values.set(id, nearest->values[id]);
}

genome::ParameterValues wish_of(const SimulatedVisitor& visitor) {
    genome::ParameterValues values;
    for (const Aspect aspect : kAspects) {
        set_values(values, genome::Genome::Full, aspect, visitor.wish(aspect));
        settle_kinds(values, aspect);
    }
    return values;
}

struct Seeing {
    genome::Candidate canvas;       // what was wished at first
    genome::ParameterValues wish;   // as it is now
    genome::ParameterValues other;  // what taste drifts to, or changes to
    int changes_in_round = 0;       // 0: never
    Aspect changes = Aspect::Trees;
    genome::PerAspect<std::vector<Picture>> seen;
    base::RandomStream chance;
};

Seeing seeing_of(const SeeingWorld& world, int number) {
    Tournament tournament;
    tournament.genome = genome::Genome::Full;
    tournament.noise = world.noise;
    tournament.seed = world.seed;
    const base::Seed seed = world.seed.child("seeing").child(static_cast<std::uint64_t>(number));
    Seeing one{{}, {}, {}, 0, Aspect::Trees, {}, base::RandomStream(seed)};
    one.wish = wish_of(visitor_of(tournament, number));
    one.other = wish_of(visitor_of(tournament, number + 1'000'000));
    one.canvas.values = one.wish;
    for (const Aspect aspect : kAspects) one.canvas.seeds[aspect] = seed.child(name_of(aspect));
    if (one.chance.unit() < kChangesMind) {
        one.changes_in_round = 2 + static_cast<int>(one.chance.below(static_cast<std::uint32_t>(world.rounds)));
        one.changes = kAspects[one.chance.below(kAspects.size())];
    }
    return one;
}

void copy_aspect(const genome::ParameterValues& from, Aspect aspect, genome::ParameterValues& to) {
    for (const genome::ParameterId id : parameters_of(aspect, genome::Genome::Full)) to.set(id, from[id]);
}

void pass_round(Seeing& one, int round) {
    if (round == one.changes_in_round) copy_aspect(one.other, one.changes, one.wish);
    if (std::ranges::find(kDriftRounds, round) == kDriftRounds.end()) return;
    for (const genome::Parameter& p : genome::parameter_table())
        if (p.unit != genome::kChoice)
            one.wish.set(p.id, one.wish[p.id] + static_cast<float>(kDrift) * (one.other[p.id] - one.wish[p.id]));
}

Look look_at(const Seeing& one, std::size_t visitor, Aspect aspect, const genome::ParameterValues& values,
             base::Seed seed) {
    Look look{visitor, aspect, one.canvas};
    copy_aspect(values, aspect, look.in.values);
    look.in.seeds[aspect] = seed;
    return look;
}

// Four by chance within what the known archetypes span.
genome::Offer by_chance(base::Seed seed, int round) {
    genome::Offer offer;
    offer.round = round;
    for (std::size_t c = 0; c < genome::kCandidates; ++c) {
        base::RandomStream chance{seed.child("biased").child(round).child(c)};
        genome::Candidate& candidate = offer.candidates[c];
        for (const Aspect aspect : kAspects) {
            const auto named = named_places(known_half().scenes(), genome::Genome::Full, aspect);
            Place place(named.front().size());
            for (std::size_t i = 0; i < place.size(); ++i) {
                const auto [low, high] = std::ranges::minmax(named, {}, [&](const Place& one) { return one[i]; });
                place[i] = low[i] + (high[i] - low[i]) * chance.unit();
            }
            set_values(candidate.values, genome::Genome::Full, aspect, place);
            candidate.seeds[aspect] = seed.child(name_of(aspect)).child(round).child(c);
        }
    }
    return offer;
}

// The pictures of one round: of each visitor and aspect the wish, then the four.
std::vector<Picture> pictures_of(const std::vector<Seeing>& visitors, const std::vector<genome::Offer>& offers,
                                 const Eyes& eyes) {
    std::vector<Look> looks;
    for (std::size_t v = 0; v < visitors.size(); ++v)
        for (const Aspect aspect : kAspects) {
            looks.push_back(look_at(visitors[v], v, aspect, visitors[v].wish, visitors[v].canvas.seeds[aspect]));
            for (const genome::Candidate& candidate : offers[v].candidates)
                looks.push_back(look_at(visitors[v], v, aspect, candidate.values, candidate.seeds[aspect]));
        }
    return eyes(looks);
}

std::size_t picked(Seeing& one, Aspect aspect, std::span<const Picture> four, const std::array<double, 4>& far,
                   double tau, double norm) {
    std::size_t best = 0;
    double least = 0;
    for (std::size_t k = 0; k < four.size(); ++k) {
        const auto before = std::ranges::count_if(
            one.seen[aspect], [&](const Picture& seen) { return apart(seen, four[k]) < kSame * norm; });
        const double bored = kBored * static_cast<double>(std::min<std::ptrdiff_t>(before, kMostBored));
        const double unit = std::max(one.chance.unit(), 1e-300);
        const double looks = far[k] + bored + tau * base::portable_log(-base::portable_log(unit) + 1e-300);
        if (k == 0 || looks < least) {
            least = looks;
            best = k;
        }
    }
    for (const Picture& picture : four) one.seen[aspect].push_back(picture);
    const bool is_meaningless = one.chance.unit() < kMeaningless;
    const auto any = one.chance.below(genome::kCandidates);
    return is_meaningless ? any : best;
}

struct Judged {
    std::vector<genome::Pick> picks;
    SeenRound round;
};

constexpr std::size_t kLooksAnAspect = 1 + genome::kCandidates;

// How far four by chance are from the wishes, an aspect: what distances are told in.
genome::PerAspect<double> norms_of(std::span<const Picture> pictures, std::size_t visitors) {
    genome::PerAspect<double> norms{};
    std::size_t at = 0;
    for (std::size_t v = 0; v < visitors; ++v)
        for (const Aspect aspect : kAspects) {
            for (std::size_t k = 1; k < kLooksAnAspect; ++k)
                norms[aspect] +=
                    apart(pictures[at], pictures[at + k]) / static_cast<double>(visitors * genome::kCandidates);
            at += kLooksAnAspect;
        }
    return norms;
}

Judged judge(std::vector<Seeing>& visitors, const std::vector<Picture>& pictures,
             const genome::PerAspect<double>& norms, double tau) {
    Judged judged{std::vector<genome::Pick>(visitors.size()), {}};
    std::vector<double> nearest;
    std::size_t at = 0;
    for (std::size_t v = 0; v < visitors.size(); ++v) {
        double squares = 0;
        for (const Aspect aspect : kAspects) {
            const std::span<const Picture> four(pictures.data() + at + 1, genome::kCandidates);
            std::array<double, genome::kCandidates> far{};
            for (std::size_t k = 0; k < four.size(); ++k) far[k] = apart(pictures[at], four[k]) / norms[aspect];
            for (std::size_t a = 0; a < four.size(); ++a)
                for (std::size_t b = 0; b < a; ++b)
                    judged.round.apart += apart(four[a], four[b]) / norms[aspect] /
                                          static_cast<double>(6 * kAspects.size() * visitors.size());
            const double least = *std::ranges::min_element(far);
            squares += least * least / static_cast<double>(kAspects.size());
            judged.picks[v][aspect] = picked(visitors[v], aspect, four, far, tau, norms[aspect]);
            at += kLooksAnAspect;
        }
        nearest.push_back(std::sqrt(squares));
    }
    judged.round.nearest = mean_of(nearest);
    return judged;
}

std::vector<Seeing> all_visitors(const SeeingWorld& world) {
    std::vector<Seeing> visitors;
    for (int v = 0; v < world.visitors; ++v) visitors.push_back(seeing_of(world, v));
    return visitors;
}

std::vector<Session> sessions_of(const SeeingWorld& world) {
    BreederOptions options;
    options.kind = BreederKind::Belief;
    options.genome = genome::Genome::Full;
    options.map = known_half();
    std::vector<Session> sessions;
    for (int v = 0; v < world.visitors; ++v)
        sessions.emplace_back(Breeder(options), world.seed.child("session").child(static_cast<std::uint64_t>(v)));
    return sessions;
}

}  // namespace

SeenWorld play_seeing(const SeeingWorld& world, const Eyes& eyes) {
    const double tau = tau_of(world.noise);
    SeenWorld seen;
    std::vector<Seeing> by_random = all_visitors(world);
    genome::PerAspect<double> norms{};
    // Four by chance are as near in every round: two rounds tell it, the second with wishes that moved.
    for (int round = 1; round <= std::min(2, world.rounds); ++round) {
        std::vector<genome::Offer> offers;
        for (std::size_t v = 0; v < by_random.size(); ++v)
            offers.push_back(by_chance(world.seed.child("random").child(v), round));
        const auto pictures = pictures_of(by_random, offers, eyes);
        if (round == 1) norms = norms_of(pictures, by_random.size());
        seen.biased_random.push_back(judge(by_random, pictures, norms, tau).round);
    }
    std::vector<Seeing> visitors = all_visitors(world);
    std::vector<Session> sessions = sessions_of(world);
    for (int round = 1; round <= world.rounds; ++round) {
        std::vector<genome::Offer> offers;
        for (const Session& session : sessions) offers.push_back(session.offer());
        for (Seeing& one : visitors) pass_round(one, round);
        const Judged judged = judge(visitors, pictures_of(visitors, offers, eyes), norms, tau);
        seen.belief.push_back(judged.round);
        for (std::size_t v = 0; v < sessions.size(); ++v) sessions[v].next(judged.picks[v]);
    }
    return seen;
}

std::string table_of(const SeeingWorld& world, const SeenWorld& seen) {
    std::string text = fmt::format(
        "the world that sees: all {} parameters, noise {}, {} visitors whose taste drifts and who get bored\n"
        "distances between small pictures; 1 is that of a scene by chance within what archetypes span\n"
        "{:<8}{:>22}{:>22}\n",
        genome::parameter_table().size(), name_of(world.noise), world.visitors, "round", "nearest of the four",
        "two of the four apart");
    for (std::size_t r = 0; r < seen.belief.size(); ++r)
        text += fmt::format("{:<8}{:>14.3f} ± {:.3f}{:>22.3f}\n", r + 1, seen.belief[r].nearest.value,
                            seen.belief[r].nearest.error, seen.belief[r].apart);
    double random = 0;
    for (const SeenRound& round : seen.biased_random)
        random += round.nearest.value / static_cast<double>(seen.biased_random.size());
    const SeenRound& fifth = seen.belief[std::min<std::size_t>(4, seen.belief.size() - 1)];
    const SeenRound& last = seen.belief.back();
    return text + fmt::format(
                      "biased random, any round: {:.3f}; after 5 rounds the belief is {:.0f} % nearer, after the last "
                      "{:.0f} %\n"
                      "the four of the last round are {:.0f} % as far apart as the first four\n",
                      random, 100 * (1 - fifth.nearest.value / random), 100 * (1 - last.nearest.value / random),
                      100 * last.apart / seen.belief.front().apart);
}

}  // namespace quadrat::breeding
