// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "firmware-io/gpio/gpio_host.hpp"

namespace quadrat::firmware_io::gpio {

// The chips of this machine through libgpiod's C interface. libgpiod_v1.cpp or libgpiod_v2.cpp defines it, whichever
// the library was built for.
std::unique_ptr<GpioHost> open_libgpiod();

// The character devices /dev/gpiochip*, sorted. Links are left out: Raspberry Pi OS puts one beside the true node.
std::vector<std::string> chip_paths();

}  // namespace quadrat::firmware_io::gpio
