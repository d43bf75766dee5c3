// SPDX-License-Identifier: Apache-2.0
#include "breeding/simulation/tournament.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/markup.hpp"
#include "breeding/belief/coordinates.hpp"

namespace quadrat::breeding {
namespace {

constexpr double kVisibly = 0.02;

// Of both genomes, once.
const genome::PerAspect<std::vector<Place>>& all_archetypes(genome::Genome genome) {
    const auto places_of = [](genome::Genome of) {
        genome::PerAspect<std::vector<Place>> places;
        for (const genome::Aspect aspect : genome::kAspects)
            places[aspect] = named_places(archetypes(aspect), of, aspect);
        return places;
    };
    static const auto kClassic = places_of(genome::Genome::Classic);
    static const auto kFull = places_of(genome::Genome::Full);
    return genome == genome::Genome::Classic ? kClassic : kFull;
}

base::Seed seed_of(const Tournament& t, int visitor) {
    return t.seed.child("visitor").child(static_cast<std::uint64_t>(visitor));
}

std::string colour_of(std::size_t i) {
    constexpr std::array<std::string_view, 8> kOkabeIto{"#000000", "#e69f00", "#56b4e9", "#009e73",
                                                        "#f0e442", "#0072b2", "#d55e00", "#cc79a7"};
    return std::string(kOkabeIto[i % kOkabeIto.size()]);
}

std::string title_of(const Tournament& t) {
    return fmt::format(
        "{} parameters, wishes {}, noise {}, {} {}",
        t.genome == genome::Genome::Classic ? "21 classic" : fmt::format("all {}", genome::parameter_table().size()),
        name_of(t.world), name_of(t.noise), t.visitors, name_of(t.party));
}

}  // namespace

const WordMap& known_half() {
    static const WordMap kMap = [] {
        std::vector<DescribedScene> known;
        genome::PerAspect<int> count{};
        for (const DescribedScene& scene : default_scenes())
            if (scene.name.empty() || count[scene.aspect]++ % 2 == 0) known.push_back(scene);
        return WordMap(known);
    }();
    return kMap;
}

Estimate mean_of(const std::vector<double>& numbers) {
    const auto n = static_cast<double>(numbers.size());
    double sum = 0;
    double squares = 0;
    for (const double number : numbers) {
        sum += number;
        squares += number * number;
    }
    const double mean = sum / n;
    return {mean, std::sqrt(std::max(0.0, squares / n - mean * mean) / n)};
}

SimulatedVisitor visitor_of(const Tournament& t, int visitor) {
    return {t.genome, t.world, t.noise, all_archetypes(t.genome), seed_of(t, visitor)};
}

std::string_view name_of(Party party) {
    switch (party) {
        case Party::One:
            break;
        case Party::Drifting:
            return "visitors whose taste drifts";
        case Party::Group:
            return "groups of three who take turns";
    }
    return "visitors";
}

Guests guests_of(const Tournament& t, int number) {
    const SimulatedVisitor first = visitor_of(t, number);
    const auto another = [&](int i) { return visitor_of(t, number + i * 1'000'000); };
    Guests guests{first};
    if (t.party == Party::Group)
        for (int i = 1; i < kInAGroup; ++i) guests.push_back(another(i));
    if (t.party != Party::Drifting) return guests;
    const SimulatedVisitor other = another(1);
    for (int round = 2; round <= t.rounds; ++round)
        guests.push_back(first.drifted(other, 0.5 * (round - 1) / (t.rounds - 1)));
    return guests;
}

Played play(const Tournament& t, const SimulatedVisitor& visitor, int number, Method method) {
    return play(t, Guests{visitor}, number, method);
}

Played play(const Tournament& t, const Guests& guests, int number, Method method) {
    const base::Seed seed = seed_of(t, number);
    const auto playing = player(method, guests.front(), known_half(), seed.child("player"));
    base::RandomStream chance(seed.child("chance").child(name_of(method)));
    Played played;
    std::optional<double> before;
    for (int round = 1; round <= t.rounds; ++round) {
        const SimulatedVisitor& visitor = guests[static_cast<std::size_t>(round - 1) % guests.size()];
        playing->play_round(visitor, chance);
        const genome::ParameterValues taken = playing->taken_home();
        double closeness = visitor.closeness(taken);
        if (t.party == Party::Group) {
            closeness = 0;
            for (const SimulatedVisitor& guest : guests)
                closeness += guest.closeness(taken) / static_cast<double>(guests.size());
        }
        played.closeness.push_back(closeness);
        const auto best = playing->best_shown();
        if (best && before && round <= 8) {
            ++played.compared;
            if (*best > *before + kVisibly) ++played.worse;
        }
        // What another one saw says nothing of whether it got worse.
        before = t.party == Party::One ? best : std::nullopt;
    }
    return played;
}

Standing standing_of(Method method, const std::vector<Played>& played) {
    Standing standing{method, {}, {}, 0, 0};
    int worse = 0;
    int compared = 0;
    for (const Played& one : played) {
        worse += one.worse;
        compared += one.compared;
    }
    standing.worse_share = compared > 0 ? static_cast<double>(worse) / compared : 0;
    standing.worse_error = compared > 0 ? std::sqrt(standing.worse_share * (1 - standing.worse_share) / compared) : 0;
    for (std::size_t round = 0; !played.empty() && round < played.front().closeness.size(); ++round) {
        std::vector<double> closeness;
        for (const Played& one : played) closeness.push_back(one.closeness[round]);
        const Estimate mean = mean_of(closeness);
        standing.closeness.push_back(mean.value);
        standing.standard_error.push_back(mean.error);
    }
    return standing;
}

std::string table_of(const Tournament& t, const std::vector<Standing>& standings) {
    std::string text = title_of(t) + "\n" + fmt::format("{:<28}", "closeness after round");
    for (const int round : kRoundsReported)
        if (round <= t.rounds) text += fmt::format("{:>16}", round);
    text += fmt::format("{:>10}\n", "worse");
    for (const Standing& standing : standings) {
        text += fmt::format("{:<28}", name_of(standing.method));
        for (const int round : kRoundsReported) {
            if (round > t.rounds) continue;
            const auto i = static_cast<std::size_t>(round - 1);
            text += fmt::format("{:>9.3f} ± {:.3f}", standing.closeness[i], standing.standard_error[i]);
        }
        text += standing.worse_share > 0 ? fmt::format("{:>9.0f}%\n", 100 * standing.worse_share) : "         –\n";
    }
    return text;
}

std::string plot_of(const Tournament& t, const std::vector<Standing>& standings) {
    constexpr double kLeft = 60;
    constexpr double kTop = 40;
    constexpr double kWidth = 560;
    constexpr double kHeight = 360;
    const auto x = [&](double round) { return kLeft + kWidth * round / t.rounds; };
    const auto y = [&](double closeness) { return kTop + kHeight * (0.9 - closeness) / 1.0; };
    std::string svg = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 860 460" font-family="sans-serif" font-size="12">)"
        "\n<rect width=\"860\" height=\"460\" fill=\"white\"/>\n<text x=\"60\" y=\"24\" font-size=\"15\">{}</text>\n",
        base::escaped(title_of(t)));
    for (int tenth = -1; tenth <= 9; ++tenth)
        svg += fmt::format(
            "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2}\" y2=\"{2}\" stroke=\"#ddd\"/><text x=\"24\" "
            "y=\"{3}\">{4:.1f}</text>\n",
            kLeft, kLeft + kWidth, y(tenth / 10.0), y(tenth / 10.0) + 4, tenth / 10.0);
    for (int round = 1; round <= t.rounds; ++round)
        svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", x(round), kTop + kHeight + 18,
                           round);
    svg +=
        fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">rounds; the share of the way to the wish</text>\n",
                    kLeft + kWidth / 2, kTop + kHeight + 38);
    for (std::size_t m = 0; m < standings.size(); ++m) {
        const Standing& standing = standings[m];
        std::string points;
        std::string band;
        std::string back;
        for (std::size_t i = 0; i < standing.closeness.size(); ++i) {
            const double at = x(static_cast<double>(i) + 1);
            points += fmt::format("{:.1f},{:.1f} ", at, y(standing.closeness[i]));
            band += fmt::format("{:.1f},{:.1f} ", at, y(standing.closeness[i] + standing.standard_error[i]));
            back.insert(0, fmt::format("{:.1f},{:.1f} ", at, y(standing.closeness[i] - standing.standard_error[i])));
        }
        const std::string colour = colour_of(m);
        svg += fmt::format("<polygon points=\"{}{}\" fill=\"{}\" opacity=\"0.15\"/>\n", band, back, colour);
        svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n", points,
                           colour, m >= 8 ? " stroke-dasharray=\"5 3\"" : "");
        svg += fmt::format("<text x=\"640\" y=\"{}\" fill=\"{}\">{}</text>\n", kTop + 16 + 20 * static_cast<double>(m),
                           colour, base::escaped(name_of(standing.method)));
    }
    return svg + "</svg>\n";
}

}  // namespace quadrat::breeding
