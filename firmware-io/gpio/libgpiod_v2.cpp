// SPDX-License-Identifier: Apache-2.0
// libgpiod 2.x (Debian 13): one descriptor a request, sequence numbers, debouncing by the kernel.
#if QUADRAT_GPIOD_MAJOR == 2
#include <gpiod.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "firmware-io/gpio/libgpiod.hpp"

namespace quadrat::firmware_io::gpio {
namespace {

// Long enough to keep a storm of interrupts off the processor, short enough to be no delay: the true period is ours.
constexpr unsigned long kKernelDebounce_us = 1000;
constexpr std::size_t kEventBuffer = 256;

template <auto free>
struct Free {
    template <class T>
    void operator()(T* object) const {
        free(object);
    }
};
using Chip = std::unique_ptr<gpiod_chip, Free<gpiod_chip_close>>;
using ChipInfo = std::unique_ptr<gpiod_chip_info, Free<gpiod_chip_info_free>>;
using LineInfo = std::unique_ptr<gpiod_line_info, Free<gpiod_line_info_free>>;
using Settings = std::unique_ptr<gpiod_line_settings, Free<gpiod_line_settings_free>>;
using LineConfig = std::unique_ptr<gpiod_line_config, Free<gpiod_line_config_free>>;
using RequestConfig = std::unique_ptr<gpiod_request_config, Free<gpiod_request_config_free>>;
using Request = std::unique_ptr<gpiod_line_request, Free<gpiod_line_request_release>>;
using EventBuffer = std::unique_ptr<gpiod_edge_event_buffer, Free<gpiod_edge_event_buffer_free>>;

[[noreturn]] void refuse(const std::string& what) { throw GpioError{what + ": " + std::strerror(errno)}; }

gpiod_line_bias bias_of(Pull pull) {
    switch (pull) {
        case Pull::Up:
            return GPIOD_LINE_BIAS_PULL_UP;
        case Pull::Down:
            return GPIOD_LINE_BIAS_PULL_DOWN;
        case Pull::None:
            return GPIOD_LINE_BIAS_DISABLED;
    }
    return GPIOD_LINE_BIAS_AS_IS;
}

// Nothing when the kernel refuses, and `refusal` is its errno.
Request try_lines(const std::string& path, const std::vector<unsigned>& offsets, gpiod_line_settings* settings,
                  int& refusal) {
    const Chip chip{gpiod_chip_open(path.c_str())};
    if (!chip) refuse(path + " cannot be opened");
    const LineConfig lines{gpiod_line_config_new()};
    const RequestConfig config{gpiod_request_config_new()};
    if (!lines || !config) throw std::bad_alloc{};
    gpiod_request_config_set_consumer(config.get(), kConsumer);
    gpiod_request_config_set_event_buffer_size(config.get(), kEventBuffer);
    if (gpiod_line_config_add_line_settings(lines.get(), offsets.data(), offsets.size(), settings) != 0)
        refuse("the lines of " + path + " cannot be configured");
    Request request{gpiod_chip_request_lines(chip.get(), config.get(), lines.get())};
    refusal = request ? 0 : errno;
    return request;
}

Request request_lines(const std::string& path, const std::vector<unsigned>& offsets, gpiod_line_settings* settings) {
    int refusal = 0;
    Request request = try_lines(path, offsets, settings, refusal);
    // A chip behind I2C, SPI or USB has interrupts that are threads, and the kernel debounces only those that are not.
    if (refusal == EINVAL && gpiod_line_settings_get_debounce_period_us(settings) > 0) {
        gpiod_line_settings_set_debounce_period_us(settings, 0);
        request = try_lines(path, offsets, settings, refusal);
    }
    errno = refusal;
    if (!request) refuse("the lines of " + path + " cannot be requested");
    return request;
}

class Inputs final : public InputLines {
  public:
    Inputs(const std::string& path, const std::vector<unsigned>& offsets, InputOptions options)
        : offsets_{offsets}, last_seqno_(offsets.size(), 0), buffer_{gpiod_edge_event_buffer_new(kEventBuffer)} {
        const Settings settings{gpiod_line_settings_new()};
        if (!settings || !buffer_) throw std::bad_alloc{};
        gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_INPUT);
        gpiod_line_settings_set_edge_detection(settings.get(), GPIOD_LINE_EDGE_BOTH);
        gpiod_line_settings_set_bias(settings.get(), bias_of(options.pull));
        gpiod_line_settings_set_active_low(settings.get(), options.active == Active::Low);
        gpiod_line_settings_set_debounce_period_us(settings.get(), kKernelDebounce_us);
        gpiod_line_settings_set_event_clock(settings.get(), GPIOD_LINE_CLOCK_MONOTONIC);
        request_ = request_lines(path, offsets, settings.get());
    }

    // At most one buffer a call: a chattering line must not keep the frame waiting.
    DrainEnd drain(std::vector<LineEdge>& edges) override {
        const int ready = gpiod_line_request_wait_edge_events(request_.get(), 0);
        if (ready <= 0) return ready == 0 || errno == EINTR ? DrainEnd::UpToDate : DrainEnd::Gone;
        const int count = gpiod_line_request_read_edge_events(request_.get(), buffer_.get(), kEventBuffer);
        if (count < 0) return errno == EINTR || errno == EAGAIN ? DrainEnd::UpToDate : DrainEnd::Gone;
        DrainEnd end = DrainEnd::UpToDate;
        for (unsigned long i = 0; i < static_cast<unsigned long>(count); ++i)
            if (!add(gpiod_edge_event_buffer_get_event(buffer_.get(), i), edges)) end = DrainEnd::Gap;
        return end;
    }

    std::vector<bool> closed() override {
        std::vector<gpiod_line_value> values(offsets_.size());
        if (gpiod_line_request_get_values(request_.get(), values.data()) != 0) return {};
        std::vector<bool> closed;
        for (const gpiod_line_value value : values) closed.push_back(value == GPIOD_LINE_VALUE_ACTIVE);
        return closed;
    }

  private:
    // False if events of the line were lost before this one.
    bool add(gpiod_edge_event* event, std::vector<LineEdge>& edges) {
        const auto found = std::find(offsets_.begin(), offsets_.end(), gpiod_edge_event_get_line_offset(event));
        if (found == offsets_.end()) return true;
        const auto line = static_cast<std::size_t>(found - offsets_.begin());
        const auto stamp_ns = static_cast<Instant::rep>(gpiod_edge_event_get_timestamp_ns(event));
        edges.push_back({line, gpiod_edge_event_get_event_type(event) == GPIOD_EDGE_EVENT_RISING_EDGE,
                         std::chrono::nanoseconds{stamp_ns}});
        const unsigned long seqno = gpiod_edge_event_get_line_seqno(event);
        return std::exchange(last_seqno_[line], seqno) + 1 == seqno;
    }

    std::vector<unsigned> offsets_;
    std::vector<unsigned long> last_seqno_;
    EventBuffer buffer_;
    Request request_;
};

class Outputs final : public OutputLines {
  public:
    Outputs(const std::string& path, const std::vector<unsigned>& offsets) {
        const Settings settings{gpiod_line_settings_new()};
        if (!settings) throw std::bad_alloc{};
        gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_OUTPUT);
        gpiod_line_settings_set_output_value(settings.get(), GPIOD_LINE_VALUE_INACTIVE);
        request_ = request_lines(path, offsets, settings.get());
    }

    Written set(const std::vector<bool>& lit) override {
        std::vector<gpiod_line_value> values;
        for (const bool is_lit : lit) values.push_back(is_lit ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE);
        return gpiod_line_request_set_values(request_.get(), values.data()) == 0 ? Written::Yes : Written::Gone;
    }

  private:
    Request request_;
};

LineFacts facts_of(gpiod_chip* chip, unsigned offset) {
    const LineInfo info{gpiod_chip_get_line_info(chip, offset)};
    if (!info) return {"", "the kernel"};
    const char* name = gpiod_line_info_get_name(info.get());
    const char* consumer = gpiod_line_info_get_consumer(info.get());
    LineFacts facts{name != nullptr ? name : "", ""};
    if (gpiod_line_info_is_used(info.get())) facts.holder = consumer != nullptr ? consumer : "the kernel";
    return facts;
}

ChipFacts facts_of(const std::string& path) {
    ChipFacts facts{path, "", {}, ""};
    const Chip chip{gpiod_chip_open(path.c_str())};
    const ChipInfo info{chip ? gpiod_chip_get_info(chip.get()) : nullptr};
    if (!info) {
        facts.trouble = std::strerror(errno);
        return facts;
    }
    facts.label = gpiod_chip_info_get_label(info.get());
    for (unsigned offset = 0; offset < gpiod_chip_info_get_num_lines(info.get()); ++offset)
        facts.lines.push_back(facts_of(chip.get(), offset));
    return facts;
}

class Libgpiod final : public GpioHost {
  public:
    std::vector<ChipFacts> chips() override {
        std::vector<ChipFacts> chips;
        for (const std::string& path : chip_paths()) chips.push_back(facts_of(path));
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
