// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/gpio/gpio_buttons.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace quadrat::firmware_io::gpio {
namespace {

using namespace std::chrono_literals;

constexpr Instant kRetryEvery = 1s;
// The levels are read again this often, so that an edge the kernel never reported cannot keep a button down.
constexpr Instant kReadLevelsEvery = 1s;

std::vector<Button> buttons_of(const std::vector<std::pair<unsigned, Button>>& lines) {
    std::vector<Button> buttons;
    for (const auto& line : lines) buttons.push_back(line.second);
    return buttons;
}

std::vector<unsigned> offsets_of(const std::vector<std::pair<unsigned, Button>>& lines) {
    std::vector<unsigned> offsets;
    for (const auto& line : lines) offsets.push_back(line.first);
    return offsets;
}

}  // namespace

GpioButtons::GpioButtons(std::unique_ptr<GpioHost> host, Wiring wiring)
    : host_{std::move(host)}, wiring_{std::move(wiring)}, debouncer_{wiring_.debounce} {
    status_ = {Presence::Absent, "GPIO lines have not been requested yet"};
}

std::vector<GpioButtons::Bank> GpioButtons::request(const std::vector<ChipFacts>& chips) {
    struct Lines {
        std::vector<std::pair<unsigned, Button>> contacts, lamps;
    };
    std::map<std::string, Lines> by_chip;
    for (const Wire& wire : wiring_.contacts) {
        const LinePlace place = find_line(chips, wire.line);
        by_chip[place.chip_path].contacts.emplace_back(place.offset, wire.button);
    }
    for (const Wire& wire : wiring_.lamps) {
        const LinePlace place = find_line(chips, wire.line);
        by_chip[place.chip_path].lamps.emplace_back(place.offset, wire.button);
    }
    std::vector<Bank> banks;
    for (const auto& [path, lines] : by_chip) {
        Bank bank{nullptr, buttons_of(lines.contacts), nullptr, buttons_of(lines.lamps)};
        if (!lines.contacts.empty())
            bank.inputs = host_->request_inputs(path, offsets_of(lines.contacts), wiring_.inputs);
        if (!lines.lamps.empty()) bank.outputs = host_->request_outputs(path, offsets_of(lines.lamps));
        banks.push_back(std::move(bank));
    }
    return banks;
}

void GpioButtons::open(Instant now) {
    if (retry_at_ && now < *retry_at_) return;
    retry_at_ = now + kRetryEvery;
    try {
        banks_ = request(host_->chips());
    } catch (const GpioError& error) {
        status_ = {Presence::Absent, error.what()};
        return;
    }
    lit_.assign(banks_.size(), {});
    clock_ = {};
    if (!read_levels(Levels::AtOpening, now)) return lose(now, "the GPIO chip vanished while it was opened");
    std::string names;
    for (const Wire& wire : wiring_.contacts)
        names +=
            (names.empty() ? "GPIO lines " : ", ") + std::string{name_of(wire.button)} + "=" + to_string(wire.line);
    status_ = {Presence::Present, names};
}

void GpioButtons::lose(Instant now, std::string reason) {
    banks_.clear();
    debouncer_.lost(now);
    retry_at_ = now + kRetryEvery;
    status_ = {Presence::Absent, std::move(reason)};
}

bool GpioButtons::read_levels(Levels when, Instant now) {
    levels_read_at_ = now;
    for (const Bank& bank : banks_) {
        if (!bank.inputs) continue;
        const std::vector<bool> closed = bank.inputs->closed();
        if (closed.size() != bank.buttons.size()) return false;
        for (std::size_t i = 0; i < closed.size(); ++i) {
            if (when == Levels::AtOpening)
                debouncer_.found(bank.buttons[i], closed[i], now);
            else
                debouncer_.contact(bank.buttons[i], closed[i], now);
        }
    }
    return true;
}

bool GpioButtons::read_edges(Instant now) {
    bool is_gap = now - levels_read_at_ >= kReadLevelsEvery;
    for (const Bank& bank : banks_) {
        if (!bank.inputs) continue;
        std::vector<LineEdge> edges;
        const DrainEnd end = bank.inputs->drain(edges);
        for (const LineEdge& edge : edges) clock_.saw(edge.kernel_time, now);
        for (const LineEdge& edge : edges)
            debouncer_.contact(bank.buttons.at(edge.line), edge.is_closed, clock_.moment_of(edge.kernel_time));
        if (end == DrainEnd::Gone) return false;
        is_gap = is_gap || end == DrainEnd::Gap;
    }
    return !is_gap || read_levels(Levels::AfterGap, now);
}

bool GpioButtons::drive_lamps(Instant now) {
    for (std::size_t b = 0; b < banks_.size(); ++b) {
        if (!banks_[b].outputs) continue;
        std::vector<bool> lit;
        for (const Button lamp : banks_[b].lamps) lit.push_back(is_lamp_lit(patterns_[index_of(lamp)], now));
        if (lit == lit_[b]) continue;
        if (banks_[b].outputs->set(lit) == OutputLines::Written::Gone) return false;
        lit_[b] = std::move(lit);
    }
    return true;
}

std::vector<ButtonEdge> GpioButtons::poll(Instant now) {
    if (banks_.empty()) open(now);
    if (!banks_.empty() && !(read_edges(now) && drive_lamps(now)))
        lose(now, "the GPIO chip has vanished; plug it in again (tried every second)");
    return debouncer_.take(now);
}

}  // namespace quadrat::firmware_io::gpio
