// SPDX-License-Identifier: Apache-2.0
#include "stand_in_kernel.hpp"

#include <fcntl.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <fstream>
#include <functional>
#include <utility>

namespace quadrat::tests {
namespace {

namespace fs = std::filesystem;

// By the inode behind a descriptor, which a copy of it shares.
std::map<ino_t, std::function<int(unsigned long, void*)>>& nodes() {
    static std::map<ino_t, std::function<int(unsigned long, void*)>> known;
    return known;
}
std::map<std::string, StandInHidraw*>& openings() {
    static std::map<std::string, StandInHidraw*> known;
    return known;
}

ino_t inode_of(int descriptor) {
    struct stat facts {};
    return ::fstat(descriptor, &facts) == 0 ? facts.st_ino : 0;
}

void set_bit(unsigned code, unsigned size, void* bytes) {
    if (code / 8 < size) static_cast<std::uint8_t*>(bytes)[code / 8] |= static_cast<std::uint8_t>(1u << code % 8);
}

void write_text(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream{file, std::ios::binary} << text << '\n';
}

// As the kernel writes a "capabilities" file.
std::string capabilities_of(const std::set<unsigned>& codes) {
    constexpr unsigned kBits = 8 * sizeof(unsigned long);
    std::vector<unsigned long> words(1, 0);
    for (const unsigned code : codes) {
        words.resize(std::max<std::size_t>(words.size(), code / kBits + 1), 0);
        words[code / kBits] |= 1ul << code % kBits;
    }
    std::string text;
    for (std::size_t i = words.size(); i-- > 0;) {
        char word[20];
        std::snprintf(word, sizeof word, "%lx", words[i]);
        text.append(text.empty() ? "" : " ").append(word);
    }
    return text;
}

}  // namespace

StandInFolder::StandInFolder() {
    std::string name = (fs::temp_directory_path() / "quadrat-kernel-XXXXXX").string();
    root_ = ::mkdtemp(name.data());
    fs::create_directories(sys());
    fs::create_directories(dev());
}
StandInFolder::~StandInFolder() { fs::remove_all(root_); }

StandInEvdev::StandInEvdev(const StandInFolder& folder, std::set<unsigned> keys, std::map<unsigned, input_absinfo> axes)
    : folder_{folder}, keys_{std::move(keys)}, axes_{std::move(axes)} {
    plug();
}

void StandInEvdev::plug() {
    const std::string name = "event" + std::to_string(++number_);
    const fs::path facts = folder_.sys() / name / "device";
    std::set<unsigned> axes;
    for (const auto& [code, axis] : axes_) axes.insert(code);
    write_text(facts / "name", "Five buttons");
    write_text(facts / "phys", "usb-0000:00:14.0-1/input0");
    write_text(facts / "uniq", "");
    write_text(facts / "id" / "vendor", "1209");
    write_text(facts / "id" / "product", "0001");
    write_text(facts / "capabilities" / "key", capabilities_of(keys_));
    write_text(facts / "capabilities" / "abs", capabilities_of(axes));
    node_ = folder_.dev() / name;
    ::mkfifo(node_.c_str(), 0600);
    // Through the system itself: the open of this program is the one that is tested.
    pipe_ = static_cast<int>(::syscall(SYS_openat, AT_FDCWD, node_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC, 0));
    nodes()[inode_of(pipe_)] = [this](unsigned long request, void* argument) { return answer(request, argument); };
}

void StandInEvdev::unplug() {
    if (pipe_ < 0) return;
    nodes().erase(inode_of(pipe_));
    ::close(std::exchange(pipe_, -1));
    fs::remove_all(folder_.sys() / node_.filename());
    fs::remove(node_);
    is_open_ = is_grabbed_ = false;
}

void StandInEvdev::send(std::uint16_t type, unsigned code, std::int32_t value, std::int64_t at_us) {
    if (!is_open_) return;
    input_event event{};
    event.input_event_sec = at_us / 1'000'000;
    event.input_event_usec = at_us % 1'000'000;
    event.type = type;
    event.code = static_cast<std::uint16_t>(code);
    event.value = value;
    [[maybe_unused]] const auto written = ::write(pipe_, &event, sizeof event);
}

void StandInEvdev::key(unsigned code, bool is_down, std::int64_t at_us) {
    if (is_down == held_.contains(code)) return;
    if (is_down)
        held_.insert(code);
    else
        held_.erase(code);
    send(EV_KEY, code, is_down ? 1 : 0, at_us);
    send(EV_SYN, SYN_REPORT, 0, at_us);
}

void StandInEvdev::axis(unsigned code, std::int32_t value, std::int64_t at_us) {
    axes_[code].value = value;
    send(EV_ABS, code, value, at_us);
    send(EV_SYN, SYN_REPORT, 0, at_us);
}

void StandInEvdev::overflow(std::int64_t at_us) {
    input_event lost{};
    while (::read(pipe_, &lost, sizeof lost) == sizeof lost) {
    }
    send(EV_SYN, SYN_DROPPED, 0, at_us);
    send(EV_SYN, SYN_REPORT, 0, at_us);
}

int StandInEvdev::answer_bits(unsigned type, unsigned size, void* argument) const {
    if (type == 0)
        for (const unsigned known : {EV_SYN, EV_KEY, EV_ABS})
            if (known != EV_ABS || !axes_.empty()) set_bit(known, size, argument);
    if (type == EV_KEY)
        for (const unsigned code : keys_) set_bit(code, size, argument);
    if (type == EV_ABS)
        for (const auto& [code, axis] : axes_) set_bit(code, size, argument);
    return static_cast<int>(size);
}

int StandInEvdev::answer(unsigned long request, void* argument) {
    is_open_ = true;
    const unsigned number = _IOC_NR(request), size = _IOC_SIZE(request);
    if (number == _IOC_NR(EVIOCGRAB)) {  // its argument is the value itself
        is_grabbed_ = argument != nullptr && !is_grabbed_by_another;
        return is_grabbed_by_another ? (errno = EBUSY, -1) : 0;
    }
    if (number == _IOC_NR(EVIOCSCLOCKID)) return 0;
    std::memset(argument, 0, size);
    if (number == _IOC_NR(EVIOCGVERSION)) return *static_cast<int*>(argument) = EV_VERSION, 0;
    if (number == _IOC_NR(EVIOCGNAME(0)))
        return std::strncpy(static_cast<char*>(argument), "Five buttons", size - 1), 13;
    if (number == _IOC_NR(EVIOCGPHYS(0)) || number == _IOC_NR(EVIOCGUNIQ(0))) return errno = ENOENT, -1;
    if (number == _IOC_NR(EVIOCGKEY(0)))
        for (const unsigned code : held_) set_bit(code, size, argument);
    if (number >= 0x20 && number < 0x40) return answer_bits(number - 0x20, size, argument);
    if (number >= 0x40 && number < 0x80) {
        const auto axis = axes_.find(number - 0x40);
        if (axis == axes_.end()) return errno = EINVAL, -1;
        std::memcpy(argument, &axis->second, sizeof axis->second);
    }
    return static_cast<int>(size);
}

StandInHidraw::StandInHidraw(const StandInFolder& folder, std::vector<std::uint8_t> descriptor)
    : folder_{folder}, descriptor_{std::move(descriptor)} {
    plug();
}

void StandInHidraw::plug() {
    const std::string name = "hidraw" + std::to_string(++number_);
    const fs::path facts = folder_.sys() / name / "device";
    write_text(facts / "uevent",
               "HID_ID=0003:00001209:00000001\nHID_NAME=Five buttons\nHID_PHYS=usb-0000:00:14.0-1/input0\nHID_UNIQ=");
    std::ofstream{facts / "report_descriptor", std::ios::binary}.write(
        reinterpret_cast<const char*>(descriptor_.data()), static_cast<std::streamsize>(descriptor_.size()));
    node_ = folder_.dev() / name;
    openings()[node_.string()] = this;
    std::ofstream{node_};
}

void StandInHidraw::unplug() {
    openings().erase(node_.string());
    if (ours_ >= 0) ::close(std::exchange(ours_, -1));
    fs::remove_all(folder_.sys() / node_.filename());
    fs::remove(node_);
}

int StandInHidraw::open_node() {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) return -1;
    if (ours_ >= 0) ::close(ours_);
    ours_ = ends[0];
    nodes()[inode_of(ends[1])] = [this](unsigned long request, void* argument) { return answer(request, argument); };
    return ends[1];
}

void StandInHidraw::send(const std::vector<std::uint8_t>& report) {
    if (ours_ >= 0) ::send(ours_, report.data(), report.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
}

int StandInHidraw::answer(unsigned long request, void* argument) const {
    const unsigned number = _IOC_NR(request);
    if (number == _IOC_NR(HIDIOCGRDESCSIZE)) *static_cast<int*>(argument) = static_cast<int>(descriptor_.size());
    if (number == _IOC_NR(HIDIOCGRDESC)) {
        auto* told = static_cast<hidraw_report_descriptor*>(argument);
        told->size = static_cast<std::uint32_t>(descriptor_.size());
        std::copy(descriptor_.begin(), descriptor_.end(), told->value);
    }
    return 0;
}

}  // namespace quadrat::tests

// The libraries find these two.
extern "C" __attribute__((visibility("default"))) int ioctl(int descriptor, unsigned long request, ...) noexcept {
    std::va_list rest;
    va_start(rest, request);
    void* argument = va_arg(rest, void*);
    va_end(rest);
    auto& known = quadrat::tests::nodes();
    const auto node = known.empty() ? known.end() : known.find(quadrat::tests::inode_of(descriptor));
    if (node != known.end()) return node->second(request, argument);
    return static_cast<int>(::syscall(SYS_ioctl, descriptor, request, argument));
}

extern "C" __attribute__((visibility("default"))) int open(const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const auto mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    const auto known = quadrat::tests::openings().find(path);
    if (known != quadrat::tests::openings().end()) return known->second->open_node();
    return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}
