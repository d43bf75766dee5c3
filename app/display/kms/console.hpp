// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace quadrat::display {

// The console's virtual terminal, taken for as long as this lives: no text over the picture, no key (Ctrl-Alt-Del
// included) reaching a shell, no switching to another terminal. Given back at the end, also when the process dies of a
// signal that can be caught; after SIGKILL the service's ExecStopPost has to (kbd_mode -u, setterm).
class Console {
  public:
    // Never fails: where there is no terminal to take (no rights, no console at all) problem() says so, and the picture
    // is shown all the same.
    static Console take();
    Console(Console&& other) noexcept;
    Console& operator=(Console&&) = delete;
    ~Console();
    const std::string& problem() const { return problem_; }  // empty: taken

  private:
    Console() = default;
    bool is_taken_ = false;
    std::string problem_;
};

}  // namespace quadrat::display
