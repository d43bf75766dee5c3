// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <atomic>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>

#include "base/file.hpp"
#include "breeding/reach.hpp"
#include "breeding/simulation/replay.hpp"
#include "breeding/simulation/seeing.hpp"
#include "breeding/simulation/study.hpp"
#include "breeding/simulation/tournament.hpp"
#include "commands/commands.hpp"
#include "learning/past_visits.hpp"
#include "learning/school.hpp"
#include "site/state_folder.hpp"
#include "stage/eye.hpp"
#include "switches/pace.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    bool is_all = false;
    bool is_study = false;
    std::string genome = "words";
    std::string world = "archetypes";
    std::string noise = "mild";
    std::string party = "one";
    std::optional<int> visitors;
    std::optional<int> rounds;
    std::uint64_t seed = 1;
    std::string plot;
    std::string from;
    bool is_switches = false;
};

// One line that is rewritten on a terminal, and left out elsewhere.
class Progress {
  public:
    explicit Progress(std::size_t whole) : whole_(whole), is_terminal_(isatty(STDERR_FILENO) == 1) {}
    void step() {
        const std::size_t done = ++done_;
        if (!is_terminal_ || done * 100 / whole_ == (done - 1) * 100 / whole_) return;
        const std::scoped_lock lock(mutex_);
        std::cerr << fmt::format("\r{:3} % of the visitors have played", done * 100 / whole_)
                  << (done == whole_ ? "\n" : "") << std::flush;
    }

  private:
    std::size_t whole_;
    bool is_terminal_;
    std::atomic<std::size_t> done_{0};
    std::mutex mutex_;
};

std::vector<breeding::Standing> standings_of(const breeding::Tournament& tournament, Progress& progress) {
    const auto methods = breeding::all_methods();
    const auto visitors = static_cast<std::size_t>(tournament.visitors);
    std::vector<std::vector<breeding::Played>> played(methods.size(), std::vector<breeding::Played>(visitors));
    tbb::parallel_for(0, tournament.visitors, [&](int number) {
        const breeding::Guests guests = breeding::guests_of(tournament, number);
        for (std::size_t m = 0; m < methods.size(); ++m) {
            played[m][static_cast<std::size_t>(number)] = breeding::play(tournament, guests, number, methods[m]);
            progress.step();
        }
    });
    std::vector<breeding::Standing> standings;
    for (std::size_t m = 0; m < methods.size(); ++m) standings.push_back(breeding::standing_of(methods[m], played[m]));
    return standings;
}

breeding::Noise noise_of(const Options& options) {
    return options.noise == "none"   ? breeding::Noise::None
           : options.noise == "mild" ? breeding::Noise::Mild
                                     : breeding::Noise::Strong;
}

std::vector<breeding::Tournament> tournaments_of(const Options& options) {
    breeding::Tournament base;
    base.visitors = options.visitors.value_or(base.visitors);
    base.rounds = options.rounds.value_or(base.rounds);
    base.seed = base::Seed{options.seed};
    base.genome = options.genome == "classic" ? genome::Genome::Classic : genome::Genome::Full;
    base.world = options.world == "anywhere" ? breeding::World::Anywhere : breeding::World::NearArchetypes;
    base.noise = noise_of(options);
    base.party = options.party == "drifting" ? breeding::Party::Drifting
                 : options.party == "group"  ? breeding::Party::Group
                                             : breeding::Party::One;
    if (!options.is_all) return {base};
    std::vector<breeding::Tournament> all;
    for (const auto genome : {genome::Genome::Classic, genome::Genome::Full})
        for (const auto world : {breeding::World::Anywhere, breeding::World::NearArchetypes}) {
            base.genome = genome;
            base.world = world;
            all.push_back(base);
        }
    return all;
}

// Pictures that were drawn once are not drawn again.
class Eyes {
  public:
    std::vector<breeding::Picture> look(const std::vector<breeding::Look>& looks) {
        std::vector<genome::Recipe> missing;
        std::vector<Key> keys;
        for (const breeding::Look& look : looks) {
            keys.emplace_back(look.visitor, nursery::key_of(look.aspect, look.in));
            if (pictures_.emplace(keys.back(), breeding::Picture{}).second)
                missing.push_back(genome::recipe_of(look.in, base::Seed{look.visitor + 1}));
        }
        std::vector<stage::Sight> sights = eye_.look(missing);
        auto next = sights.begin();
        std::vector<breeding::Picture> all;
        for (const Key& key : keys) {
            breeding::Picture& picture = pictures_.at(key);
            if (picture.empty()) picture = std::move(*next++);
            all.push_back(picture);
        }
        return all;
    }

  private:
    using Key = std::pair<std::size_t, nursery::AspectKey>;
    stage::Eye eye_;
    std::map<Key, breeding::Picture> pictures_;
};

int simulate_seeing(const Options& options) {
    breeding::SeeingWorld world;
    world.visitors = options.visitors.value_or(world.visitors);
    world.rounds = options.rounds.value_or(world.rounds);
    world.seed = base::Seed{options.seed};
    world.noise = noise_of(options);
    Eyes eyes;
    const auto seen =
        breeding::play_seeing(world, [&](const std::vector<breeding::Look>& looks) { return eyes.look(looks); });
    std::cout << breeding::table_of(world, seen) << std::flush;
    return 0;
}

// Real visitors' picks, bred again: how well each way of learning would have foretold them.
int replay(const Options& options) {
    const learning::PastVisits past = learning::past_visits_in(site::existing_state_folder(options.from));
    fmt::print("{} visits are bred again; {} by other settings and {} by sliders are left out\n", past.visits.size(),
               past.tuned_differently, past.by_sliders);
    if (past.visits.empty()) return 0;
    std::vector<breeding::Foretelling> foretellings;
    const breeding::WordMap map = learning::site_words(options.from).map;
    for (const auto kind :
         {breeding::BreederKind::Belief, breeding::BreederKind::PbilGaussian, breeding::BreederKind::Random})
        foretellings.push_back(breeding::foretelling(kind, genome::Genome::Full, map, past.visits));
    std::cout << breeding::table_of(foretellings) << std::flush;
    return 0;
}

int redo_study(const Options& options) {
    breeding::Study study;
    study.users = options.visitors.value_or(study.users);
    study.seed = base::Seed{options.seed};
    Progress progress(static_cast<std::size_t>(6 * study.users));
    const auto rows = breeding::study(study, [&] { progress.step(); });
    std::cout << breeding::table_of(study, rows) << std::flush;
    return 0;
}

// What the breeder has to steer: not the table's rows, but those of them that picks move.
std::string reach_line() {
    breeding::BreederOptions options;
    options.kind = breeding::BreederKind::Belief;
    options.genome = genome::Genome::Full;
    const breeding::Reach reach = breeding::reach_of(options);
    return fmt::format(
        "picks move {} of {} parameters, {:.0f} % of them over half of their range (quadrat words reach)\n",
        reach.parameters.size() - reach.still(), reach.parameters.size(), 100 * reach.share_reaching(0.5));
}

// Rounds a minute of who plays with one button, two and four, at several paces.
int simulate_switches(const Options& options) {
    const int rounds = options.rounds.value_or(6);
    const int visitors = options.visitors.value_or(60);
    fmt::print(
        "{} simulated visits of {} rounds, who think for {:.1f} s, react in {:.1f} s and see the next four after "
        "{:.1f} s\n{:<34} {:>8} {:>15} {:>15} {:>8}\n",
        visitors, rounds, 2.5, 0.5, 1.5, "", "minutes", "rounds a minute", "presses a round", "missed");
    const auto row = [&](const std::string& name, switches::Buttons buttons, const switches::Options& how) {
        double minutes = 0, rate = 0, presses = 0, missed = 0;
        for (int v = 0; v < visitors; ++v) {
            const base::Seed seed = base::Seed{options.seed}.child(static_cast<std::uint64_t>(v));
            base::RandomStream liking(seed.child("picks"));
            std::vector<genome::Pick> picks(static_cast<std::size_t>(rounds));
            for (genome::Pick& pick : picks)
                for (auto& answer : pick.each) answer = liking.below(genome::kCandidates);
            const switches::Pace pace = switches::pace_of(picks, buttons, how, {}, seed);
            minutes += pace.minutes / visitors;
            rate += pace.rounds_a_minute / visitors;
            presses += pace.presses_a_round / visitors;
            missed += static_cast<double>(pace.missed) / rounds / visitors;
        }
        fmt::print("{:<34} {:>8.1f} {:>15.2f} {:>15.1f} {:>8.2f}\n", name, minutes, rate, presses, missed);
    };
    switches::Options how;
    row("four buttons", switches::Buttons::Four, how);
    row("two buttons", switches::Buttons::Two, how);
    for (const int pace_ms : {1'000, 1'500, 2'000, 3'000}) {
        how.pace = std::chrono::milliseconds{pace_ms};
        row(fmt::format("one button, pace_s = {:.1f}", pace_ms / 1000.0), switches::Buttons::One, how);
    }
    for (const int dwell_ms : {1'000, 2'000}) {
        how.dwell = std::chrono::milliseconds{dwell_ms};
        row(fmt::format("one button, dwell_s = {:.1f}", dwell_ms / 1000.0), switches::Buttons::One, how);
    }
    return 0;
}

int simulate(const Options& options) {
    if (options.is_switches) return simulate_switches(options);
    if (options.is_study) return redo_study(options);
    if (!options.from.empty()) return replay(options);
    if (options.world == "sees") return simulate_seeing(options);
    if (!options.plot.empty()) base::require_ending(options.plot, {".svg"}, "a plot");
    const auto tournaments = tournaments_of(options);
    Progress progress(tournaments.size() * breeding::all_methods().size() *
                      static_cast<std::size_t>(tournaments.front().visitors));
    for (std::size_t i = 0; i < tournaments.size(); ++i) {
        const auto standings = standings_of(tournaments[i], progress);
        std::cout << (i > 0 ? "\n" : "") << breeding::table_of(tournaments[i], standings);
        // They are of one wish.
        if (tournaments[i].party == breeding::Party::One)
            std::cout << breeding::text_of(breeding::figures_of(standings));
        if (tournaments[i].genome == genome::Genome::Full) std::cout << reach_line();
        std::cout << std::flush;
        if (options.plot.empty()) continue;
        const std::filesystem::path path = options.plot;
        const auto name = i == 0 ? path
                                 : path.parent_path() /
                                       fmt::format("{}-{}{}", path.stem().string(), i + 1, path.extension().string());
        base::write_file(name, breeding::plot_of(tournaments[i], standings));
        std::cerr << name.string() << '\n';
    }
    return 0;
}

}  // namespace

void add_simulate(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command =
        program.add_subcommand("simulate", "Let simulated visitors play breeders and sliders: closeness to their wish");
    command.add_flag("--all", options->is_all, "Both genomes, both worlds");
    command.add_flag("--study", options->is_study,
                     "The user test of the paper of 2003 again, by simulated users: breeding against sliders");
    command.add_flag("--switches", options->is_switches,
                     "How many rounds a minute are played with one button, two and four, by the pace of the mark");
    command.add_option("--genome", options->genome, "words or classic").among({"words", "classic"}).shows_default();
    command
        .add_option("--world", options->world,
                    "Where wishes lie: archetypes (near mixtures of them) or anywhere; sees: visitors compare small "
                    "pictures instead of parameters (60 visitors, 8 rounds take minutes)")
        .among({"archetypes", "anywhere", "sees"})
        .shows_default();
    command.add_option("--noise", options->noise, "How badly visitors see: none, mild, strong")
        .among({"none", "mild", "strong"})
        .shows_default();
    command
        .add_option("--party", options->party,
                    "Who presses: one; drifting (who comes to wish half of all as another does); group (three who "
                    "take turns, a round each: closeness is the mean of theirs)")
        .among({"one", "drifting", "group"})
        .shows_default();
    command.add_option("--visitors", options->visitors, "How many play each method")
        .between(2, 100000)
        .tells_default("200; 60 who see, are studied or play with switches");
    command.add_option("--rounds", options->rounds, "How many each plays")
        .between(1, 200)
        .tells_default("15; 8 for those who see, 6 with switches");
    command.add_option("--seed", options->seed, "Names all chance").shows_default();
    command
        .add_option("--from", options->from,
                    "A state folder: its visitors' picks are bred again instead, and how well each breeder would have "
                    "foretold them is told in bits a pick, with the noise that suits them best")
        .tells_default("none");
    command.add_option("--plot", options->plot, "An SVG file; with --all, one a table, numbered").tells_default("none");
    command.does([options] { return simulate(*options); });
}

}  // namespace quadrat::commands
