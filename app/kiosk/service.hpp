// SPDX-License-Identifier: Apache-2.0
#pragma once

// What systemd is told, when it started us; otherwise nothing happens.
namespace quadrat::kiosk {

void announce_ready();  // landscapes are on the screen
void feed_watchdog();   // a frame was completed, or there is legitimately no screen
void announce_stopping();

}  // namespace quadrat::kiosk
