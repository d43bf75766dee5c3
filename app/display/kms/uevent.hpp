// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/owned.hpp"

namespace quadrat::display {

enum class CardEvent { Appeared, Removed, PlugMoved };
struct Uevent {
    CardEvent what = CardEvent::PlugMoved;
    std::string node;  // "dri/card0"
    friend bool operator==(const Uevent&, const Uevent&) = default;
};

// One message of the kernel's uevent socket: "change@/devices/…\0ACTION=change\0SUBSYSTEM=drm\0HOTPLUG=1\0…".
// Nothing: not about graphics cards, or not a message.
std::optional<Uevent> read_uevent(std::string_view message);

// The kernel's announcements of graphics cards and plugs. Needs no privileges and no udev. Where the socket cannot be
// had (some containers) it is silent, and the slow poll has to do.
class UeventSocket {
  public:
    UeventSocket();
    int descriptor() const { return socket_.get(); }  // -1: silent
    std::vector<Uevent> take();

  private:
    base::OwnedDescriptor socket_;
};

}  // namespace quadrat::display
