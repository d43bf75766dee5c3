// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <atomic>
#include <iostream>
#include <mutex>

#include "base/file.hpp"
#include "breeding/simulation/tournament.hpp"
#include "commands/commands.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    bool is_all = false;
    std::string genome = "words";
    std::string world = "archetypes";
    std::string noise = "mild";
    int visitors = 200;
    int rounds = 15;
    std::uint64_t seed = 1;
    std::string plot;
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
        const breeding::SimulatedVisitor visitor = breeding::visitor_of(tournament, number);
        for (std::size_t m = 0; m < methods.size(); ++m) {
            played[m][static_cast<std::size_t>(number)] = breeding::play(tournament, visitor, number, methods[m]);
            progress.step();
        }
    });
    std::vector<breeding::Standing> standings;
    for (std::size_t m = 0; m < methods.size(); ++m) standings.push_back(breeding::standing_of(methods[m], played[m]));
    return standings;
}

std::vector<breeding::Tournament> tournaments_of(const Options& options) {
    breeding::Tournament base;
    base.visitors = options.visitors;
    base.rounds = options.rounds;
    base.seed = base::Seed{options.seed};
    base.genome = options.genome == "classic" ? genome::Genome::Classic : genome::Genome::Full;
    base.world = options.world == "anywhere" ? breeding::World::Anywhere : breeding::World::NearArchetypes;
    base.noise = options.noise == "none"   ? breeding::Noise::None
                 : options.noise == "mild" ? breeding::Noise::Mild
                                           : breeding::Noise::Strong;
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

int simulate(const Options& options) {
    if (!options.plot.empty()) base::require_ending(options.plot, {".svg"}, "a plot");
    const auto tournaments = tournaments_of(options);
    Progress progress(tournaments.size() * breeding::all_methods().size() * static_cast<std::size_t>(options.visitors));
    for (std::size_t i = 0; i < tournaments.size(); ++i) {
        const auto standings = standings_of(tournaments[i], progress);
        std::cout << (i > 0 ? "\n" : "") << breeding::table_of(tournaments[i], standings)
                  << breeding::text_of(breeding::figures_of(standings)) << std::flush;
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

void add_simulate(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("simulate", "Let simulated visitors play breeders and sliders: closeness to their wish");
    command->add_flag("--all", options->is_all, "Both genomes, both worlds");
    command->add_option("--genome", options->genome, "words or classic")
        ->check(CLI::IsMember({"words", "classic"}))
        ->capture_default_str();
    command->add_option("--world", options->world, "Where wishes lie: archetypes (near mixtures of them) or anywhere")
        ->check(CLI::IsMember({"archetypes", "anywhere"}))
        ->capture_default_str();
    command->add_option("--noise", options->noise, "How badly visitors see: none, mild, strong")
        ->check(CLI::IsMember({"none", "mild", "strong"}))
        ->capture_default_str();
    command->add_option("--visitors", options->visitors, "How many play each method")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    command->add_option("--rounds", options->rounds, "How many each plays")
        ->check(CLI::Range(1, 200))
        ->capture_default_str();
    command->add_option("--seed", options->seed, "Names all chance")->capture_default_str();
    command->add_option("--plot", options->plot, "An SVG file; with --all, one a table, numbered")->default_str("none");
    command->callback([options, &chosen] { chosen = [options] { return simulate(*options); }; });
}

}  // namespace quadrat::commands
