// SPDX-License-Identifier: Apache-2.0
#include "commands/staff_acts.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>

#include "base/error.hpp"
#include "base/log.hpp"
#include "base/owned.hpp"
#include "staff/presence.hpp"
#include "staff/watch.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;
using std::chrono::system_clock;

constexpr std::uintmax_t kMostNotes = 256 * 1024;

std::string date_of(system_clock::time_point at) {
    return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(system_clock::to_time_t(at)));
}

// What is asked of nobody would surprise whoever starts next.
void require_exhibit(const fs::path& runtime) {
    if (!staff::is_exhibit_present(runtime)) throw base::InputError("no exhibit runs here that could do that");
}

}  // namespace

void note_act(const fs::path& state, const std::string& by, const std::string& what) {
    base::log::info("{}: {}", by, what);
    const fs::path file = state / kActsNoted;
    std::error_code ignored;
    if (fs::file_size(file, ignored) > kMostNotes && !ignored) fs::rename(file, file.string() + ".1", ignored);
    const base::OwnedDescriptor notes(::open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600));
    const std::string line = fmt::format("{} {}\n", date_of(system_clock::now()), what);
    if (!notes || ::write(notes.get(), line.data(), line.size()) != static_cast<ssize_t>(line.size()))
        base::log::warn("what was done could not be noted in {}", file.string());
}

// Without a flush: what is asked for is of this moment.
void ask_by(const fs::path& file) {
    const base::OwnedDescriptor asked(::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644));
    if (!asked) throw base::InputError(fmt::format("{}: {}", file.string(), std::strerror(errno)));
}

void do_act(const fs::path& runtime, desk::Act act) {
    if (act != desk::Act::Wake) require_exhibit(runtime);
    std::error_code ignored;
    switch (act) {
        case desk::Act::TestLamps:
            return ask_by(runtime / staff::kLampTestAsked);
        case desk::Act::StandBy:
            return ask_by(runtime / staff::kStandBy);
        case desk::Act::Wake:
            fs::remove(runtime / staff::kStandBy, ignored);
            return;
        case desk::Act::SafeMode:
            ask_by(runtime / staff::kSafeMode);
            return ask_by(runtime / staff::kRestartAsked);
        case desk::Act::UsualMode:
            fs::remove(runtime / staff::kSafeMode, ignored);
            ask_by(runtime / staff::kUsualAsked);
            return ask_by(runtime / staff::kRestartAsked);
        case desk::Act::Restart:
            return ask_by(runtime / staff::kRestartAsked);
    }
}

}  // namespace quadrat::commands
