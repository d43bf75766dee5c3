// SPDX-License-Identifier: Apache-2.0
#include "projector/cec.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <vector>

#include "base/owned.hpp"

extern char** environ;

namespace quadrat::projector {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kProgram = "cec-ctl";
constexpr const char* kMenuRemedy =
    "switch CEC on in the screen's menu (Anynet+, Bravia Sync, SimpLink, VIERA Link), or take PJLink";

std::string after(std::string_view printed, std::string_view label) {
    const std::size_t at = printed.find(label);
    if (at == std::string_view::npos) return "";
    const std::string_view rest = printed.substr(at + label.size());
    const std::size_t from = std::min(rest.find_first_not_of(" \t:"), rest.size());
    return std::string(rest.substr(from, rest.substr(from).find_first_of(" \t\r\n(")));
}

// A child that has ended, or is ended when nobody waits any longer.
class Child {
  public:
    Child(std::vector<std::string> words, int output) {
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
        const int error = ::posix_spawnp(&process_, kProgram, &actions, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (error == ENOENT)
            throw Trouble("cec-ctl is not installed, and the screen is switched by it", "sudo apt install v4l-utils");
        if (error != 0) throw Trouble(fmt::format("cec-ctl: {}", std::strerror(error)), "look at the log");
    }
    ~Child() {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

  private:
    pid_t process_ = 0;
};

std::string read_until(int from, Clock::time_point until) {
    constexpr std::size_t kMost = 64U << 10U;
    std::string printed;
    while (printed.size() < kMost) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
        pollfd one{from, POLLIN, 0};
        const int ready = left > 0 ? ::poll(&one, 1, static_cast<int>(left)) : 0;
        if (ready == 0) throw Trouble("cec-ctl does not come to an end", kMenuRemedy);
        if (ready < 0 && errno == EINTR) continue;
        std::array<char, 4096> bytes{};
        const ssize_t count = ::read(from, bytes.data(), bytes.size());
        if (count <= 0) break;
        printed.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return printed;
}

class ThroughTheCable : public Projector {
  public:
    ThroughTheCable(Cec at, std::chrono::milliseconds patience) : at_(std::move(at)), patience_(patience) {}

    Power power() override {
        take_a_place();
        return power_in(run({"--skip-info", "--to", "0", "--give-device-power-status"}));
    }
    void turn_on() override {
        const std::string place = take_a_place();
        run({"--skip-info", "--to", "0", "--image-view-on"});
        run({"--skip-info", "--active-source", "phys-addr=" + place});
    }
    void turn_off() override {
        take_a_place();
        run({"--skip-info", "--to", "0", "--standby"});
    }
    std::string ailments() override { return ""; }

  private:
    // Who speaks on the cable has a place there first, which the kernel forgets when the screen is unplugged.
    std::string take_a_place() const {
        std::string place = physical_address_in(run({"--playback", "--osd-name", "Quadrat"}));
        if (place.empty()) throw Trouble(at_.device + ": nothing is plugged in there that knows CEC", kMenuRemedy);
        return place;
    }

    std::string run(std::vector<std::string> words) const {
        words.insert(words.begin(), {kProgram, "--device", at_.device});
        int ends[2] = {-1, -1};
        if (::pipe2(ends, O_CLOEXEC) != 0) throw Trouble(fmt::format("a pipe: {}", std::strerror(errno)), "");
        const base::OwnedDescriptor from(ends[0]);
        base::OwnedDescriptor to(ends[1]);
        const Child child(std::move(words), to.get());
        to.reset();
        std::string printed = read_until(from.get(), Clock::now() + patience_);
        if (printed.find("Failed to open") != std::string::npos)
            throw Trouble(
                fmt::format("{} cannot be opened: {}", at_.device, reason_in(printed)),
                "ls /dev/cec*: name the one of the screen's output; a PC without any needs an adapter, or PJLink");
        return printed;
    }

    static std::string reason_in(const std::string& printed) {
        const std::size_t colon = printed.rfind(": ");
        return colon == std::string::npos ? "" : printed.substr(colon + 2, printed.find('\n', colon) - colon - 2);
    }

    Cec at_;
    std::chrono::milliseconds patience_;
};

}  // namespace

Power power_in(std::string_view printed) {
    const std::string state = after(printed, "pwr-state");
    if (state == "on") return Power::On;
    if (state == "standby") return Power::Off;
    if (state == "to-on") return Power::Warming;
    return state == "to-standby" ? Power::Cooling : Power::Unknown;
}

std::string physical_address_in(std::string_view printed) {
    const std::string address = after(printed, "Physical Address");
    const bool is_one = address.size() == 7 && address.find_first_not_of("0123456789abcdef.") == std::string::npos;
    return is_one && address != "f.f.f.f" ? address : "";
}

std::unique_ptr<Projector> open_cec(const Cec& at, std::chrono::milliseconds patience) {
    return std::make_unique<ThroughTheCable>(at, patience);
}

}  // namespace quadrat::projector
