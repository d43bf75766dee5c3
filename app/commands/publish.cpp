// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <csignal>

#include "base/log.hpp"
#include "commands/commands.hpp"
#include "commands/fleet_exchange.hpp"
#include "commands/fleet_orders.hpp"
#include "fleet/publisher.hpp"
#include "machine/machine.hpp"
#include "machine/version.hpp"
#include "site/settings.hpp"
#include "site/state_folder.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string configuration;
    std::string state;
    std::string runtime;
    bool is_service = false;
};

std::atomic<bool>& stop_flag() {
    static std::atomic<bool> stop{false};
    return stop;
}

// Above all when there is something wrong with the settings a fleet wants to hear of it. Without any that worked there
// is no broker to tell.
site::Settings settings_for(const Options& options, const std::filesystem::path& state) {
    if (!options.is_service) return site::settings_for_people(options.configuration, state);
    site::Settings settings = site::settings_for_service(options.configuration, state);
    if (settings.from == site::SettingsFrom::Defaults) throw site::SettingsError(std::move(settings.mistakes));
    site::tell(settings);
    return settings;
}

int publish(const Options& options) {
    const auto state = site::state_folder(options.state);
    const site::Settings settings = settings_for(options, state);
    const site::Configuration& configuration = settings.configuration;
    if (configuration.fleet.broker.empty()) {
        base::log::info("fleet: no broker is named in {}, so nothing is published", options.configuration);
        return 0;
    }
    struct sigaction action {};
    action.sa_handler = [](int) { stop_flag() = true; };
    ::sigaction(SIGTERM, &action, nullptr);
    ::sigaction(SIGINT, &action, nullptr);
    // A broker that hangs up while we write is no reason to end.
    ::signal(SIGPIPE, SIG_IGN);
    const std::filesystem::path runtime =
        options.runtime.empty() ? machine::runtime_folder(state) : std::filesystem::path(options.runtime);
    fleet::PublisherOptions how;
    how.version = std::string(machine::version());
    if (configuration.fleet.takes_orders) how.orders = fleet_orders(options.configuration, state, runtime);
    how.sharing = sharing_by(configuration.fleet, options.configuration, state, runtime);
    fleet::Publisher publisher(configuration.fleet, state, runtime, std::move(how));
    while (!stop_flag()) publisher.look();
    return 0;
}

}  // namespace

void add_publish(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand(
        "publish", "Tell a broker by MQTT how the exhibit beside us is and what visitors did, until told to stop");
    command.add_option("--config", options->configuration, "The site's settings; [fleet] names the broker").required();
    command.add_flag("--service", options->is_service,
                     "With a mistake in the settings, publish by the last with which the exhibit worked");
    command.add_option("--state", options->state, "The exhibit's state folder")
        .tells_default("the service's, else ~/.local/state/quadrat");
    command.add_option("--runtime", options->runtime, "Where the exhibit writes its health, as /run/quadrat")
        .tells_default("the service's, else the state folder");
    command.does([options] { return publish(*options); });
}

}  // namespace quadrat::commands
