// SPDX-License-Identifier: Apache-2.0
#include "breeding/simulation/replay.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "breeding/belief/coordinates.hpp"
#include "breeding/session.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::kAspects;

struct ForetoldPick {
    std::array<double, genome::kCandidates> far{};
    std::size_t picked = 0;
};
using ForetoldVisit = std::vector<ForetoldPick>;

ForetoldVisit foretold(Breeder breeder, const PastVisit& visit) {
    ForetoldVisit foretold;
    if (visit.empty()) return foretold;
    const base::Seed seed{1};  // of learning: only PBIL's mutation asks for it
    genome::Candidate favourite = visit.front().offer.candidates.front();
    for (std::size_t round = 0; round < visit.size(); ++round) {
        const auto& [offer, pick] = visit[round];
        const genome::Candidate wished = breeder.wished(favourite);
        for (const Aspect aspect : kAspects) {
            if (round == 0 || !pick[aspect]) continue;
            const Place at = place_of(wished.values, genome::Genome::Full, aspect);
            ForetoldPick& one = foretold.emplace_back();
            one.picked = *pick[aspect];
            for (std::size_t c = 0; c < genome::kCandidates; ++c)
                one.far[c] =
                    std::sqrt(squared_distance(place_of(offer.candidates[c].values, genome::Genome::Full, aspect), at) /
                              static_cast<double>(at.size()));
        }
        breeder.learn(offer, pick, seed);
        favourite = chosen(offer, pick, favourite);
    }
    return foretold;
}

double bits_of(const ForetoldPick& pick, double indifference, double meaningless) {
    double sum = 0;
    for (const double far : pick.far) sum += std::exp((pick.far[pick.picked] - far) / indifference);
    return 2 + std::log2(meaningless / genome::kCandidates + (1 - meaningless) / sum);
}

double mean_bits(const ForetoldVisit& visit, double indifference, double meaningless) {
    double sum = 0;
    for (const ForetoldPick& pick : visit) sum += bits_of(pick, indifference, meaningless);
    return sum / static_cast<double>(visit.size());
}

Estimate bits_of(const std::vector<ForetoldVisit>& visits, double indifference, double meaningless) {
    std::vector<double> bits;
    for (const ForetoldVisit& visit : visits) bits.push_back(mean_bits(visit, indifference, meaningless));
    return mean_of(bits);
}

}  // namespace

Foretelling foretelling(BreederKind kind, genome::Genome genome, const WordMap& map,
                        std::span<const PastVisit> visits) {
    BreederOptions options;
    options.kind = kind;
    options.genome = genome;
    options.map = map;
    const Breeder breeder(options);
    Foretelling best{kind, 0, {-1e9, 0}, 0, 0};
    std::vector<ForetoldVisit> all;
    for (const PastVisit& visit : visits) {
        ForetoldVisit one = foretold(breeder, visit);
        if (one.empty()) continue;
        best.picks += static_cast<int>(one.size());
        all.push_back(std::move(one));
    }
    if (all.empty()) return {kind, 0, {}, 0, 0};
    constexpr double kFinest = 0.005;
    constexpr double kCoarsest = 2;
    for (double indifference = kFinest; indifference < kCoarsest; indifference *= 1.25)
        for (int tenths = 0; tenths <= 20; ++tenths) {
            const double meaningless = 0.05 * tenths;
            const Estimate bits = bits_of(all, indifference, meaningless);
            if (bits.value > best.bits.value) best = {kind, best.picks, bits, indifference, meaningless};
        }
    return best;
}

std::string table_of(std::span<const Foretelling> foretellings) {
    std::string text = fmt::format("{:<16}{:>8}{:>22}{:>16}{:>14}\n", "learns", "picks", "foretold, bits a pick",
                                   "indifference", "meaningless");
    for (const Foretelling& one : foretellings) {
        BreederOptions options;
        options.kind = one.kind;
        options.genome = genome::Genome::Full;
        const std::string_view name = one.kind == BreederKind::Random ? "what was last" : Breeder(options).name();
        text += fmt::format("{:<16}{:>8}{:>14.3f} ± {:.3f}{:>16.3f}{:>12.0f} %\n", name, one.picks, one.bits.value,
                            one.bits.error, one.indifference, 100 * one.meaningless);
    }
    return text;
}

}  // namespace quadrat::breeding
