// SPDX-License-Identifier: Apache-2.0
// What systemd is told, on a socket of ours.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "firmware-io/merged_buttons.hpp"
#include "kiosk/run_loop.hpp"
#include "support/process.hpp"

namespace quadrat::kiosk {
namespace {

using namespace std::chrono_literals;

class NotifySocket {
  public:
    explicit NotifySocket(const std::filesystem::path& folder) : path_(folder / "notify") {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        path_.string().copy(address.sun_path, sizeof address.sun_path - 1);
        if (bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
            throw std::runtime_error("no socket at " + path_.string());
        setenv("NOTIFY_SOCKET", path_.c_str(), 1);
    }
    NotifySocket(const NotifySocket&) = delete;
    NotifySocket& operator=(const NotifySocket&) = delete;
    ~NotifySocket() {
        unsetenv("NOTIFY_SOCKET");
        close(socket_);
    }

    std::vector<std::string> take() const {
        std::vector<std::string> told;
        std::array<char, 256> text;
        for (;;) {
            const ssize_t length = recv(socket_, text.data(), text.size(), MSG_DONTWAIT);
            if (length <= 0) return told;
            told.emplace_back(text.data(), static_cast<std::size_t>(length));
        }
    }

  private:
    std::filesystem::path path_;
    int socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

// Without a GPU; notes what had been told when each frame was handed over, and ends after the third with landscapes.
class WatchedScreen : public display::Display {
  public:
    WatchedScreen(const NotifySocket& systemd, const Show& show, std::atomic<bool>& stop)
        : Display("watched"), systemd_(systemd), show_(show), stop_(stop) {}
    std::string_view kind() const override { return "watched"; }
    std::string description() const override { return "watched"; }
    std::string renderer() const override { return ""; }
    display::Canvas canvas() const override { return {}; }
    display::Canvas begin_frame() override { return {}; }
    display::Presented present(const tempo::HandOver&) override {
        auto& told = with_landscapes == 0 ? before_first : with_landscapes == 1 ? before_second : later;
        for (std::string& line : systemd_.take()) told.push_back(std::move(line));
        if (!show_.on_stage().scenes.empty() && ++with_landscapes == 3) stop_ = true;
        return {};
    }
    void set_power(display::Power) override {}

    int with_landscapes = 0;
    std::vector<std::string> before_first;  // frame with landscapes was out
    std::vector<std::string> before_second;
    std::vector<std::string> later;

  private:
    const NotifySocket& systemd_;
    const Show& show_;
    std::atomic<bool>& stop_;
};

bool has(const std::vector<std::string>& told, std::string_view beginning) {
    return std::ranges::any_of(told, [&](const std::string& line) { return line.starts_with(beginning); });
}

TEST(Service, IsReadyOnceAFrameWithLandscapesIsOutAndHasTimeUntilThen) {
    const tests::TemporaryFolder folder;
    const NotifySocket systemd(folder.path());
    site::Configuration configuration;
    configuration.picture.land_samples = 65;
    Show show(
        configuration,
        {base::Seed{1}, {1, {65, 64, 128}}, [] { return archive::WallTime{}; }, [] { return archive::WallTime{}; }, ""},
        archive::Archive::open(folder.path(), {}).archive);
    firmware_io::MergedButtons buttons{{}};
    staff::Panel panel(buttons);
    std::atomic<bool> stop{false};
    WatchedScreen screen(systemd, show, stop);
    base::SteadyClock clock;
    tempo::Tempo tempo({tempo::Governing::Fixed, {}});
    RunLoopParts parts{configuration, clock, screen, panel, buttons, show, tempo};
    parts.stop = &stop;
    run_loop(parts);
    ASSERT_EQ(screen.with_landscapes, 3);
    EXPECT_FALSE(has(screen.before_first, "READY=1")) << "the slowest frame was still to come";
    EXPECT_TRUE(has(screen.before_first, "EXTEND_TIMEOUT_USEC=120000000")) << "they were growing";
    EXPECT_FALSE(has(screen.before_first, "WATCHDOG=1")) << "fed once, it would bite during that frame";
    EXPECT_TRUE(has(screen.before_second, "READY=1"));
    EXPECT_FALSE(has(screen.before_second, "EXTEND_TIMEOUT_USEC")) << "there is none to extend";
    EXPECT_TRUE(has(screen.later, "WATCHDOG=1"));
}

}  // namespace
}  // namespace quadrat::kiosk
