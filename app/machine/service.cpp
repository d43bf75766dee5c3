// SPDX-License-Identifier: Apache-2.0
#include "machine/service.hpp"

#include <systemd/sd-daemon.h>

#include <string>

namespace quadrat::machine {

void ask_for_time(std::chrono::seconds longer) {
    const auto microseconds = std::chrono::microseconds{longer}.count();
    sd_notify(0, ("EXTEND_TIMEOUT_USEC=" + std::to_string(microseconds)).c_str());
}
void announce_ready() { sd_notify(0, "READY=1"); }
void feed_watchdog() { sd_notify(0, "WATCHDOG=1"); }
void tell_status(const std::string& line) { sd_notify(0, ("STATUS=" + line).c_str()); }
void announce_stopping() { sd_notify(0, "STOPPING=1"); }

}  // namespace quadrat::machine
