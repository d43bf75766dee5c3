// SPDX-License-Identifier: Apache-2.0
// The room `projector`: switches on and off what shows the exhibit's picture, and asks how that is. By PJLink over the
// network, or by CEC through the cable. Nothing here knows why: it is told what is wanted.
#pragma once
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <variant>

namespace quadrat::projector {

// By the cable: the kernel's device.
struct Cec {
    std::string device = "/dev/cec0";
    friend bool operator==(const Cec&, const Cec&) = default;
};
// By the network: the projector's name or number there.
struct PjLink {
    std::string host;
    int port = 4352;
    friend bool operator==(const PjLink&, const PjLink&) = default;
};
using Address = std::variant<Cec, PjLink>;

// "cec", "cec:/dev/cec1", "pjlink://192.168.0.30", "pjlink://hall-2.museum.example:4352", "pjlink://[fd00::3]". Throws
// std::invalid_argument: what is wrong, and what would be right.
Address parse_address(const std::string& text);
std::string to_text(const Address& address);

enum class Power { Off, On, Cooling, Warming, Unknown };
const char* name_of(Power power);

// Why it is not as it should be, and what mends it; a line each.
class Trouble : public std::runtime_error {
  public:
    Trouble(const std::string& what, std::string remedy) : std::runtime_error(what), remedy_(std::move(remedy)) {}
    const std::string& remedy() const { return remedy_; }

  private:
    std::string remedy_;
};

// Each call waits for seconds at most, and throws Trouble.
class Projector {
  public:
    Projector() = default;
    virtual ~Projector() = default;
    Projector(const Projector&) = delete;
    Projector& operator=(const Projector&) = delete;

    virtual Power power() = 0;
    virtual void turn_on() = 0;
    virtual void turn_off() = 0;
    // What it reports of itself, "lamp: warning, filter: error"; "" where all is well, or it does not say.
    virtual std::string ailments() = 0;
};

// Connects to nothing yet. `password` is PJLink's, or "".
std::unique_ptr<Projector> open_projector(const Address& address, const std::string& password,
                                          std::chrono::milliseconds patience = std::chrono::seconds{5});

}  // namespace quadrat::projector
