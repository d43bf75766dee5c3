// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/heard_devices.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::firmware_io {
namespace {

bool is_same(const DeviceIdentity& a, const DeviceIdentity& b) {
    return board_of(a) == board_of(b) && a.port == b.port;
}

}  // namespace

void HeardDevices::add(std::unique_ptr<HeardDevice> device) {
    const auto came_back = std::find_if(missing_.begin(), missing_.end(), [&](const DeviceIdentity& missing) {
        return is_same(missing, device->identity());
    });
    if (came_back != missing_.end()) missing_.erase(came_back);
    devices_.push_back(std::move(device));
}

bool HeardDevices::has(const std::string& path) const {
    return std::any_of(devices_.begin(), devices_.end(), [&](const auto& device) { return device->path() == path; });
}

void HeardDevices::remove(std::size_t i, Instant now) {
    HeardDevice& device = *devices_[i];
    device.debouncer().lost(now);
    const auto edges = device.debouncer().take(now);
    last_edges_.insert(last_edges_.end(), edges.begin(), edges.end());
    joined_.retire(device.debouncer().contacts());
    devices_.erase(devices_.begin() + static_cast<std::ptrdiff_t>(i));
}

void HeardDevices::leave(const std::vector<std::string>& paths, Instant now) {
    for (std::size_t i = devices_.size(); i-- > 0;)
        if (std::find(paths.begin(), paths.end(), devices_[i]->path()) != paths.end()) remove(i, now);
}

std::vector<ButtonEdge> HeardDevices::poll(Instant now) {
    for (std::size_t i = devices_.size(); i-- > 0;) {
        if (devices_[i]->hear(now) == HeardDevice::Plug::In) continue;
        missing_.push_back(devices_[i]->identity());
        remove(i, now);
    }
    std::vector<ButtonEdge> edges = std::exchange(last_edges_, {});
    std::vector<const Contacts*> contacts;
    for (const auto& device : devices_) {
        const auto more = device->debouncer().take(now);
        edges.insert(edges.end(), more.begin(), more.end());
        contacts.push_back(&device->debouncer().contacts());
    }
    if (devices_.empty()) missing_.clear();  // nobody is left to be compared with: the source says that all are gone
    return joined_.join(std::move(edges), contacts);
}

std::string HeardDevices::description() const {
    std::string text;
    for (const auto& device : devices_)
        text += (text.empty() ? "" : ", ") + describe(device->path(), device->identity());
    for (const DeviceIdentity& missing : missing_)
        text += "; without " + describe(missing.port.empty() ? "one" : missing.port, missing) + ", which was unplugged";
    return text;
}

std::optional<Instant> HeardDevices::next_event_at() const {
    std::optional<Instant> next;
    for (const auto& device : devices_) {
        const auto at = device->debouncer().next_event_at();
        if (at && (!next || *at < *next)) next = at;
    }
    return next;
}

}  // namespace quadrat::firmware_io
