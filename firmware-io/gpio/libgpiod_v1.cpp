// SPDX-License-Identifier: Apache-2.0
// libgpiod 1.6 (Debian 12): one event descriptor a line, sixteen events in each, no debouncing by the kernel.
#if QUADRAT_GPIOD_MAJOR == 1
#include <gpiod.h>
#include <poll.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "firmware-io/gpio/libgpiod.hpp"

namespace quadrat::firmware_io::gpio {
namespace {

constexpr std::size_t kKernelQueue = 16;  // events the kernel keeps for a line

struct CloseChip {
    void operator()(gpiod_chip* chip) const { gpiod_chip_close(chip); }  // gives back the lines too
};
using Chip = std::unique_ptr<gpiod_chip, CloseChip>;

[[noreturn]] void refuse(const std::string& what) { throw GpioError{what + ": " + std::strerror(errno)}; }

Chip open_chip(const std::string& path) {
    Chip chip{gpiod_chip_open(path.c_str())};
    if (!chip) refuse(path + " cannot be opened");
    return chip;
}

gpiod_line_bulk lines_of(gpiod_chip* chip, const std::string& path, std::vector<unsigned> offsets) {
    if (offsets.size() > GPIOD_LINE_BULK_MAX_LINES)
        throw GpioError{path + ": more than 64 lines are asked of one chip"};
    gpiod_line_bulk bulk;
    if (gpiod_chip_get_lines(chip, offsets.data(), static_cast<unsigned>(offsets.size()), &bulk) != 0)
        refuse("the lines of " + path + " cannot be found");
    return bulk;
}

int flags_of(InputOptions options) {
    const int active = options.active == Active::Low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0;
    switch (options.pull) {
        case Pull::Up:
            return active | GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP;
        case Pull::Down:
            return active | GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN;
        case Pull::None:
            return active | GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE;
    }
    return active;
}

class Inputs final : public InputLines {
  public:
    Inputs(const std::string& path, const std::vector<unsigned>& offsets, InputOptions options)
        : chip_{open_chip(path)}, bulk_{lines_of(chip_.get(), path, offsets)} {
        if (gpiod_line_request_bulk_both_edges_events_flags(&bulk_, kConsumer, flags_of(options)) != 0)
            refuse("the button lines of " + path + " cannot be requested");
        for (unsigned i = 0; i < bulk_.num_lines; ++i)
            polled_.push_back({gpiod_line_event_get_fd(bulk_.lines[i]), POLLIN, 0});
    }

    DrainEnd drain(std::vector<LineEdge>& edges) override {
        DrainEnd end = DrainEnd::UpToDate;
        const int ready = ::poll(polled_.data(), polled_.size(), 0);
        if (ready <= 0) return ready == 0 || errno == EINTR ? end : DrainEnd::Gone;
        for (std::size_t line = 0; line < polled_.size(); ++line) {
            if ((polled_[line].revents & POLLIN) != 0) {
                if (!read_line(line, edges, end)) return DrainEnd::Gone;
            } else if (polled_[line].revents != 0) {
                return DrainEnd::Gone;
            }
        }
        return end;
    }

    std::vector<bool> closed() override {
        std::array<int, GPIOD_LINE_BULK_MAX_LINES> values{};
        if (gpiod_line_get_value_bulk(&bulk_, values.data()) != 0) return {};
        std::vector<bool> closed(bulk_.num_lines);
        for (std::size_t i = 0; i < closed.size(); ++i) closed[i] = values[i] != 0;
        return closed;
    }

  private:
    // A descriptor that is ready never blocks in read. A full queue may have lost events.
    bool read_line(std::size_t line, std::vector<LineEdge>& edges, DrainEnd& end) {
        std::array<gpiod_line_event, kKernelQueue> events;
        const int count = gpiod_line_event_read_fd_multiple(polled_[line].fd, events.data(), events.size());
        if (count < 0) return errno == EINTR || errno == EAGAIN;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            const timespec& ts = events[i].ts;
            edges.push_back({line, events[i].event_type == GPIOD_LINE_EVENT_RISING_EDGE,
                             std::chrono::seconds{ts.tv_sec} + std::chrono::nanoseconds{ts.tv_nsec}});
        }
        if (static_cast<std::size_t>(count) == kKernelQueue) end = DrainEnd::Gap;
        return true;
    }

    Chip chip_;
    gpiod_line_bulk bulk_;
    std::vector<pollfd> polled_;
};

class Outputs final : public OutputLines {
  public:
    Outputs(const std::string& path, const std::vector<unsigned>& offsets)
        : chip_{open_chip(path)}, bulk_{lines_of(chip_.get(), path, offsets)} {
        const std::array<int, GPIOD_LINE_BULK_MAX_LINES> dark{};
        if (gpiod_line_request_bulk_output_flags(&bulk_, kConsumer, 0, dark.data()) != 0)
            refuse("the lamp lines of " + path + " cannot be requested");
    }

    Written set(const std::vector<bool>& lit) override {
        std::array<int, GPIOD_LINE_BULK_MAX_LINES> values{};
        for (std::size_t i = 0; i < lit.size() && i < values.size(); ++i) values[i] = lit[i];
        return gpiod_line_set_value_bulk(&bulk_, values.data()) == 0 ? Written::Yes : Written::Gone;
    }

  private:
    Chip chip_;
    gpiod_line_bulk bulk_;
};

LineFacts facts_of(gpiod_line* line) {
    if (line == nullptr) return {"", "the kernel"};
    const char* name = gpiod_line_name(line);
    const char* consumer = gpiod_line_consumer(line);
    LineFacts facts{name != nullptr ? name : "", ""};
    if (gpiod_line_is_used(line)) facts.holder = consumer != nullptr ? consumer : "the kernel";
    return facts;
}

class Libgpiod final : public GpioHost {
  public:
    std::vector<ChipFacts> chips() override {
        std::vector<ChipFacts> chips;
        for (const std::string& path : chip_paths()) {
            ChipFacts facts{path, "", {}, ""};
            const Chip chip{gpiod_chip_open(path.c_str())};
            if (chip) {
                facts.label = gpiod_chip_label(chip.get());
                for (unsigned offset = 0; offset < gpiod_chip_num_lines(chip.get()); ++offset)
                    facts.lines.push_back(facts_of(gpiod_chip_get_line(chip.get(), offset)));
            } else {
                facts.trouble = std::strerror(errno);
            }
            chips.push_back(std::move(facts));
        }
        return chips;
    }
    std::unique_ptr<InputLines> request_inputs(const std::string& path, const std::vector<unsigned>& offsets,
                                               InputOptions options) override {
        return std::make_unique<Inputs>(path, offsets, options);
    }
    std::unique_ptr<OutputLines> request_outputs(const std::string& path,
                                                 const std::vector<unsigned>& offsets) override {
        return std::make_unique<Outputs>(path, offsets);
    }
};

}  // namespace

std::unique_ptr<GpioHost> open_libgpiod() { return std::make_unique<Libgpiod>(); }

}  // namespace quadrat::firmware_io::gpio
#endif
