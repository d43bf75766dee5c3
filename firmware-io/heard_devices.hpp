// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "firmware-io/debounce.hpp"
#include "firmware-io/device.hpp"
#include "firmware-io/joined_contacts.hpp"

namespace quadrat::firmware_io {

// One opened device: an interface of a board. Its contacts are its own, so that what one interface holds down never
// swallows a press on another.
class HeardDevice {
  public:
    HeardDevice(std::string path, DeviceIdentity identity, DebounceOptions debounce)
        : path_{std::move(path)}, identity_{std::move(identity)}, debouncer_{debounce} {}
    HeardDevice(const HeardDevice&) = delete;
    HeardDevice& operator=(const HeardDevice&) = delete;
    virtual ~HeardDevice() = default;

    enum class Plug { In, Gone };
    // Takes what it has to say into the contacts; never waits.
    virtual Plug hear(Instant now) = 0;

    const std::string& path() const { return path_; }
    const DeviceIdentity& identity() const { return identity_; }
    Debouncer& debouncer() { return debouncer_; }
    const Debouncer& debouncer() const { return debouncer_; }

  private:
    std::string path_;
    DeviceIdentity identity_;
    Debouncer debouncer_;
};

// The opened devices of one source as one set of buttons. What a device held down when it goes gives its Up.
class HeardDevices {
  public:
    void add(std::unique_ptr<HeardDevice> device);
    bool has(const std::string& path) const;
    std::size_t count() const { return devices_.size(); }
    bool is_empty() const { return devices_.empty(); }

    const std::vector<std::unique_ptr<HeardDevice>>& devices() const { return devices_; }

    // These are heard no longer.
    void leave(const std::vector<std::string>& paths, Instant now);

    std::vector<ButtonEdge> poll(Instant now);

    // One line: who is heard, and who was unplugged and has not come back. "" for nobody.
    std::string description() const;

    const Contacts& contacts() const { return joined_.contacts(); }
    std::optional<Instant> next_event_at() const;

  private:
    void remove(std::size_t i, Instant now);

    std::vector<std::unique_ptr<HeardDevice>> devices_;
    std::vector<DeviceIdentity> missing_;
    std::vector<ButtonEdge> last_edges_;  // of those that have been removed
    JoinedContacts joined_;
};

}  // namespace quadrat::firmware_io
