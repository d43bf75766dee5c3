// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include "base/error.hpp"
#include "base/log.hpp"
#include "firmware-io/input_spec.hpp"
#include "firmware-io/merged_buttons.hpp"
#include "kiosk/commands/commands.hpp"
#include "kiosk/run_loop.hpp"
#include "kiosk/service.hpp"
#include "kiosk/state_folder.hpp"
#include "kiosk/visitor.hpp"

namespace quadrat::kiosk::commands {
namespace {

struct Options {
    std::string display;
    std::string size;
    std::vector<std::string> inputs;
    std::string configuration;
    std::string state;
    std::optional<int> rounds;
    std::string capture;
    std::optional<std::uint64_t> seed;
    std::string log_file;
};

constexpr int kDisplayFault = 75;  // EX_TEMPFAIL: the service starts us again

std::atomic<bool>& stop_flag() {
    static std::atomic<bool> stop{false};
    return stop;
}

void stop_on_signals() {
    stop_flag() = false;
    struct sigaction action {};
    action.sa_handler = [](int) { stop_flag() = true; };
    ::sigaction(SIGTERM, &action, nullptr);
    ::sigaction(SIGINT, &action, nullptr);
}

Configuration configuration_for(const Options& options) {
    Configuration configuration =
        options.configuration.empty() ? Configuration{} : read_configuration(options.configuration);
    if (!options.display.empty()) configuration.screen.display = options.display;
    if (!options.size.empty()) configuration.screen.size = options.size;
    if (!options.inputs.empty()) configuration.inputs = options.inputs;
    if (options.rounds) configuration.visit.rounds = *options.rounds;
    return configuration;
}

display::DisplayOptions display_options(const Configuration& configuration) {
    display::DisplayOptions options;
    options.kind = display::kind_from(configuration.screen.display, "display");
    if (!configuration.screen.size.empty()) options.size = display::size_from(configuration.screen.size, "size");
    options.connector = configuration.screen.connector;
    options.mode = configuration.screen.mode;
    options.rotation = static_cast<display::Rotation>(configuration.screen.rotation_deg / 90);
    options.mirroring = configuration.screen.is_mirrored ? display::Mirroring::Mirrored : display::Mirroring::None;
    return options;
}

struct Buttons {
    std::unique_ptr<firmware_io::ButtonSource> source;
    bool is_all_scripted = true;
};

Buttons open_buttons(const std::vector<std::string>& specs) {
    Buttons buttons;
    std::vector<std::unique_ptr<firmware_io::ButtonSource>> sources;
    for (const std::string& spec : specs) {
        try {
            sources.push_back(firmware_io::open_buttons(spec));
        } catch (const std::invalid_argument& error) {
            throw base::InputError(fmt::format("--input {}", error.what()));
        }
        if (!spec.starts_with("script:")) buttons.is_all_scripted = false;
    }
    buttons.source = std::make_unique<firmware_io::MergedButtons>(std::move(sources));
    return buttons;
}

// Nobody can press where there is neither a screen nor a named button: a visitor is played, and pictures are left.
bool needs_a_visitor(const Configuration& configuration, const display::Display& display) {
    return configuration.inputs.empty() && display.kind() == "headless";
}

std::vector<std::string> default_inputs(const display::Display& display) {
    if (display.kind() == "window") return {"keyboard", "hid:"};
    return {"hid:"};
}

base::Seed seed_for(const Options& options) {
    if (options.seed) return base::Seed{*options.seed};
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    return base::Seed{static_cast<std::uint64_t>(now)}.child("run");
}

int status_of(RunEnd end) {
    if (end != RunEnd::DisplayFault) return 0;
    base::log::error("screen: given up; ending so that the service starts the exhibit again");
    return kDisplayFault;
}

exhibit::WallTime wall_time() {
    return std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
}

int run(const Options& options) {
    if (!options.log_file.empty()) base::open_log(base::LogDetail::Normal, options.log_file);
    const Configuration asked = configuration_for(options);
    const auto screen = display::open_display(display_options(asked));

    Configuration configuration = asked;
    const bool is_demonstration = needs_a_visitor(asked, *screen);
    const base::Seed seed = seed_for(options);
    Buttons buttons;
    if (is_demonstration) {
        buttons.source = scripted_visitor(configuration.visit.rounds, seed);
    } else {
        if (configuration.inputs.empty()) configuration.inputs = default_inputs(*screen);
        buttons = open_buttons(configuration.inputs);
    }
    const std::string folder = options.capture.empty() && is_demonstration ? "quadrat-pictures" : options.capture;
    std::unique_ptr<Album> album;
    if (!folder.empty()) album = std::make_unique<Album>(folder);
    if (is_demonstration)
        base::log::info("no screen and no buttons here: a visitor of {} rounds is played, pictures go to {}",
                        configuration.visit.rounds, folder);

    const std::filesystem::path state = state_folder(options.state);
    auto opened = exhibit::Archive::open(state, wall_time());
    if (opened.condition == exhibit::Archive::Condition::Replaced ||
        opened.condition == exhibit::Archive::Condition::MemoryOnly)
        base::log::warn("state: {}", opened.message);
    else
        base::log::info("state: {}", opened.message);

    std::unique_ptr<Clock> clock;
    if (screen->kind() == "headless" && buttons.is_all_scripted)
        clock = std::make_unique<SimulatedClock>();
    else
        clock = std::make_unique<SteadyClock>();
    const GrowerOptions growing{0, fineness_of(configuration.picture.land_samples)};
    Show show(configuration, {seed, growing, wall_time}, std::move(opened.archive));
    stop_on_signals();
    const RunEnd end = run_loop({configuration, *clock, *screen, *buttons.source, show, album.get(),
                                 options.rounds.has_value() || is_demonstration, &stop_flag()});
    announce_stopping();
    if (album) {
        album->finish();
        std::printf("%zu pictures and contact-sheet.png are in %s\n", album->count(),
                    std::filesystem::absolute(album->folder()).lexically_normal().c_str());
    }
    return status_of(end);
}

}  // namespace

void add_run(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("run", "The exhibit");
    command->add_option("--display", options->display, "auto, kms, window or headless")
        ->check(CLI::IsMember({"auto", "kms", "window", "headless"}));
    command->add_option("--size", options->size, "Pixels to draw, as 1280x720; without it, the screen's");
    command->add_option("--input", options->inputs,
                        "Where presses come from, repeatable: gpio:A=GPIO17,…  hid:  keyboard  script:FILE");
    command->add_option("--config", options->configuration, "The site's settings (deploy/quadrat.toml shows all)");
    command->add_option("--state", options->state, "Folder of what is kept between runs");
    command->add_option("--rounds", options->rounds, "Rounds of a visit; the program ends after one visit")
        ->check(CLI::Range(1, 50));
    command->add_option("--capture", options->capture,
                        "Folder for one PNG a generation, the finale and a contact sheet");
    command->add_option("--seed", options->seed, "Names all chance; without it, every start is another");
    command->add_option("--log-file", options->log_file, "Write the log there too");
    command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace quadrat::kiosk::commands
