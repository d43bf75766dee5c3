// SPDX-License-Identifier: Apache-2.0
#include "desk/desk.hpp"

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

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "commands/commands.hpp"
#include "commands/desk_sources.hpp"
#include "desk/pages.hpp"
#include "desk/passphrase.hpp"
#include "desk/server.hpp"
#include "machine/machine.hpp"
#include "site/settings.hpp"
#include "site/state_folder.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::string configuration, state, runtime, log;
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
                                                       : site::settings_for_people(options.configuration, state);
    const site::Configuration::Desk& wanted = settings.configuration.desk;
    if (wanted.listen.empty()) {
        base::log::info("desk: the settings name no address (desk.listen), so nothing listens");
        return 0;
    }
    const base::ListenAddress address = base::parse_listen_address(wanted.listen);
    require_safe(wanted, address);
    if (std::error_code error; !fs::is_regular_file(state / kPassphraseFile, error))
        throw base::InputError(fmt::format("{}: there is no passphrase yet: quadrat desk --set-passphrase",
                                           (state / kPassphraseFile).string()));
    const fs::path runtime = options.runtime.empty() ? machine::runtime_folder(state) : fs::path(options.runtime);
    desk::Desk desk(
        desk_sources({options.configuration, options.state, state, runtime, options.log}, settings.configuration),
        random_bytes, !wanted.certificate.empty());
    // Taken by this thread alone, below; the server's inherits that it does not hear them.
    sigset_t ends{};
    ::sigemptyset(&ends);
    ::sigaddset(&ends, SIGTERM);
    ::sigaddset(&ends, SIGINT);
    ::pthread_sigmask(SIG_BLOCK, &ends, nullptr);
    ::signal(SIGPIPE, SIG_IGN);
    const desk::ServerOptions how{address,
                                  wanted.certificate.empty() ? "" : base::read_file(wanted.certificate, 1U << 16U),
                                  wanted.key.empty() ? "" : base::read_file(wanted.key, 1U << 16U),
                                  state / kBroughtFile, std::size_t{desk::kMostUpload_MB} << 20U};
    const auto since_begin = [begun = std::chrono::steady_clock::now()] {
        return std::chrono::duration_cast<desk::Instant>(std::chrono::steady_clock::now() - begun);
    };
    const desk::Server server(
        how, {[&](const desk::Request& request) { return desk.answer(request, since_begin()); },
              [&](const desk::Request& request) { return desk.takes_file(request, since_begin()); },
              [&](const desk::Request& request) { return desk.takes_long_form(request, since_begin()); }});
    base::log::info("desk: listens on {}://{}", how.certificate.empty() ? "http" : "https", base::to_text(address));
    int signal = 0;
    ::sigwait(&ends, &signal);
    return 0;
}

}  // namespace

void add_desk(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command =
        program.add_subcommand("desk",
                               "A page for staff in any browser, in six languages, until told to stop: how the "
                               "exhibit is, what it shows, its buttons\n"
                               "and lamps, stand-by, restart, safe mode, faults, the log, the doctor, what "
                               "visitors did, a backup and its restore.\n"
                               "It listens where the settings say so ([desk]), and asks for a passphrase");
    command.add_option("--config", options->configuration, "The site's settings; [desk] says where it listens")
        .tells_default("none: nothing listens");
    command.add_flag("--service", options->is_service,
                     "With a mistake in the settings, serve by the last with which the exhibit worked");
    command.add_option("--state", options->state, "The exhibit's state folder")
        .tells_default("the service's, else ~/.local/state/quadrat");
    command.add_option("--runtime", options->runtime, "Where the exhibit writes its health, as /run/quadrat")
        .tells_default("the service's, else the state folder");
    command
        .add_option("--log", options->log, "The log of an exhibit that was started by hand, as run --log-file names it")
        .tells_default("the service's journal");
    command.add_flag(
        "--set-passphrase", options->sets_passphrase,
        "Instead: ask for the passphrase of the staff, or read it from standard input, and keep its hash in\n"
        "the state folder");
    command.does([options] { return serve(*options); });
}

}  // namespace quadrat::commands
