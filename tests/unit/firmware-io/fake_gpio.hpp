// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "firmware-io/gpio/gpio_host.hpp"

namespace quadrat::tests {

namespace gpio = firmware_io::gpio;
using firmware_io::Instant;

// A machine's GPIO as the kernel shows it: levels, queues of stamped edges that overflow, lines that others hold.
struct FakeGpioMachine {
    // The zero of the kernel's clock lies somewhere else than ours.
    static constexpr Instant kKernelZero = std::chrono::hours{40};
    std::vector<gpio::ChipFacts> chips;
    std::map<gpio::LinePlace, bool> level;  // true: the contact is closed
    std::map<gpio::LinePlace, std::deque<std::pair<Instant, bool>>> queued;
    std::map<gpio::LinePlace, bool> lit;
    std::set<gpio::LinePlace> overflowed;
    std::size_t queue_length = 16;
    std::size_t writes = 0, listings = 0;
    bool is_plugged = true;
    unsigned plugging = 0;  // lines that were requested in an earlier plugging are dead

    void move(const gpio::LinePlace& line, bool is_closed, Instant at) {
        if (level[line] == is_closed) return;
        level[line] = is_closed;
        if (queued[line].size() == queue_length)
            overflowed.insert(line);
        else
            queued[line].emplace_back(kKernelZero + at, is_closed);
    }
    void unplug() { is_plugged = false; }
    void plug() {
        is_plugged = true;
        ++plugging;
        queued.clear();
        overflowed.clear();
    }
};

inline gpio::ChipFacts chip_of(std::string path, std::string label, std::vector<std::string> names) {
    gpio::ChipFacts chip{std::move(path), std::move(label), {}, ""};
    for (std::string& name : names) chip.lines.push_back({std::move(name), ""});
    return chip;
}

class FakeLines : public gpio::InputLines, public gpio::OutputLines {
  public:
    FakeLines(std::shared_ptr<FakeGpioMachine> machine, const std::string& chip, const std::vector<unsigned>& offsets)
        : machine_{std::move(machine)}, plugging_{machine_->plugging} {
        for (const unsigned offset : offsets) lines_.push_back({chip, offset});
    }
    gpio::DrainEnd drain(std::vector<gpio::LineEdge>& edges) override {
        if (is_dead()) return gpio::DrainEnd::Gone;
        gpio::DrainEnd end = gpio::DrainEnd::UpToDate;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            for (const auto& [at, is_closed] : machine_->queued[lines_[i]]) edges.push_back({i, is_closed, at});
            machine_->queued[lines_[i]].clear();
            if (machine_->overflowed.erase(lines_[i]) > 0) end = gpio::DrainEnd::Gap;
        }
        return end;
    }
    std::vector<bool> closed() override {
        if (is_dead()) return {};
        std::vector<bool> closed;
        for (const auto& line : lines_) closed.push_back(machine_->level[line]);
        return closed;
    }
    Written set(const std::vector<bool>& lit) override {
        if (is_dead()) return Written::Gone;
        ++machine_->writes;
        for (std::size_t i = 0; i < lines_.size(); ++i) machine_->lit[lines_[i]] = lit.at(i);
        return Written::Yes;
    }

  private:
    bool is_dead() const { return !machine_->is_plugged || machine_->plugging != plugging_; }
    std::shared_ptr<FakeGpioMachine> machine_;
    std::vector<gpio::LinePlace> lines_;
    unsigned plugging_;
};

class FakeGpioHost : public gpio::GpioHost {
  public:
    explicit FakeGpioHost(std::shared_ptr<FakeGpioMachine> machine) : machine_{std::move(machine)} {}
    std::vector<gpio::ChipFacts> chips() override {
        ++machine_->listings;
        return machine_->is_plugged ? machine_->chips : std::vector<gpio::ChipFacts>{};
    }
    std::unique_ptr<gpio::InputLines> request_inputs(const std::string& chip, const std::vector<unsigned>& offsets,
                                                     gpio::InputOptions) override {
        return std::make_unique<FakeLines>(machine_, chip, offsets);
    }
    std::unique_ptr<gpio::OutputLines> request_outputs(const std::string& chip,
                                                       const std::vector<unsigned>& offsets) override {
        return std::make_unique<FakeLines>(machine_, chip, offsets);
    }

  private:
    std::shared_ptr<FakeGpioMachine> machine_;
};

}  // namespace quadrat::tests
