// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <string>

// What systemd is told, when it started us; otherwise nothing happens.
namespace quadrat::machine {

void ask_for_time(std::chrono::seconds longer);  // before being ready: from now on, as it gets on
void announce_ready();                           // a frame with landscapes was handed over
void feed_watchdog();                            // a frame was completed, or there is legitimately no screen
void tell_status(const std::string& line);       // what systemctl status shows; "": nothing worth it
void announce_stopping();

}  // namespace quadrat::machine
