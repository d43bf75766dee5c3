// SPDX-License-Identifier: Apache-2.0
#include "desk/desk.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "archive/visit_rows.hpp"
#include "backup/backup.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/owned.hpp"
#include "benches/scratch.hpp"
#include "commands/commands.hpp"
#include "commands/examine.hpp"
#include "commands/visits.hpp"
#include "desk/passphrase.hpp"
#include "desk/server.hpp"
#include "machine/machine.hpp"
#include "machine/version.hpp"
#include "report/writers.hpp"
#include "site/settings.hpp"
#include "site/state_folder.hpp"
#include "staff/presence.hpp"
#include "staff/watch.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPassphraseFile = "desk.passphrase";
constexpr const char* kNotes = "desk.log";  // what was done, and by whom
constexpr std::uintmax_t kMostNotes = 256 * 1024;

struct Options {
    std::string configuration, state, runtime;
    bool is_service = false;
    bool sets_passphrase = false;
};

std::string random_bytes(std::size_t count) {
    std::string bytes(count, '\0');
    std::size_t got = 0;
    while (got < count) {
        const ssize_t some = ::getrandom(bytes.data() + got, count - got, 0);
        if (some < 0 && errno != EINTR) throw base::InputError("the system gives no random numbers");
        if (some > 0) got += static_cast<std::size_t>(some);
    }
    return bytes;
}

// Without an echo where somebody types; else a line of what is piped in.
std::string read_secret(const char* prompt) {
    std::string secret;
    const bool is_typed = ::isatty(STDIN_FILENO) == 1;
    termios before{};
    if (is_typed) {
        std::fputs(prompt, stderr);
        ::tcgetattr(STDIN_FILENO, &before);
        termios silent = before;
        silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
        ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &silent);
    }
    std::getline(std::cin, secret);
    if (is_typed) {
        ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &before);
        std::fputs("\n", stderr);
    }
    return secret;
}

int set_passphrase(const Options& options) {
    const fs::path folder = site::tended_state_folder(options.state);
    struct stat owner {};
    if (::stat(folder.c_str(), &owner) != 0)
        throw base::InputError(
            fmt::format("{}: there is no such folder; name the state's with --state", folder.string()));
    const fs::path file = folder / kPassphraseFile;
    base::require_writable(file);
    const std::string secret = read_secret("Passphrase for the desk: ");
    const std::string hash = desk::hash_of(secret, random_bytes(desk::kSaltBytes));
    if (::isatty(STDIN_FILENO) == 1 && read_secret("Once more: ") != secret)
        throw base::InputError("the two are not the same; nothing was changed");
    const mode_t mask = ::umask(077);
    base::write_file(file, hash + "\n");
    ::umask(mask);
    // The service reads it, whoever set it.
    if (::geteuid() == 0 && ::lchown(file.c_str(), owner.st_uid, owner.st_gid) != 0)
        throw base::InputError(
            fmt::format("{}: the service cannot read it: give it to the folder's owner", file.string()));
    std::printf("%s\n", file.c_str());
    return 0;
}

// A line each; the file before it is kept as well.
void note_in(const fs::path& folder, const std::string& what) {
    base::log::info("desk: {}", what);
    const fs::path file = folder / kNotes;
    std::error_code ignored;
    if (fs::file_size(file, ignored) > kMostNotes && !ignored) fs::rename(file, file.string() + ".1", ignored);
    const base::OwnedDescriptor notes(::open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600));
    const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    const std::string line = fmt::format("{:%Y-%m-%d %H:%M:%S} UTC {}\n", fmt::gmtime(now), what);
    if (notes.get() < 0 || ::write(notes.get(), line.data(), line.size()) != static_cast<ssize_t>(line.size()))
        base::log::warn("desk: what was done could not be noted in {}", file.string());
}

std::optional<std::string> read_if_there(const fs::path& file, std::size_t most) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return std::nullopt;
    try {
        return base::read_file(file, most);
    } catch (const base::InputError&) {
        return std::nullopt;  // it went away meanwhile
    }
}

// What the exhibit drew in the last seconds. Whoever asks gets what lies there, and has the next one made.
std::optional<std::string> glance(const fs::path& runtime) {
    if (!staff::is_exhibit_present(runtime)) return std::nullopt;
    constexpr std::chrono::seconds kOld{10};
    const fs::path file = runtime / staff::kGlance;
    std::error_code error;
    if (!fs::exists(runtime / staff::kGlanceAsked, error)) base::write_file(runtime / staff::kGlanceAsked, "");
    const auto written = fs::last_write_time(file, error);
    if (error || fs::file_time_type::clock::now() - written > kOld) return std::nullopt;
    return read_if_there(file, 16U << 20U);
}

void do_act(const fs::path& runtime, desk::Act act) {
    // What is asked of nobody would surprise whoever starts next.
    if (act != desk::Act::Wake && !staff::is_exhibit_present(runtime))
        throw base::InputError("no exhibit runs here that could do that");
    std::error_code ignored;
    switch (act) {
        case desk::Act::StandBy:
            return base::write_file(runtime / staff::kStandBy, "");
        case desk::Act::Wake:
            fs::remove(runtime / staff::kStandBy, ignored);
            return;
        case desk::Act::Restart:
            return base::write_file(runtime / staff::kRestartAsked, "");
    }
}

std::vector<desk::Finding> findings_of(const Options& options) {
    constexpr const char* kWords[]{"good", "doubtful", "bad"};
    std::vector<desk::Finding> findings;
    for (const doctor::Finding& one : examine_parts(options.configuration, options.state))
        findings.push_back({one.subject, kWords[static_cast<std::size_t>(one.health)], one.what, one.remedy});
    return findings;
}

std::string backup_of(const fs::path& state, const fs::path& settings) {
    const auto now = std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
    const benches::Scratch folder;
    const fs::path file = folder.path / "quadrat-backup.tar.xz";
    backup::write_backup({state, settings, now}, file, [](const std::string&, double) {});
    return base::read_file(file, std::size_t{512} << 20U);
}

desk::Sources sources_for(const Options& options, const site::Configuration& configuration, const fs::path& state,
                          const fs::path& runtime, const std::string& hash) {
    desk::Sources sources;
    sources.exhibit = configuration.fleet.name;
    sources.version = std::string(machine::version());
    // What an exhibit said that has ended since lies there too.
    sources.health = [runtime]() -> std::optional<std::string> {
        if (!staff::is_exhibit_present(runtime)) return std::nullopt;
        return read_if_there(runtime / "health.json", 1U << 20U);
    };
    sources.picture = [runtime] { return glance(runtime); };
    sources.examine = [options] { return findings_of(options); };
    sources.report = [state, title = configuration.fleet.name] {
        return report::html_of(count_visits(state, {}), heading_of(title.empty() ? "Visitors of the exhibit" : title));
    };
    sources.backup = [state, file = fs::path(options.configuration)] { return backup_of(state, file); };
    sources.act = [runtime](desk::Act act) { do_act(runtime, act); };
    sources.note = [state](const std::string& what) { note_in(state, what); };
    sources.is_passphrase = [hash](const std::string& passphrase) { return desk::is_passphrase(passphrase, hash); };
    return sources;
}

void require_safe(const site::Configuration::Desk& desk, const base::ListenAddress& address) {
    if (desk.certificate.empty() != desk.key.empty())
        throw base::InputError("desk.certificate and desk.key go together");
    if (!address.is_loopback && desk.certificate.empty())
        throw base::InputError(fmt::format(
            "desk.listen is {}, which other machines reach: the passphrase would go there unencrypted; name "
            "desk.certificate and desk.key, or listen on 127.0.0.1",
            base::to_text(address)));
}

int serve(const Options& options) {
    if (options.sets_passphrase) return set_passphrase(options);
    const fs::path state = site::state_folder(options.state);
    const site::Settings settings = options.is_service ? site::settings_for_service(options.configuration, state)
                                                       : site::settings_for_people(options.configuration);
    const site::Configuration::Desk& wanted = settings.configuration.desk;
    if (wanted.listen.empty()) {
        base::log::info("desk: the settings name no address (desk.listen), so nothing listens");
        return 0;
    }
    const base::ListenAddress address = base::parse_listen_address(wanted.listen);
    require_safe(wanted, address);
    const auto hash = read_if_there(state / kPassphraseFile, 1024);
    if (!hash)
        throw base::InputError(fmt::format("{}: there is no passphrase yet: quadrat desk --set-passphrase",
                                           (state / kPassphraseFile).string()));
    const fs::path runtime = options.runtime.empty() ? machine::runtime_folder(state) : fs::path(options.runtime);
    desk::Desk desk(sources_for(options, settings.configuration, state, runtime, hash->substr(0, hash->find('\n'))),
                    random_bytes, !wanted.certificate.empty());
    // Taken by this thread alone, below; the server's inherits that it does not hear them.
    sigset_t ends{};
    ::sigemptyset(&ends);
    ::sigaddset(&ends, SIGTERM);
    ::sigaddset(&ends, SIGINT);
    ::pthread_sigmask(SIG_BLOCK, &ends, nullptr);
    ::signal(SIGPIPE, SIG_IGN);
    const auto begun = std::chrono::steady_clock::now();
    const desk::ServerOptions how{address,
                                  wanted.certificate.empty() ? "" : base::read_file(wanted.certificate, 1U << 16U),
                                  wanted.key.empty() ? "" : base::read_file(wanted.key, 1U << 16U)};
    const desk::Server server(how, [&](const desk::Request& request) {
        return desk.answer(request,
                           std::chrono::duration_cast<desk::Instant>(std::chrono::steady_clock::now() - begun));
    });
    base::log::info("desk: listens on {}://{}", how.certificate.empty() ? "http" : "https", base::to_text(address));
    int signal = 0;
    ::sigwait(&ends, &signal);
    return 0;
}

}  // namespace

void add_desk(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("desk",
                                           "A page for staff in any browser, until told to stop: how the exhibit is, "
                                           "what it shows, stand-by and restart,\n"
                                           "the doctor, what visitors did, a backup. It listens where the settings say "
                                           "so ([desk]), and asks for a passphrase");
    command->add_option("--config", options->configuration, "The site's settings; [desk] says where it listens")
        ->default_str("none: nothing listens");
    command->add_flag("--service", options->is_service,
                      "With a mistake in the settings, serve by the last with which the exhibit worked");
    command->add_option("--state", options->state, "The exhibit's state folder")
        ->default_str("the service's, else ~/.local/state/quadrat");
    command->add_option("--runtime", options->runtime, "Where the exhibit writes its health, as /run/quadrat")
        ->default_str("the service's, else the state folder");
    command->add_flag(
        "--set-passphrase", options->sets_passphrase,
        "Instead: ask for the passphrase of the staff, or read it from standard input, and keep its hash in\n"
        "the state folder");
    command->callback([options, &chosen] { chosen = [options] { return serve(*options); }; });
}

}  // namespace quadrat::commands
