// SPDX-License-Identifier: Apache-2.0
#include "projector/projector.hpp"

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "commands/commands.hpp"
#include "fleet/identity.hpp"
#include "machine/machine.hpp"
#include "projector/keeper.hpp"
#include "site/settings.hpp"
#include "site/state_folder.hpp"
#include "staff/presence.hpp"

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

// As the exhibit last said it shows; nothing where none runs, or its screen has failed: then it stays as it is.
class ExhibitsScreen {
  public:
    explicit ExhibitsScreen(fs::path runtime) : runtime_(std::move(runtime)) {}

    std::optional<projector::Wanted> wanted() {
        if (!staff::is_exhibit_present(runtime_)) return std::nullopt;
        std::error_code error;
        const auto written = fs::last_write_time(runtime_ / "health.json", error);
        if (error) return std::nullopt;
        if (written != read_at_) read();
        read_at_ = written;
        return wanted_;
    }

  private:
    void read() {
        constexpr std::size_t kLargest = 1U << 20U;
        try {
            const auto health =
                nlohmann::json::parse(base::read_file(runtime_ / "health.json", kLargest), nullptr, false);
            const auto screen = health.is_object() ? health.value("screen", nlohmann::json()) : nlohmann::json();
            wanted_.reset();
            if (screen == "dark") wanted_ = projector::Wanted::Off;
            if (screen == "shows" || screen == "card") wanted_ = projector::Wanted::On;
        } catch (const base::InputError&) {
            wanted_.reset();  // it is being replaced; the next look finds it
        }
    }

    fs::path runtime_;
    fs::file_time_type read_at_{};
    std::optional<projector::Wanted> wanted_;
};

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

void add_projector(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "projector",
        "Have the projector, or the screen, be on while the exhibit beside us shows something, until told to stop");
    command->add_option("--config", options->configuration, "The site's settings; screen.power says how it is switched")
        ->required();
    command->add_flag("--service", options->is_service,
                      "With a mistake in the settings, follow the last with which the exhibit worked");
    command->add_option("--state", options->state, "The exhibit's state folder")
        ->default_str("the service's, else ~/.local/state/quadrat");
    command->add_option("--runtime", options->runtime, "Where the exhibit writes its health, as /run/quadrat")
        ->default_str("the service's, else the state folder");
    auto* turn = command->add_option("--turn", options->turn, "Switch it now, say how it is, and end")
                     ->check(CLI::IsMember({"on", "off"}))
                     ->default_str("neither");
    command->add_flag("--ask", options->asks, "Say how it is, and end")->excludes(turn);
    command->callback([options, &chosen] { chosen = [options] { return run_projector(*options); }; });
}

}  // namespace quadrat::commands
