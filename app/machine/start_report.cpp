// SPDX-License-Identifier: Apache-2.0
#include "machine/start_report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>

#include "base/log.hpp"

namespace quadrat::machine {
namespace {

using std::chrono::milliseconds;

// proc(5): ticks from the machine's start to the program's, the 22nd field; the second, its name, may hold spaces.
milliseconds started_at() {
    constexpr int kAfterName = 20;
    std::ifstream file("/proc/self/stat");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::size_t at = text.rfind(')');
    for (int field = 0; field < kAfterName && at != std::string::npos; ++field) at = text.find(' ', at + 1);
    if (at == std::string::npos) return {};
    const long long ticks = std::strtoll(text.c_str() + at, nullptr, 10);
    return milliseconds{ticks * 1000 / ::sysconf(_SC_CLK_TCK)};
}

milliseconds since_boot() {
    timespec now{};
    ::clock_gettime(CLOCK_BOOTTIME, &now);
    return std::chrono::duration_cast<milliseconds>(std::chrono::seconds{now.tv_sec} +
                                                    std::chrono::nanoseconds{now.tv_nsec});
}

void tell(const char* what) {
    base::log::info("start: {} after {:.2f} s", what, std::chrono::duration<double>(since_start()).count());
}

}  // namespace

milliseconds since_start() {
    const milliseconds started = started_at();
    return started.count() > 0 ? since_boot() - started : milliseconds{0};
}

void StartReport::drawn(bool has_landscapes) {
    if (!is_first_told_) tell("the first frame");
    is_first_told_ = true;
    if (!has_landscapes || are_landscapes_told_) return;
    are_landscapes_told_ = true;
    tell("the first landscapes");
}

}  // namespace quadrat::machine
