// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/hid/mapping.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "firmware-io/text.hpp"
#include "firmware-io/text_file.hpp"

namespace quadrat::firmware_io::hid {
namespace {

constexpr std::size_t kMostDevices = 256, kMostBindings = 256;
constexpr std::array<std::string_view, 7> kParts{"pressed", "up", "right", "down", "left", "low", "high"};
constexpr std::string_view kExample = "A = 0009:0001 pressed, collection 0";

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument{why}; }

struct HexPair {
    std::uint16_t first, second;
};

HexPair parse_hex_pair(std::string_view text, std::string_view example) {
    const auto numbers = split(text, ':');
    const auto is_short = [](std::string_view number) { return number.size() <= 4; };
    if (numbers.size() == 2 && std::all_of(numbers.begin(), numbers.end(), is_short)) {
        const auto first = parse_unsigned(numbers[0], 16), second = parse_unsigned(numbers[1], 16);
        if (first && second) return {static_cast<std::uint16_t>(*first), static_cast<std::uint16_t>(*second)};
    }
    refuse(quoted(text) + " is not two hexadecimal numbers; write " + std::string{example});
}

SignalPart part_named(std::string_view name) {
    const auto found = std::find(kParts.begin(), kParts.end(), name);
    if (found == kParts.end())
        refuse(quoted(name) +
               " is no part of a control; write pressed, up, right, down, left, "
               "low or high");
    return static_cast<SignalPart>(found - kParts.begin());
}

Binding parse_binding(std::string_view line) {
    auto words = words_of(line);
    if (words.size() != 6 || words[1] != "=" || !words[3].ends_with(',') || words[4] != "collection")
        refuse(quoted(line) + " is neither device, serial, port nor a binding; write " + std::string{kExample});
    words[3].remove_suffix(1);
    const auto button = button_named(words[0]);
    if (!button) refuse(quoted(words[0]) + " is not a button; a button is A, B, C, D or Back");
    const HexPair pair = parse_hex_pair(words[2], "0009:0001");
    const auto collection = parse_unsigned(words[5]);
    if (!collection || *collection > 0xffff) refuse(quoted(words[5]) + " is not a collection; write 0 for the first");
    return {{static_cast<std::uint16_t>(*collection), usage(pair.first, pair.second), part_named(words[3])}, *button};
}

void parse_line(std::string_view line, std::vector<HidMapping>& mappings) {
    const auto rest_after = [&](std::string_view keyword) { return trimmed(line.substr(keyword.size())); };
    const std::string_view keyword = words_of(line).front();
    if (keyword == "device") {
        const HexPair pair = parse_hex_pair(rest_after(keyword), "device 0079:0006");
        if (mappings.size() == kMostDevices) refuse("there are more than 256 devices; remove those that are gone");
        mappings.push_back({pair.first, pair.second, "", "", {}});
        return;
    }
    if (mappings.empty()) refuse("this belongs to no device; write device 0079:0006 above it");
    HidMapping& mapping = mappings.back();
    if (keyword == "serial") {
        mapping.serial = rest_after(keyword);
    } else if (keyword == "port") {
        mapping.port = rest_after(keyword);
    } else {
        if (mapping.bindings.size() == kMostBindings) refuse("the device has more than 256 bindings; remove some");
        mapping.bindings.push_back(parse_binding(line));
    }
}

std::string hex4(unsigned value) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    return {kDigits[value >> 12 & 0xf], kDigits[value >> 8 & 0xf], kDigits[value >> 4 & 0xf], kDigits[value & 0xf]};
}

}  // namespace

const HidMapping* mapping_of(std::span<const HidMapping> mappings, const HidIdentity& device) {
    const HidMapping* of_port = nullptr;
    const HidMapping* of_kind = nullptr;
    std::size_t of_that_kind = 0;
    for (const HidMapping& mapping : mappings) {
        if (mapping.vendor != device.vendor || mapping.product != device.product) continue;
        ++of_that_kind;
        of_kind = &mapping;
        if (!mapping.serial.empty() && mapping.serial == one_word(device.serial)) return &mapping;
        if (!mapping.port.empty() && mapping.port == one_word(device.port)) of_port = &mapping;
    }
    if (of_port != nullptr) return of_port;
    return of_that_kind == 1 ? of_kind : nullptr;
}

void remember(std::vector<HidMapping>& mappings, HidMapping mapping) {
    std::erase_if(mappings, [&](const HidMapping& other) {
        return other.vendor == mapping.vendor && other.product == mapping.product && other.serial == mapping.serial &&
               (!mapping.serial.empty() || other.port == mapping.port);
    });
    mappings.push_back(std::move(mapping));
}

std::string to_text(std::span<const HidMapping> mappings) {
    std::string text = "# What the buttons of these devices mean. Taught by: quadrat doctor --learn-buttons\n";
    for (const HidMapping& mapping : mappings) {
        text.append("\ndevice ").append(hex4(mapping.vendor)).append(":").append(hex4(mapping.product)).append("\n");
        if (!mapping.serial.empty()) text.append("serial ").append(one_word(mapping.serial)).append("\n");
        if (!mapping.port.empty()) text.append("port ").append(one_word(mapping.port)).append("\n");
        for (const Binding& binding : mapping.bindings) {
            const HidSignal& signal = binding.signal;
            text.append(name_of(binding.button)).append(" = ").append(hex4(page_of(signal.usage))).append(":");
            text.append(hex4(signal.usage & 0xffffu)).append(" ").append(kParts[static_cast<std::size_t>(signal.part)]);
            text.append(", collection ").append(std::to_string(signal.collection)).append("\n");
        }
    }
    return text;
}

std::vector<HidMapping> parse_mappings(std::string_view text, std::string_view source_name) {
    std::vector<HidMapping> mappings;
    std::size_t number = 0;
    for (const std::string_view raw : split(text, '\n')) {
        ++number;
        const std::string_view line = trimmed(raw.substr(0, raw.find('#')));
        if (line.empty()) continue;
        try {
            parse_line(line, mappings);
        } catch (const std::invalid_argument& error) {
            refuse(std::string{source_name} + ":" + std::to_string(number) + ": " + error.what());
        }
    }
    return mappings;
}

std::vector<HidMapping> read_mappings(const std::filesystem::path& file) {
    constexpr std::size_t kLargest = 1u << 20;
    try {
        return parse_mappings(read_text(file, kLargest), file.string());
    } catch (const TextError& error) {
        refuse(std::string{error.what()} + "; teach the buttons with quadrat doctor --learn-buttons");
    }
}

}  // namespace quadrat::firmware_io::hid
