// SPDX-License-Identifier: Apache-2.0
#include "unit/display/virtual_desktop.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

#include "display/egl/egl_context.hpp"

namespace quadrat::display::testing {
namespace {

// In the child, between fork and exec: only calls that are safe there. Xvfb picks a free display number itself and
// writes it when it is ready (no guessing, no waiting blindly), and ends with us even when we crash.
[[noreturn]] void become_server(int report_to, const char* report_to_text) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
    fcntl(report_to, F_SETFD, 0);
    execlp("Xvfb", "Xvfb", "-displayfd", report_to_text, "-nolisten", "tcp", "-screen", "0", "1280x800x24", nullptr);
    _exit(127);
}

pid_t start_server(int report_to) {
    const std::string text = std::to_string(report_to);
    const pid_t server = fork();
    if (server == 0) become_server(report_to, text.c_str());
    if (server < 0) throw std::runtime_error("Xvfb: no process can be made");
    return server;
}

std::string first_line(int descriptor) {
    std::string line;
    pollfd waiting{descriptor, POLLIN, 0};
    while (poll(&waiting, 1, 30'000) == 1) {
        char letter = 0;
        if (read(descriptor, &letter, 1) != 1) break;
        if (letter == '\n') return line;
        line += letter;
    }
    throw std::runtime_error(
        "Xvfb did not come up, and the window display is tested under it: apt install xvfb; "
        "when it is installed, run it by hand to see why: Xvfb -displayfd 1");
}

}  // namespace

VirtualDesktop::VirtualDesktop() {
    // Keeps Mesa's driver loaded when the window ends: unloaded, it leaves 240 bytes behind each time, and a leak of
    // a library that is gone cannot be told from one of ours.
    headless_screens(HeadlessPlatform::Surfaceless);
    std::array<int, 2> report{};
    if (pipe2(report.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    try {
        server_ = start_server(report[1]);
        close(report[1]);
        name_ = first_line(report[0]).insert(0, 1, ':');
    } catch (...) {
        close(report[0]);
        throw;
    }
    close(report[0]);
    setenv("DISPLAY", name_.c_str(), 1);
    unsetenv("WAYLAND_DISPLAY");
}

VirtualDesktop::~VirtualDesktop() {
    unsetenv("DISPLAY");
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
}

}  // namespace quadrat::display::testing
