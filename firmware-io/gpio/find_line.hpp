// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string_view>

#include "firmware-io/gpio/gpio_host.hpp"

namespace quadrat::firmware_io::gpio {

// A line as people write it: by name ("GPIO17"), or by chip and offset. The chip is its path or a link to it
// ("/dev/gpiochip0:17"), its node's name or number ("gpiochip0:17", "0:17"), or its label ("pinctrl-rp1:17").
struct LineAddress {
    std::string name;  // "" if given by place
    LinePlace place;
    friend bool operator==(const LineAddress&, const LineAddress&) = default;
};
std::string to_string(const LineAddress& address);

// Where the line is. A name is looked for on the chips whose label begins "pinctrl-" (the header of a Raspberry Pi,
// whatever number its chip has this year), then on all chips. Throws GpioError with the remedy: no such line, two of
// that name or two chips of that label, held by someone else, or no chip may be opened. Held by `us`, it is as good as
// free. Looks at the file system for a link, and at nothing else.
LinePlace find_line(std::span<const ChipFacts> chips, const LineAddress& address, std::string_view us = {});

}  // namespace quadrat::firmware_io::gpio
