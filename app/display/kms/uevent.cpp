// SPDX-License-Identifier: Apache-2.0
#include "display/kms/uevent.hpp"

#include <linux/netlink.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

#include "base/log.hpp"

namespace quadrat::display {
namespace {

constexpr unsigned kKernelGroup = 1;  // the kernel's own messages; udev's come in group 2

// Whoever may open a netlink socket may send to it: only the kernel has port 0.
bool is_from_kernel(const sockaddr_nl& sender) { return sender.nl_family == AF_NETLINK && sender.nl_pid == 0; }

}  // namespace

std::optional<Uevent> read_uevent(std::string_view message) {
    std::string_view action;
    std::string_view subsystem;
    std::string_view kind;
    std::string_view node;
    bool is_hotplug = false;
    while (!message.empty()) {
        const std::size_t end = std::min(message.find('\0'), message.size());
        const std::string_view line = message.substr(0, end);
        message.remove_prefix(std::min(end + 1, message.size()));
        const auto value_of = [&line](std::string_view key, std::string_view& value) {
            if (line.starts_with(key)) value = line.substr(key.size());
        };
        value_of("ACTION=", action);
        value_of("SUBSYSTEM=", subsystem);
        value_of("DEVTYPE=", kind);
        value_of("DEVNAME=", node);
        is_hotplug = is_hotplug || line == "HOTPLUG=1";
    }
    if (subsystem != "drm") return std::nullopt;
    if (action == "change" && is_hotplug) return Uevent{CardEvent::PlugMoved, std::string(node)};
    if (kind != "drm_minor" || node.find("card") == std::string_view::npos) return std::nullopt;
    if (action == "add") return Uevent{CardEvent::Appeared, std::string(node)};
    if (action == "remove") return Uevent{CardEvent::Removed, std::string(node)};
    return std::nullopt;
}

UeventSocket::UeventSocket()
    : socket_(::socket(AF_NETLINK, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_KOBJECT_UEVENT)) {
    sockaddr_nl address{};
    address.nl_family = AF_NETLINK;
    address.nl_groups = kKernelGroup;
    const int room = 1 << 20;  // a card that appears announces dozens of things at once
    if (socket_) setsockopt(socket_.get(), SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
    if (socket_ && bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return;
    base::log::warn("screen: the kernel's plug events cannot be heard; a new screen is found by looking every 5 s");
    socket_.reset();
}

std::vector<Uevent> UeventSocket::take() {
    std::vector<Uevent> events;
    std::array<char, 8192> buffer{};
    for (;;) {
        sockaddr_nl sender{};
        socklen_t sender_size = sizeof sender;
        const ssize_t size = socket_ ? recvfrom(socket_.get(), buffer.data(), buffer.size(), MSG_DONTWAIT,
                                                reinterpret_cast<sockaddr*>(&sender), &sender_size)
                                     : -1;
        if (size <= 0) return events;
        if (!is_from_kernel(sender)) continue;
        if (auto event = read_uevent({buffer.data(), static_cast<std::size_t>(size)}))
            events.push_back(std::move(*event));
    }
}

}  // namespace quadrat::display
