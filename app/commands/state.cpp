// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>

#include "archive/archive.hpp"
#include "archive/state_file.hpp"
#include "backup/backup.hpp"
#include "backup/state_hold.hpp"
#include "base/error.hpp"
#include "commands/commands.hpp"
#include "site/state_folder.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::string state;
    std::string configuration;
    int version = 0;
    std::string backup, restore;
    bool is_clone = false;
    bool keeps_settings = false;
};

constexpr int kInterrupted = 130;

struct Interruption : std::exception {};

std::atomic<bool>& stop_flag() {
    static std::atomic<bool> stop{false};
    return stop;
}

// Says how far long work is, and ends it where somebody says so.
backup::Progress progress() {
    const auto begun = std::chrono::steady_clock::now();
    return [begun, said = std::string()](const std::string& part, double share) mutable {
        constexpr std::chrono::milliseconds kSoon{700};
        if (stop_flag()) throw Interruption();
        // In tenths: a line each.
        const std::string now = fmt::format("{}: {} %", part, 10 * static_cast<int>(10 * share));
        if (now == said || std::chrono::steady_clock::now() - begun < kSoon) return;
        said = now;
        std::fprintf(stderr, "%s\n", now.c_str());
    };
}

void stop_on_signals() {
    struct sigaction action {};
    action.sa_handler = [](int) { stop_flag() = true; };
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
}

// The settings that were named, else the service's where its state is meant.
fs::path settings_for(const Options& options, const fs::path& state) {
    if (!options.configuration.empty()) return options.configuration;
    const site::ServiceFolders service;
    std::error_code error;
    return fs::equivalent(state, service.state, error) ? service.configuration : fs::path{};
}

backup::Places places_for(const Options& options) {
    const fs::path state = site::tended_state_folder(options.state);
    const auto now = std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
    return {state, settings_for(options, state), now};
}

int tell(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) std::printf("%s\n", line.c_str());
    return 0;
}

int move(const Options& options) {
    const fs::path folder = site::tended_state_folder(options.state);
    std::error_code error;
    if (!fs::exists(folder / archive::kStateFile, error))
        throw base::InputError(fmt::format("{}: there is no state file; name its folder with --state",
                                           (folder / archive::kStateFile).string()));
    const auto lock = backup::hold_state(folder, "quadrat state --move-to");
    const int before = archive::move_state(folder, options.version);
    std::printf("the state file is of version %d now; it was of version %d\n", options.version, before);
    return 0;
}

int back_up(const Options& options) {
    const auto lines = backup::write_backup(places_for(options), options.backup, progress());
    tell(lines);
    std::printf("%s\n", fs::absolute(options.backup).lexically_normal().c_str());
    return 0;
}

int restore(const Options& options) {
    const backup::Places places = places_for(options);
    std::error_code error;
    if (!fs::is_regular_file(options.restore, error))
        throw base::InputError(fmt::format("{}: there is no such file", options.restore));
    fs::create_directories(places.state, error);  // where it cannot be made, the lock says so
    const auto lock = backup::hold_state(places.state, "quadrat state --restore");
    backup::RestoreOptions how;
    if (options.is_clone) how.identity = backup::Identity::OfTheMachine;
    if (options.keeps_settings) how.settings = backup::Settings::Leave;
    return tell(backup::restore(places, options.restore, how, progress()));
}

int act(const Options& options) {
    if (options.version != 0) return move(options);
    if (options.backup.empty() && options.restore.empty())
        throw base::InputError("state: say what to do: --backup FILE, --restore FILE or --move-to N");
    if (options.restore.empty() && (options.is_clone || options.keeps_settings))
        throw base::InputError("state: --clone and --keep-settings go with --restore");
    stop_on_signals();
    try {
        return options.backup.empty() ? restore(options) : back_up(options);
    } catch (const Interruption&) {
        std::fprintf(stderr, "quadrat: interrupted; %s\n",
                     options.backup.empty() ? "nothing was changed" : (options.backup + " was not written").c_str());
        return kInterrupted;
    }
}

}  // namespace

void add_state(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand(
        "state",
        "Back up what a site has made, put it onto this machine or another, or move it to another schema version.\n"
        "A backup is one file: settings, what visitors did, words, maps of buttons, what is known of the GPU");
    command
        .add_option("--state", options->state,
                    "Folder of what is kept between runs; without it, the service's where it is installed")
        .tells_default("the service's, else ~/.local/state/quadrat");
    command
        .add_option("--config", options->configuration,
                    "The site's settings; without it, /etc/quadrat/quadrat.toml for the service's folder")
        .tells_default("the service's, else none");
    const Option backup =
        command.add_option("--backup", options->backup, "Write all of it to FILE.tar.xz; the exhibit may run");
    const Option restored =
        command.add_option("--restore", options->restore,
                           "Put a backup in place of what is here, which stays under a dated name; with "
                           "the exhibit stopped");
    command.add_flag("--clone", options->is_clone,
                     "With --restore: this machine stays another one. No visits come along, and the machine's own name "
                     "counts in the fleet");
    command.add_flag("--keep-settings", options->keeps_settings,
                     "With --restore: the settings of this machine stay as they are");
    const Option moved = command.add_option(
        "--move-to", options->version,
        "Move the state file to a version, 1 to " + std::to_string(archive::state_version()) +
            ", so that an older program can go on with it; with the exhibit stopped. A newer program moves an older "
            "file by itself");
    for (const Option& option : {backup, restored, moved}) option.tells_default("none");
    moved.between(1, archive::state_version());
    backup.excludes(restored).excludes(moved);
    restored.excludes(moved);
    command.does([options] { return act(*options); });
}

}  // namespace quadrat::commands
