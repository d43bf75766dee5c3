// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/gpio/find_line.hpp"

#include <algorithm>

#include "firmware-io/device.hpp"

namespace quadrat::firmware_io::gpio {
namespace {

bool is_header(const ChipFacts& chip) { return chip.label.starts_with("pinctrl-"); }

std::vector<LinePlace> places_of(std::span<const ChipFacts> chips, std::string_view name, bool on_header_only) {
    std::vector<LinePlace> places;
    for (const ChipFacts& chip : chips) {
        if (on_header_only && !is_header(chip)) continue;
        for (std::size_t offset = 0; offset < chip.lines.size(); ++offset)
            if (chip.lines[offset].name == name) places.push_back({chip.path, static_cast<unsigned>(offset)});
    }
    return places;
}

std::string to_string(const LinePlace& place) { return place.chip_path + ":" + std::to_string(place.offset); }

[[noreturn]] void refuse_missing(std::span<const ChipFacts> chips, const std::string& what) {
    if (chips.empty()) throw GpioError{what + ": this machine has no GPIO chip; use hid: or load the chip's driver"};
    for (const ChipFacts& chip : chips)
        if (!chip.trouble.empty())
            throw GpioError{what + " not found, and " + chip.path + " cannot be opened (" + chip.trouble +
                            "); add the user to the group that owns it (usually gpio)"};
    throw GpioError{what + " is on no GPIO chip; the command gpioinfo lists the lines"};
}

LinePlace find_by_name(std::span<const ChipFacts> chips, const std::string& name) {
    auto places = places_of(chips, name, true);
    if (places.empty()) places = places_of(chips, name, false);
    if (places.empty()) refuse_missing(chips, "GPIO line " + name);
    if (places.size() > 1)
        throw GpioError{"GPIO line " + name + " is both " + to_string(places[0]) + " and " + to_string(places[1]) +
                        "; write the one you mean instead of its name"};
    return places.front();
}

// The chips that are meant by a path, a link to one (today's Raspberry Pi OS has /dev/gpiochip4 -> gpiochip0, and a
// udev rule may give an expander a name that stays), a node's name, a number or a label.
std::vector<const ChipFacts*> chips_named(std::span<const ChipFacts> chips, const std::string& name) {
    const bool is_number =
        !name.empty() && std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
    std::string path = name.starts_with('/') ? name : is_number ? "/dev/gpiochip" + name : "/dev/" + name;
    const auto matching = [&](auto is_it) {
        std::vector<const ChipFacts*> found;
        for (const ChipFacts& chip : chips)
            if (is_it(chip)) found.push_back(&chip);
        return found;
    };
    auto found = matching([&](const ChipFacts& chip) { return chip.path == path; });
    if (found.empty())
        found = matching([real = without_links(path)](const ChipFacts& chip) { return chip.path == real; });
    if (found.empty()) found = matching([&](const ChipFacts& chip) { return chip.label == name; });
    return found;
}

// A line's own name may end like a place, "SPI:0"; then it is the name that is meant.
LinePlace find_by_place(std::span<const ChipFacts> chips, const LinePlace& place) {
    const std::string name = to_string(place);
    if (!place.chip_path.starts_with('/') && !places_of(chips, name, false).empty()) return find_by_name(chips, name);
    const auto found = chips_named(chips, place.chip_path);
    if (found.size() > 1)
        throw GpioError{"GPIO line " + name + ": both " + found[0]->path + " and " + found[1]->path + " are labelled " +
                        place.chip_path + "; write the path of the one you mean, or of a link to it"};
    if (found.empty()) refuse_missing(chips, "GPIO line " + name);
    if (place.offset >= found.front()->lines.size()) refuse_missing({found.front(), 1}, "GPIO line " + name);
    return {found.front()->path, place.offset};
}

}  // namespace

std::string to_string(const LineAddress& address) {
    return address.name.empty() ? to_string(address.place) : address.name;
}

LinePlace find_line(std::span<const ChipFacts> chips, const LineAddress& address, std::string_view us) {
    LinePlace place = address.name.empty() ? find_by_place(chips, address.place) : find_by_name(chips, address.name);
    const auto chip =
        std::find_if(chips.begin(), chips.end(), [&](const ChipFacts& facts) { return facts.path == place.chip_path; });
    const std::string& holder = chip->lines[place.offset].holder;
    if (!holder.empty() && holder != us)
        throw GpioError{"GPIO line " + to_string(address) + " is held by " + holder +
                        "; stop that, or wire the button to another line"};
    return place;
}

}  // namespace quadrat::firmware_io::gpio
