// SPDX-License-Identifier: Apache-2.0
#include "projector/projector.hpp"

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <iostream>
#include <thread>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "commands/commands.hpp"
#include "commands/exhibits_screen.hpp"
#include "fleet/identity.hpp"
#include "machine/machine.hpp"
#include "projector/keeper.hpp"
#include "site/settings.hpp"
#include "site/state_folder.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Options {
    std::string configuration, state, runtime, turn;
    bool asks = false;
    bool is_service = false;
};

std::atomic<bool>& stop_flag() {
    static std::atomic<bool> stop{false};
    return stop;
}

site::Configuration::Screen screen_for(const Options& options, const fs::path& state) {
    if (!options.is_service) return site::settings_for_people(options.configuration, state).configuration.screen;
    const site::Settings settings = site::settings_for_service(options.configuration, state);
    site::tell(settings);
    return settings.configuration.screen;
}

std::unique_ptr<projector::Projector> projector_of(const site::Configuration::Screen& screen) {
    const std::string& file = screen.power_password_file;
    return projector::open_projector(projector::parse_address(screen.power),
                                     file.empty() ? "" : fleet::password_in(file));
}

int once(projector::Projector& projector, const Options& options) {
    try {
        if (options.turn == "on") projector.turn_on();
        if (options.turn == "off") projector.turn_off();
        const std::string power = name_of(projector.power()), ailments = projector.ailments();
        std::cout << power << (ailments.empty() ? "" : "; it reports " + ailments) << "\n";
        return 0;
    } catch (const projector::Trouble& trouble) {
        throw base::InputError(fmt::format("{}; {}", trouble.what(), trouble.remedy()));
    }
}

void keep(projector::Projector& projector, const fs::path& runtime) {
    constexpr std::chrono::milliseconds kBetween{500};
    projector::Keeper keeper(projector);
    ExhibitsScreen screen(runtime);
    std::optional<projector::Told> told;
    while (!stop_flag()) {
        if (keeper.look(screen.wanted(), Clock::now())) {
            if (told != keeper.told() && keeper.told().trouble.empty())
                base::log::info("projector: {}", name_of(keeper.told().power.value_or(projector::Power::Unknown)));
            told = keeper.told();
            try {
                base::write_file(runtime / projector::kTold, projector::to_json(*told));
            } catch (const base::InputError& error) {
                base::log::debug("projector: {}", error.what());
            }
        }
        std::this_thread::sleep_for(kBetween);
    }
    std::error_code ignored;
    fs::remove(runtime / projector::kTold, ignored);
}

int run_projector(const Options& options) {
    const fs::path state = site::state_folder(options.state);
    const site::Configuration::Screen screen = screen_for(options, state);
    if (screen.power.empty()) {
        base::log::info("projector: screen.power is empty in {}, so nobody switches one", options.configuration);
        return 0;
    }
    struct sigaction action {};
    action.sa_handler = [](int) { stop_flag() = true; };
    ::sigaction(SIGTERM, &action, nullptr);
    ::sigaction(SIGINT, &action, nullptr);
    const auto projector = projector_of(screen);
    if (options.asks || !options.turn.empty()) return once(*projector, options);
    keep(*projector, options.runtime.empty() ? machine::runtime_folder(state) : fs::path(options.runtime));
    return 0;
}

}  // namespace

void add_projector(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand(
        "projector",
        "Have the projector, or the screen, be on while the exhibit beside us shows something, until told to stop");
    command.add_option("--config", options->configuration, "The site's settings; screen.power says how it is switched")
        .required();
    command.add_flag("--service", options->is_service,
                     "With a mistake in the settings, follow the last with which the exhibit worked");
    command.add_option("--state", options->state, "The exhibit's state folder")
        .tells_default("the service's, else ~/.local/state/quadrat");
    command.add_option("--runtime", options->runtime, "Where the exhibit writes its health, as /run/quadrat")
        .tells_default("the service's, else the state folder");
    const Option turn = command.add_option("--turn", options->turn, "Switch it now, say how it is, and end")
                            .among({"on", "off"})
                            .tells_default("neither");
    command.add_flag("--ask", options->asks, "Say how it is, and end").excludes(turn);
    command.does([options] { return run_projector(*options); });
}

}  // namespace quadrat::commands
