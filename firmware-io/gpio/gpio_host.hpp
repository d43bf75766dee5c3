// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "firmware-io/button_press.hpp"

// What we need of the machine's GPIO chips, and no more: libgpiod 1.6 and 2.x stand behind it, and so does a fake.
namespace quadrat::firmware_io::gpio {

// How our requests are called where another program asks who holds a line.
inline constexpr const char* kConsumer = "quadrat";

struct LineFacts {
    std::string name;    // "" where the device tree gives none
    std::string holder;  // who has requested it: a consumer, a driver, or "" for nobody
};
struct ChipFacts {
    std::string path;              // "/dev/gpiochip0"
    std::string label;             // "pinctrl-rp1"
    std::vector<LineFacts> lines;  // by offset
    std::string trouble;           // why it could not be opened, or ""
};

enum class Pull { Up, Down, None };
enum class Active { Low, High };
struct InputOptions {
    Pull pull = Pull::Up;
    Active active = Active::Low;
};

// One line of one chip.
struct LinePlace {
    std::string chip_path;
    unsigned offset = 0;
    friend auto operator<=>(const LinePlace&, const LinePlace&) = default;
};

struct LineEdge {
    std::size_t line;     // index into the offsets that were requested
    bool is_closed;       // the line became active
    Instant kernel_time;  // on the kernel's monotonic clock, whose zero is not ours
};

// Gap: the kernel's buffer overflowed, or may have; the levels must be read again. Gone: the chip has vanished.
enum class DrainEnd { UpToDate, Gap, Gone };

// Requested lines. They are given back to the kernel on destruction. Nothing here blocks.
class InputLines {
  public:
    virtual ~InputLines() = default;
    // Appends what is waiting, oldest first within a line.
    virtual DrainEnd drain(std::vector<LineEdge>& edges) = 0;
    // The level of each line, in the order they were requested; empty if the chip has vanished.
    virtual std::vector<bool> closed() = 0;
};
class OutputLines {
  public:
    virtual ~OutputLines() = default;
    enum class Written { Yes, Gone };
    virtual Written set(const std::vector<bool>& lit) = 0;  // in the order they were requested
};

// A request that failed, in one line: what and why.
struct GpioError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class GpioHost {
  public:
    virtual ~GpioHost() = default;
    virtual std::vector<ChipFacts> chips() = 0;  // links to another chip's node are left out
    // Both throw GpioError.
    virtual std::unique_ptr<InputLines> request_inputs(const std::string& chip_path,
                                                       const std::vector<unsigned>& offsets, InputOptions options) = 0;
    virtual std::unique_ptr<OutputLines> request_outputs(const std::string& chip_path,
                                                         const std::vector<unsigned>& offsets) = 0;
};

}  // namespace quadrat::firmware_io::gpio
