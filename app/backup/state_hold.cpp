// SPDX-License-Identifier: Apache-2.0
#include "backup/state_hold.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <thread>

#include "backup/staged.hpp"
#include "base/error.hpp"
#include "base/log.hpp"
#include "machine/service.hpp"

namespace quadrat::backup {
namespace {

namespace fs = std::filesystem;
using archive::LockHolder;

constexpr std::chrono::milliseconds kLookEvery{200};
constexpr std::chrono::seconds kMoreTime{30};  // is asked for of the service manager, again and again

archive::LockHolder the_exhibit(Starter starter) {
    return {"the exhibit", "", "", "",
            starter == Starter::Service ? "systemctl stop quadrat" : fmt::format("kill {}", ::getpid())};
}

std::string in_use(const fs::path& folder, const archive::LockHolder& holder) {
    return fmt::format("{} is in use by {}", folder.string(), to_text(holder));
}

void complete_restore(const fs::path& folder) {
    try {
        if (complete(folder)) base::log::warn("state: a restore that was interrupted is complete now");
    } catch (const base::InputError& error) {
        base::log::error("state: a restore was interrupted and cannot be completed: {}", error.what());
    }
}

// Nothing: told to stop.
std::optional<archive::LockAttempt> wait_for_it(const fs::path& folder, const archive::LockHolder& self,
                                                archive::LockAttempt attempt, const std::atomic<bool>& stop) {
    std::string told;
    while (attempt.holder) {
        if (stop) return std::nullopt;
        if (const std::string now = in_use(folder, *attempt.holder); now != told) {
            told = now;
            base::log::warn("state: {}; the exhibit waits until that ends{}", now,
                            attempt.holder->how_to_end.empty() ? "" : ": " + attempt.holder->how_to_end);
            machine::tell_status("waits: " + now);
        }
        machine::ask_for_time(kMoreTime);
        std::this_thread::sleep_for(kLookEvery);
        attempt = archive::try_lock(folder, self);
    }
    machine::tell_status("");
    return attempt;
}

}  // namespace

archive::StateLock hold_state(const fs::path& folder, const std::string& tool) {
    auto lock = archive::lock_or_refuse(folder, {tool, "", "", "", ""});
    complete_restore(folder);
    return lock;
}

ExhibitsHold hold_state_for_the_exhibit(const fs::path& folder, Starter starter, const std::atomic<bool>& stop) {
    std::error_code ignored;  // where it cannot be made, it cannot be locked
    fs::create_directories(folder, ignored);
    const archive::LockHolder self = the_exhibit(starter);
    archive::LockAttempt attempt = archive::try_lock(folder, self);
    if (attempt.holder && starter == Starter::Hand)
        throw base::InputError(fmt::format("{}; end that first: {}; or name another folder with --state",
                                           in_use(folder, *attempt.holder), attempt.holder->how_to_end));
    if (attempt.holder) {
        auto waited = wait_for_it(folder, self, std::move(attempt), stop);
        if (!waited) return {{}, true};
        attempt = std::move(*waited);
    }
    if (attempt.lock)
        complete_restore(folder);
    else
        base::log::warn("state: {}; whether another exhibit uses this folder is not known", attempt.trouble);
    return {std::move(attempt.lock), false};
}

}  // namespace quadrat::backup
