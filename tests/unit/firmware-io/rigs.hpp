// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "firmware-io/button_source.hpp"

namespace quadrat::tests {

using firmware_io::Button;
using firmware_io::ButtonEdge;
using firmware_io::ButtonSource;
using firmware_io::Instant;
using firmware_io::Motion;

// What hands and cables do to a source.
struct Act {
    enum Kind { Close, Open, Unplug, Plug } kind;
    Button button;
    Instant at;
};

// A source together with the means to press its buttons, whatever it is made of.
class Rig {
  public:
    virtual ~Rig() = default;
    virtual ButtonSource& source() = 0;
    virtual void deliver(const Act& act) = 0;
    virtual void prepare(const std::vector<Act>&) {}  // all that is going to happen, before the first poll
    virtual bool can_be_absent() const { return true; }

    std::vector<ButtonEdge> poll(Instant now);  // delivers what is due, then polls
    void schedule(Act act);                     // before the first poll; in any order
    std::vector<ButtonEdge> run(Instant until, Instant step = std::chrono::milliseconds{1});

    void press(Button button, Instant at, Instant span = std::chrono::milliseconds{80});
    void bounce(Button button, Instant at, int edges, Instant span);  // settles closed

  private:
    std::vector<Act> acts_;
    std::size_t next_ = 0;
    bool is_prepared_ = false;
    Instant now_{0};
};

struct RigKind {
    std::string name;
    std::function<std::unique_ptr<Rig>()> make;
};
std::vector<RigKind> every_rig();

}  // namespace quadrat::tests
