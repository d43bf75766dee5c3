// SPDX-License-Identifier: Apache-2.0
#include "commands/progress.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace quadrat::commands {
namespace {

volatile std::sig_atomic_t is_interrupted = 0;

void note(int) { is_interrupted = 1; }

}  // namespace

InterruptsNoted::InterruptsNoted() {
    is_interrupted = 0;
    before_int_ = std::signal(SIGINT, note);
    before_term_ = std::signal(SIGTERM, note);
}

InterruptsNoted::~InterruptsNoted() {
    std::signal(SIGINT, before_int_);
    std::signal(SIGTERM, before_term_);
}

void obey_interrupts() {
    if (is_interrupted != 0) throw Interrupted{};
}

Progress::Progress(std::string what) : what_(std::move(what)), is_terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (has_spoken_ && is_terminal_) std::fputc('\n', stderr);
}

void Progress::at(double share) {
    obey_interrupts();
    const int percent = static_cast<int>(100 * share);
    const auto since = std::chrono::steady_clock::now() - start_;
    if (since < std::chrono::milliseconds(700) || percent < said_ + (is_terminal_ ? 1 : 10)) return;
    std::fprintf(stderr, is_terminal_ ? "\r%s: %d %%" : "%s: %d %%\n", what_.c_str(), percent);
    said_ = percent;
    has_spoken_ = true;
}

}  // namespace quadrat::commands
