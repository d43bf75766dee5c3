// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/evdev/libevdev_host.hpp"

#include <fcntl.h>
#include <libevdev/libevdev.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <ctime>
#include <fstream>
#include <utility>

#include "firmware-io/text.hpp"

namespace quadrat::firmware_io::evdev {
namespace {

constexpr std::size_t kLongestLine = 1024;

// The first line of a small file; "" where there is none.
std::string line_of(const std::filesystem::path& file) {
    std::ifstream stream{file, std::ios::binary};
    std::string line(kLongestLine, '\0');
    stream.read(line.data(), static_cast<std::streamsize>(line.size()));
    line.resize(static_cast<std::size_t>(stream.gcount()));
    return line.substr(0, line.find('\n'));
}

std::uint16_t number_in(const std::filesystem::path& file) {
    return static_cast<std::uint16_t>(parse_unsigned(line_of(file), 16).value_or(0));
}

EvdevDeviceFacts facts_of(const std::filesystem::path& entry, const std::filesystem::path& nodes) {
    const std::filesystem::path device = entry / "device";
    return {(nodes / entry.filename()).string(),
            {number_in(device / "id" / "vendor"), number_in(device / "id" / "product"), line_of(device / "name"),
             line_of(device / "uniq"), line_of(device / "phys")},
            parse_capabilities(line_of(device / "capabilities" / "key")),
            parse_capabilities(line_of(device / "capabilities" / "abs"))};
}

class Descriptor {
  public:
    explicit Descriptor(int number) : number_{number} {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(Descriptor&& other) noexcept : number_{std::exchange(other.number_, -1)} {}
    Descriptor& operator=(Descriptor&&) = delete;
    int get() const { return number_; }

  private:
    int number_;
};

struct Free {
    void operator()(libevdev* device) const { libevdev_free(device); }
};
using Device = std::unique_ptr<libevdev, Free>;

Controls controls_of(const libevdev* device) {
    Controls controls;
    for (unsigned code = 0; code < KEY_CNT; ++code)
        if (libevdev_get_event_value(device, EV_KEY, code) != 0) controls.held.push_back(static_cast<Code>(code));
    for (unsigned code = 0; code < ABS_CNT; ++code)
        if (const input_absinfo* axis = libevdev_get_abs_info(device, code))
            controls.axes.push_back({static_cast<Code>(code), axis->minimum, axis->maximum, axis->value});
    return controls;
}

class Stream final : public EvdevStream {
  public:
    Stream(Descriptor descriptor, Device device)
        : descriptor_{std::move(descriptor)}, device_{std::move(device)}, at_opening_{controls_of(device_.get())} {}

    const Controls& at_opening() const override { return at_opening_; }

    Took take(ControlEvent& event) override {
        for (input_event raw{};;) {
            const unsigned flag = is_catching_up_ ? LIBEVDEV_READ_FLAG_SYNC : LIBEVDEV_READ_FLAG_NORMAL;
            const int status = libevdev_next_event(device_.get(), flag, &raw);
            if (status == -EINTR) continue;
            if (status == -EAGAIN && std::exchange(is_catching_up_, false)) {  // what had changed has been told
                event = {ControlKind::Report, 0, 0, last_at_};
                return Took::Event;
            }
            if (status == -EAGAIN) return is_plugged() ? Took::Nothing : Took::Gone;
            if (status < 0) return Took::Gone;
            // At first SYN_DROPPED itself, and then what differs from what was told before.
            if (status == LIBEVDEV_READ_STATUS_SYNC) is_catching_up_ = true;
            if (translate(raw, event)) return Took::Event;
        }
    }

  private:
    // A node that was unplugged says so, also where a read would only say that nothing waits.
    bool is_plugged() const {
        pollfd node{descriptor_.get(), POLLIN, 0};
        return ::poll(&node, 1, 0) < 0 || (node.revents & (POLLERR | POLLHUP | POLLNVAL)) == 0;
    }

    bool translate(const input_event& raw, ControlEvent& event) {
        last_at_ = std::chrono::seconds{raw.input_event_sec} + std::chrono::microseconds{raw.input_event_usec};
        event = {ControlKind::Report, raw.code, raw.value, last_at_};
        if (raw.type == EV_KEY) event.kind = ControlKind::Key;
        if (raw.type == EV_ABS) event.kind = ControlKind::Axis;
        return raw.type == EV_KEY || raw.type == EV_ABS || (raw.type == EV_SYN && raw.code == SYN_REPORT);
    }

    Descriptor descriptor_;
    Device device_;  // goes before the descriptor under it
    Controls at_opening_;
    bool is_catching_up_ = false;
    Instant last_at_{0};
};

std::vector<std::filesystem::path> event_entries(const std::filesystem::path& listing) {
    std::vector<std::filesystem::path> entries;
    std::error_code error;
    for (std::filesystem::directory_iterator entry{listing, error}, end; !error && entry != end; entry.increment(error))
        if (entry->path().filename().string().starts_with("event")) entries.push_back(entry->path());
    // event2 before event10
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
        const std::string left = a.filename().string(), right = b.filename().string();
        return std::pair{left.size(), left} < std::pair{right.size(), right};
    });
    return entries;
}

}  // namespace

std::vector<Code> parse_capabilities(std::string_view text) {
    constexpr unsigned kBits = sizeof(unsigned long) * CHAR_BIT;
    std::vector<std::string_view> words = words_of(trimmed(text));
    std::reverse(words.begin(), words.end());
    std::vector<Code> codes;
    for (unsigned w = 0; w < words.size() && w * kBits < KEY_CNT; ++w) {
        unsigned long word = 0;
        for (const char c : words[w]) {
            const auto digit = parse_unsigned(std::string_view{&c, 1}, 16);
            if (!digit) return codes;
            word = word << 4 | *digit;
        }
        for (unsigned bit = 0; bit < kBits; ++bit)
            if ((word >> bit & 1u) != 0) codes.push_back(static_cast<Code>(w * kBits + bit));
    }
    return codes;
}

std::vector<EvdevDeviceFacts> LibevdevHost::devices() {
    std::vector<EvdevDeviceFacts> devices;
    for (const auto& entry : event_entries(listing_)) devices.push_back(facts_of(entry, nodes_));
    return devices;
}

std::unique_ptr<EvdevStream> LibevdevHost::open(const std::string& path, Grab grab, std::string& trouble) {
    Descriptor descriptor{::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)};
    if (descriptor.get() < 0) {
        trouble = std::strerror(errno);
        return nullptr;
    }
    libevdev* raw = nullptr;
    int refusal = libevdev_new_from_fd(descriptor.get(), &raw);
    Device device{raw};
    if (refusal == 0 && grab == Grab::Yes) refusal = libevdev_grab(device.get(), LIBEVDEV_GRAB);
    if (refusal == 0) refusal = libevdev_set_clock_id(device.get(), CLOCK_MONOTONIC);
    if (refusal == 0) return std::make_unique<Stream>(std::move(descriptor), std::move(device));
    trouble = refusal == -EBUSY ? "another program has grabbed it" : std::strerror(-refusal);
    return nullptr;
}

std::optional<Signal> signal_named(std::string_view name) {
    const std::string text{name};
    if (const int key = libevdev_event_code_from_name(EV_KEY, text.c_str()); key >= 0)
        return Signal{SignalPart::Key, static_cast<Code>(key)};
    if (!text.ends_with('+') && !text.ends_with('-')) return std::nullopt;
    const int axis = libevdev_event_code_from_name(EV_ABS, text.substr(0, text.size() - 1).c_str());
    if (axis < 0) return std::nullopt;
    return Signal{text.ends_with('-') ? SignalPart::Low : SignalPart::High, static_cast<Code>(axis)};
}

}  // namespace quadrat::firmware_io::evdev
