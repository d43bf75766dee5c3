// SPDX-License-Identifier: Apache-2.0
#include "kiosk/service.hpp"

#include <systemd/sd-daemon.h>

namespace quadrat::kiosk {

void announce_ready() { sd_notify(0, "READY=1"); }
void feed_watchdog() { sd_notify(0, "WATCHDOG=1"); }
void announce_stopping() { sd_notify(0, "STOPPING=1"); }

}  // namespace quadrat::kiosk
