// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <string>

namespace quadrat::commands {

// Thrown by obey_interrupts().
struct Interrupted {};

// While it lives, Ctrl-C and a polite kill are noted instead of obeyed. One at a time.
class InterruptsNoted {
  public:
    InterruptsNoted();
    ~InterruptsNoted();
    InterruptsNoted(const InterruptsNoted&) = delete;
    InterruptsNoted& operator=(const InterruptsNoted&) = delete;

  private:
    void (*before_int_)(int);
    void (*before_term_)(int);
};

void obey_interrupts();

// Says on standard error how far a long piece of work is; short ones say nothing.
class Progress {
  public:
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void at(double share);  // obeys interrupts

  private:
    std::string what_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    const bool is_terminal_;
    int said_ = 0;
    bool has_spoken_ = false;
};

}  // namespace quadrat::commands
