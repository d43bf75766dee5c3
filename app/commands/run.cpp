// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <thread>

#include "backup/state_hold.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "commands/commands.hpp"
#include "commands/scripted_visitor.hpp"
#include "commands/wall.hpp"
#include "firmware-io/input_spec.hpp"
#include "firmware-io/merged_buttons.hpp"
#include "kiosk/run_loop.hpp"
#include "machine/heap.hpp"
#include "machine/machine.hpp"
#include "machine/service.hpp"
#include "pictures/picture.hpp"
#include "site/screen.hpp"
#include "site/settings.hpp"
#include "site/state_folder.hpp"
#include "site/wall_clock.hpp"
#include "staff/caretaker.hpp"
#include "staff/presence.hpp"
#include "tempo/memory.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string display;
    std::string size;
    std::vector<std::string> inputs;
    std::string configuration;
    std::string state;
    std::optional<int> rounds;
    std::string ground;
    std::string capture;
    std::optional<std::uint64_t> seed;
    std::string log_file;
    double speed = 1;
    tempo::Budget budget;
    bool is_service = false;
    bool is_wall = false;
};

namespace fs = std::filesystem;

constexpr const char* kWallState = "wall";  // in the folder of the exhibit beside it
constexpr double kSafeAlpha = 0.5;
constexpr int kSafeLand = 129;
constexpr std::chrono::seconds kBreather{10};  // between starts that keep failing
constexpr int kDisplayFault = 75;              // EX_TEMPFAIL: the service starts us again

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

// What the command line says, whatever the settings do.
void override_by(const Options& options, site::Configuration& configuration) {
    if (!options.display.empty()) configuration.screen.display = options.display;
    if (!options.size.empty()) configuration.screen.size = options.size;
    if (!options.inputs.empty()) configuration.inputs = options.inputs;
    if (options.rounds) configuration.visit.rounds = *options.rounds;
    if (options.rounds) configuration.visit.rounds_early = configuration.visit.rounds_more = 0;  // exactly so many
    configuration.attract.is_wall = options.is_wall;
    if (!options.ground.empty()) configuration.picture.ground = options.ground;
}

struct Buttons {
    std::unique_ptr<firmware_io::ButtonSource> source;
    bool is_all_scripted = true;
};

Buttons open_buttons(const std::vector<std::string>& specs) {
    Buttons buttons;
    std::vector<std::unique_ptr<firmware_io::ButtonSource>> sources;
    const auto boards = std::make_shared<firmware_io::HeardBoards>();
    for (const std::string& spec : specs) {
        try {
            auto opened = firmware_io::open_buttons_beside(spec, boards);
            sources.push_back(std::move(opened.source));
            if (!opened.map_trouble.empty())
                base::log::warn("buttons: {}; until then the usual order of buttons is used", opened.map_trouble);
        } catch (const std::invalid_argument& error) {
            throw base::InputError(fmt::format("--input {}", error.what()));
        }
        if (!spec.starts_with("script:")) buttons.is_all_scripted = false;
    }
    buttons.source = std::make_unique<firmware_io::MergedButtons>(std::move(sources));
    return buttons;
}

// Nobody can press where there is neither a screen nor a named button: a visitor is played, and pictures are left.
bool needs_a_visitor(const site::Configuration& configuration, const display::Display& display) {
    return configuration.inputs.empty() && display.kind() == "headless";
}

base::Seed seed_for(const Options& options) {
    if (options.seed) return base::Seed{*options.seed};
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    return base::Seed{static_cast<std::uint64_t>(now)}.child("run");
}

int status_of(kiosk::RunEnd end) {
    if (end != kiosk::RunEnd::DisplayFault) return 0;
    base::log::error("screen: given up; ending so that the service starts the exhibit again");
    return kDisplayFault;
}

archive::WallTime wall_time() {
    return std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
}

// The same moment as the site's clocks show it.
archive::WallTime local_time() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm local{};
    ::localtime_r(&now, &local);
    return wall_time() + std::chrono::seconds(local.tm_gmtoff);
}

void wait_unless_stopped(std::chrono::seconds span) {
    const auto until = std::chrono::steady_clock::now() + span;
    while (!stop_flag() && std::chrono::steady_clock::now() < until)
        std::this_thread::sleep_for(std::chrono::milliseconds{50});
}

// Where the service keeps what a reboot forgets; "" when we are not its.
fs::path service_folder() { return machine::folder_in("RUNTIME_DIRECTORY"); }

// The service's, or that of whoever sits at a terminal: only people can be told to correct a line before anything runs.
bool is_service(const Options& options) { return options.is_service || !service_folder().empty(); }

bool has_desktop() { return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr; }

// What holds over any settings of this run.
void adjust(const Options& options, staff::Mode mode, site::Configuration& configuration) {
    override_by(options, configuration);
    // A service waits for its screen; it does not play to nobody because none is there yet.
    if (is_service(options) && configuration.screen.display == "auto" && !has_desktop())
        configuration.screen.display = "kms";
    if (mode != staff::Mode::Safe) return;
    configuration.picture.alpha = std::min(configuration.picture.alpha, kSafeAlpha);
    configuration.picture.land_samples = std::min(configuration.picture.land_samples, kSafeLand);
}

// What the failures so far call for, before anything is opened.
void climb(staff::Ladder& ladder) {
    const staff::Rung& rung = ladder.rung();
    if (rung.mode == staff::Mode::Usual) return;
    if (rung.is_wished)
        base::log::info("safe mode: as staff wish; low detail, no pictures are kept");
    else
        base::log::error("safe mode: {} failures in ten minutes; low detail, no pictures are kept", rung.failures);
    if (rung.remedy == staff::Remedy::Reboot) {
        if (ladder.note_reboot()) {
            base::log::error("safe mode: it goes on failing; asking for a reboot");
            base::write_file(service_folder() / staff::kPowerAsked, "reboot\n");
        } else {
            base::log::error("safe mode: a reboot could not be written down, so none is asked for");
        }
    }
    if (rung.failures >= staff::kFailuresToReboot) wait_unless_stopped(kBreather);
}

std::unique_ptr<base::Clock> clock_for(const Options& options, bool is_simulated) {
    if (options.speed != 1) return std::make_unique<base::HastyClock>(options.speed);
    if (is_simulated) return std::make_unique<base::SimulatedClock>();
    return std::make_unique<base::SteadyClock>();
}

Buttons buttons_for(const site::Configuration& configuration, const display::Display& screen, base::Seed seed,
                    bool is_demonstration) {
    Buttons buttons;
    if (is_demonstration) {
        buttons.source = scripted_visitor(configuration.visit.rounds, seed);
        return buttons;
    }
    return open_buttons(configuration.inputs.empty() ? site::default_inputs(screen.kind()) : configuration.inputs);
}

// Settings, and what they name, opened.
struct Opened {
    site::Settings settings;
    std::unique_ptr<display::Display> screen;
    bool is_demonstration = false;
    Buttons buttons;
};

Opened open_with(site::Settings settings, const Options& options, staff::Mode mode, base::Seed seed) {
    adjust(options, mode, settings.configuration);
    Opened opened;
    opened.screen = display::open_display(site::display_options(settings.configuration));
    opened.is_demonstration = !options.is_wall && needs_a_visitor(settings.configuration, *opened.screen);
    if (opened.is_demonstration) settings.configuration.visit.rounds_more = 0;
    opened.buttons = buttons_for(settings.configuration, *opened.screen, seed, opened.is_demonstration);
    opened.settings = std::move(settings);
    return opened;
}

site::Settings settings_for(const Options& options, const fs::path& state, const staff::Rung& rung) {
    if (!is_service(options)) return site::settings_for_people(options.configuration, state);
    site::Settings settings = site::settings_for_service(options.configuration, state);
    return rung.failures >= staff::kFailuresToSafety ? site::safe_settings(std::move(settings), state, rung.failures)
                                                     : settings;
}

// For a service, settings that cannot be opened give way to others until some can.
Opened open_what_works(site::Settings settings, const Options& options, const fs::path& state, staff::Mode mode,
                       base::Seed seed) {
    for (;;) {
        try {
            Opened opened = open_with(settings, options, mode, seed);
            site::tell(opened.settings);
            return opened;
        } catch (const base::InputError& error) {
            if (!is_service(options)) throw;
            auto next =
                site::next_settings(settings, state, site::mistake_from(options.configuration, 0, error.what()));
            if (!next) throw;
            settings = std::move(*next);
        }
    }
}

archive::Archive open_archive(const fs::path& state, const archive::TellKept& tell) {
    using Condition = archive::Archive::Condition;
    auto opened = archive::Archive::open(state, wall_time(), {}, tell);
    const bool is_trouble = opened.condition == Condition::Replaced || opened.condition == Condition::MemoryOnly;
    base::log::write(is_trouble ? base::log::Level::Warning : base::log::Level::Info, "state: " + opened.message);
    return std::move(opened.archive);
}

// What the last run left is read while the screen is set up. A disk that takes longer keeps nobody from a picture.
archive::Kept kept_by(learning::Keeper& keeper, const base::Clock& clock) {
    constexpr std::chrono::milliseconds kPatience{400};
    constexpr std::chrono::hours kUntilItIsKnown{1};
    if (const auto kept = keeper.kept_within(clock.is_simulated() ? kUntilItIsKnown : kPatience)) return *kept;
    base::log::info("state: the disk has not answered yet; the show begins without it");
    return {};
}

// A simulated clock has no late frames, and a budget is for seeing what another machine draws.
tempo::TempoOptions tempo_for(const Options& options, const site::Configuration& configuration,
                              const base::Clock& clock, std::string_view remembered, const std::string& gpu) {
    const auto most = static_cast<float>(configuration.picture.alpha);
    const bool is_fixed = clock.is_simulated() || options.budget.is_bound();
    tempo::TempoOptions tempo{is_fixed ? tempo::Governing::Fixed : tempo::Governing::ByFrames,
                              tempo::options_for(most, is_fixed ? "" : remembered, gpu)};
    if (options.budget.is_bound()) tempo.budget = options.budget;
    return tempo;
}

// Its name. The same wherever a visit is to come out as it was: a simulated clock knows no day.
std::string put_on_theme(site::Configuration& configuration, const base::Clock& clock, const fs::path& state) {
    std::optional<std::chrono::year_month_day> day;
    if (!clock.is_simulated() && !configuration.themes.empty())
        day = site::day_on(site::read_wall_clock(site::LastTimeSeen(state)));
    std::string theme = site::theme_on(configuration, day);
    configuration = site::with_theme(std::move(configuration), theme);
    return theme;
}

void finish(pictures::Album& album) {
    album.finish();
    std::printf("%zu pictures and contact-sheet.png are in %s\n", album.count(),
                fs::absolute(album.folder()).lexically_normal().c_str());
}

std::unique_ptr<pictures::Album> album_for(const Options& options, bool is_demonstration, int rounds) {
    const std::string folder = options.capture.empty() && is_demonstration ? "quadrat-pictures" : options.capture;
    if (is_demonstration)
        base::log::info("no screen and no buttons here: a visitor of {} rounds is played, pictures go to {}", rounds,
                        folder);
    return folder.empty() ? nullptr : std::make_unique<pictures::Album>(folder);
}

int exhibit_until_the_end(const Options& options, staff::Ladder& ladder, const fs::path& state) {
    climb(ladder);
    const staff::Mode mode = ladder.rung().mode;
    const bool is_safe = mode == staff::Mode::Safe;
    site::Settings settings = settings_for(options, state, ladder.rung());
    site::use_zone(settings.configuration.zone);  // before any thread may ask for the time
    auto keeper = std::make_unique<learning::Keeper>(
        [state](const archive::TellKept& tell) { return open_archive(state, tell); });
    const base::Seed seed = seed_for(options);
    Opened opened = open_what_works(std::move(settings), options, state, mode, seed);
    const site::Settings begun_with = opened.settings;
    site::Configuration& configuration = opened.settings.configuration;
    const auto& screen = opened.screen;
    Buttons& buttons = opened.buttons;
    const bool is_demonstration = opened.is_demonstration;

    const auto album = is_safe ? nullptr : album_for(options, is_demonstration, configuration.visit.rounds);

    const auto clock = clock_for(options, screen->kind() == "headless" && buttons.is_all_scripted);
    const std::string theme = put_on_theme(configuration, *clock, state);
    const archive::Kept kept = kept_by(*keeper, *clock);
    staff::Panel panel(*buttons.source, staff::health_memory_from(kept.buttons));
    const nursery::NurseryOptions growing{0, pictures::fineness_of(configuration.picture.land_samples)};
    kiosk::ShowOptions show_options{seed, growing, wall_time, local_time, state};
    if (options.is_wall) show_options.works = works_beside(state.parent_path(), configuration);
    kiosk::Show show(configuration, show_options, std::move(keeper));
    std::optional<staff::Caretaker> caretaker;
    std::optional<staff::Keepsakes> keepsakes;
    std::optional<staff::Presence> presence;
    if (!clock->is_simulated()) {
        presence.emplace(machine::runtime_folder(state));
        keepsakes.emplace(state);
        staff::CaretakerParts parts{configuration, begun_with, machine::runtime_folder(state), state, ladder, *screen};
        parts.theme = theme;
        parts.adjust = [&options, mode](site::Configuration& changed) { adjust(options, mode, changed); };
        parts.keeps_settings = is_service(options);
        caretaker.emplace(parts);
    }
    tempo::Tempo tempo(tempo_for(options, configuration, *clock, kept.detail, screen->renderer()));
    kiosk::RunLoopParts parts{configuration, *clock, *screen, panel, *buttons.source, show, tempo};
    if (caretaker) parts.attendant = &*caretaker;
    if (keepsakes) parts.keepsakes = &*keepsakes;
    parts.mode = ladder.rung().mode;
    const bool is_known = tempo::is_profile_of(kept.gpu, screen->renderer());
    if (is_known) base::log::info("GPU, as it was measured: {}", kept.gpu);
    parts.calibrates = !is_safe && !is_known;
    parts.album = album.get();
    parts.ends_after_visit = options.rounds.has_value() || is_demonstration;
    parts.stop = &stop_flag();
    parts.seed = seed;
    const kiosk::RunEnd end = kiosk::run_loop(parts);
    machine::announce_stopping();
    show.remember("buttons", staff::to_text(panel.health().memory()));
    if (tempo.is_governed()) show.remember("detail", to_text(tempo.governor(), screen->renderer()));
    if (end != kiosk::RunEnd::DisplayFault) ladder.note_end();
    if (album) finish(*album);
    return status_of(end);
}

int run(const Options& options) {
    machine::hold_memory();  // until the first landscapes are on the screen
    if (!options.log_file.empty()) base::log_to_file_too(options.log_file);
    stop_on_signals();
    const fs::path of_exhibit = site::state_folder(options.state);
    const fs::path state = options.is_wall ? of_exhibit / kWallState : of_exhibit;
    std::error_code ignored;
    if (options.is_wall) fs::create_directories(state, ignored);
    const backup::Starter starter = is_service(options) ? backup::Starter::Service : backup::Starter::Hand;
    const backup::ExhibitsHold hold = backup::hold_state_for_the_exhibit(state, starter, stop_flag());
    if (hold.was_stopped) return 0;
    staff::Ladder ladder(service_folder(), state, machine::uptime());
    if (fs::remove(machine::runtime_folder(state) / staff::kUsualAsked, ignored)) ladder.forgive();
    if (fs::exists(machine::runtime_folder(state) / staff::kSafeMode, ignored)) ladder.keep_safe();
    try {
        return exhibit_until_the_end(options, ladder, state);
    } catch (const base::InputError&) {
        // What is asked for is wrong, not the machine; and a service that starts us at once again need not spin.
        ladder.note_end();
        if (is_service(options)) wait_unless_stopped(kBreather);
        throw;
    }
}

}  // namespace

void add_run(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand("run", "The exhibit");
    command.add_option("--display", options->display, "auto, kms, window or headless")
        .among({"auto", "kms", "window", "headless"})
        .tells_default("the settings', else auto");
    command.add_option("--size", options->size, "Pixels to draw, as 1280x720; without it, the screen's")
        .tells_default("the settings', else the screen's");
    command
        .add_option("--input", options->inputs,
                    "Where presses come from, repeatable: gpio:A=GPIO17,…  hid:  evdev:  keyboard  script:FILE")
        .tells_default("the settings', else hid:, and the keyboard in a window");
    command.add_option("--config", options->configuration, "The site's settings (deploy/quadrat.toml shows all)")
        .tells_default("none");
    command.add_flag("--service", options->is_service,
                     "Start whatever the settings are: with a mistake in them, with the last that worked or the\n"
                     "defaults, and say so. Without it, as in $RUNTIME_DIRECTORY's absence, mistakes end with 2");
    command.add_option("--state", options->state, "Folder of what is kept between runs")
        .tells_default("the service's, else ~/.local/state/quadrat");
    command.add_flag("--gallery", options->is_wall,
                     "No visit: what the visitors of an exhibit bred hangs here in turn, with its words, and what its\n"
                     "staff chose. --state and --config are that exhibit's; it may run beside");
    command.add_option("--rounds", options->rounds, "Rounds of a visit; the program ends after one visit")
        .between(1, 50)
        .tells_default("the settings', without an end");
    command.add_option("--ground", options->ground, "What draws the land: blocks (standard) or roam")
        .among(render::ground_names())
        .tells_default("the settings', else blocks");
    command.add_option("--capture", options->capture, "Folder for one PNG a generation, the finale and a contact sheet")
        .tells_default("none");
    command.add_option("--seed", options->seed, "Names all chance; without it, every start is another")
        .tells_default("another every start");
    command
        .add_option("--triangles", options->budget.triangles,
                    "No more a frame, whatever this machine could draw: for tests")
        .tells_default("no limit");
    command.add_option("--pixels", options->budget.pixels, "The same for the pixels of the landscapes")
        .tells_default("no limit");
    command
        .add_option("--log-file", options->log_file,
                    "Write the log there too: appended; three files of before, 4 MB each, are kept")
        .tells_default("none");
    command
        .add_option("--speed", options->speed, "How many times as fast the clock runs, 1 to 100: for endurance tests")
        .between(1.0, 100.0)
        .shows_default();
    command.does([options] { return run(*options); });
}

}  // namespace quadrat::commands
