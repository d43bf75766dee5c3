// SPDX-License-Identifier: Apache-2.0
#include "display/kms/console.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <utility>

namespace quadrat::display {
namespace {

constexpr unsigned kTtyMajor = 4;
constexpr unsigned kLastVirtual = 63;
constexpr std::array<int, 10> kDeadly{SIGSEGV, SIGBUS,  SIGILL, SIGFPE, SIGABRT,
                                      SIGSYS,  SIGTERM, SIGINT, SIGHUP, SIGQUIT};

// What a signal handler needs, and so outside every object: the terminal, and how it was.
struct Taken {
    std::atomic<int> terminal{-1};
    int keyboard = K_UNICODE;
    int picture = KD_TEXT;
    int came_from = 0;  // the terminal to go back to; 0: we were on ours already
    vt_mode switching{};
    std::array<struct sigaction, kDeadly.size()> before{};
};
Taken taken;

int switch_signal() { return SIGRTMIN + 7; }

// Calls that are safe in a signal handler, and nothing else.
void give_back() {
    const int terminal = taken.terminal.exchange(-1);
    if (terminal < 0) return;
    ioctl(terminal, KDSKBMODE, taken.keyboard);
    ioctl(terminal, KDSETMODE, taken.picture);
    ioctl(terminal, VT_SETMODE, &taken.switching);
    if (taken.came_from > 0) ioctl(terminal, VT_ACTIVATE, taken.came_from);
    close(terminal);
}

void refuse_switch(int) {
    const int saved = errno;
    const int terminal = taken.terminal.load();
    if (terminal >= 0) ioctl(terminal, VT_RELDISP, 0);
    errno = saved;
}

void die_tidily(int signal_number) {
    give_back();
    for (std::size_t i = 0; i < kDeadly.size(); ++i)
        if (kDeadly[i] == signal_number) sigaction(signal_number, &taken.before[i], nullptr);
    raise(signal_number);  // blocked until we return, and then what would have happened without us
}

// Only where nobody listens: a program that ends in its own way destroys its display in its own way.
void guard_against_signals() {
    for (std::size_t i = 0; i < kDeadly.size(); ++i) {
        sigaction(kDeadly[i], nullptr, &taken.before[i]);
        if (taken.before[i].sa_handler != SIG_DFL) continue;
        struct sigaction tidily {};
        tidily.sa_handler = die_tidily;
        sigaction(kDeadly[i], &tidily, nullptr);
    }
}

void stop_guarding() {
    for (std::size_t i = 0; i < kDeadly.size(); ++i) {
        struct sigaction present {};
        sigaction(kDeadly[i], nullptr, &present);
        if (present.sa_handler == die_tidily) sigaction(kDeadly[i], &taken.before[i], nullptr);
    }
}

// The number of the virtual terminal behind a descriptor; 0 when it is none (a pipe, a serial line, ssh).
unsigned virtual_number(int descriptor) {
    struct stat status {};
    if (fstat(descriptor, &status) != 0 || !S_ISCHR(status.st_mode) || major(status.st_rdev) != kTtyMajor) return 0;
    const unsigned number = minor(status.st_rdev);
    return number <= kLastVirtual ? number : 0;
}

// A service has its terminal as standard input (TTYPath=); started by hand elsewhere, a free one is asked for.
int wanted_number(int console) {
    if (const unsigned own = virtual_number(STDIN_FILENO); own > 0) return static_cast<int>(own);
    int free_one = 0;
    return ioctl(console, VT_OPENQRY, &free_one) == 0 ? free_one : -1;
}

int active_number(int console) {
    vt_stat state{};
    return ioctl(console, VT_GETSTATE, &state) == 0 ? state.v_active : 0;
}

// Not VT_WAITACTIVE, which waits for ever when the terminal in front refuses to go.
bool bring_to_front(int terminal, int number) {
    if (active_number(terminal) == number) return true;
    ioctl(terminal, VT_ACTIVATE, number);
    for (int tries = 0; tries < 200 && active_number(terminal) != number; ++tries) poll(nullptr, 0, 10);
    return active_number(terminal) == number;
}

bool take_over(int terminal) {
    ioctl(terminal, KDGKBMODE, &taken.keyboard);
    ioctl(terminal, KDGETMODE, &taken.picture);
    ioctl(terminal, VT_GETMODE, &taken.switching);
    // Left so by somebody who was killed: what we would give back is no use to anybody.
    if (taken.keyboard == K_OFF) taken.keyboard = K_UNICODE;
    taken.picture = KD_TEXT;
    taken.switching.mode = VT_AUTO;
    taken.terminal = terminal;
    struct sigaction refusing {};
    refusing.sa_handler = refuse_switch;
    refusing.sa_flags = SA_RESTART;
    sigaction(switch_signal(), &refusing, nullptr);
    vt_mode ours{};
    ours.mode = VT_PROCESS;
    ours.relsig = ours.acqsig = static_cast<short>(switch_signal());
    return ioctl(terminal, KDSKBMODE, K_OFF) == 0 && ioctl(terminal, KDSETMODE, KD_GRAPHICS) == 0 &&
           ioctl(terminal, VT_SETMODE, &ours) == 0;
}

}  // namespace

Console Console::take() {
    Console console;
    const auto refused = [&console](const char* what) {
        console.problem_ = fmt::format(
            "the console stays as it is: {} ({}); as a service, set TTYPath=/dev/tty7 and "
            "StandardInput=tty",
            what, std::strerror(errno));
    };
    if (taken.terminal >= 0) return console;
    const int front = ::open("/dev/tty0", O_RDWR | O_CLOEXEC | O_NOCTTY);
    const int asked = front >= 0 ? front : STDIN_FILENO;
    const int number = wanted_number(asked);
    const std::string path = fmt::format("/dev/tty{}", number);
    const int terminal = number > 0 ? ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOCTTY) : -1;
    if (front >= 0) close(front);
    if (terminal < 0) {
        refused("no virtual terminal may be opened");
        return console;
    }
    const int came_from = active_number(terminal);
    taken.came_from = came_from == number ? 0 : came_from;
    guard_against_signals();
    console.is_taken_ = true;
    if (!bring_to_front(terminal, number) || !take_over(terminal)) {
        refused("its virtual terminal cannot be taken");
        taken.terminal = terminal;
        console.is_taken_ = false;
        give_back();
        stop_guarding();
    }
    return console;
}

Console::Console(Console&& other) noexcept
    : is_taken_(std::exchange(other.is_taken_, false)), problem_(std::move(other.problem_)) {}

Console::~Console() {
    if (!is_taken_) return;
    give_back();
    stop_guarding();
}

}  // namespace quadrat::display
