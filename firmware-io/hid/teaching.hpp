// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "firmware-io/hid/hid_buttons.hpp"
#include "firmware-io/hid/learner.hpp"

namespace quadrat::firmware_io::hid {

// Teaches one device by its buttons: listens to every device that is meant, and the one whose control is pressed first
// is the pupil; of two equal boards that is told by nothing else.
class Teaching {
  public:
    Teaching(HidHost& host, const HidSelector& selector);

    bool has_devices() const { return !desks_.empty(); }
    const std::string& trouble() const { return trouble_; }  // why there is none, or what the last press was not

    void poll();                          // reads what the devices sent; never waits
    void skip();                          // the button that is asked for does not exist
    std::optional<Button> asked() const;  // empty: everything was asked, or the pupil was unplugged
    std::optional<HidDeviceFacts> pupil() const;
    HidMapping mapping() const;  // of the pupil; without bindings as long as there is none

  private:
    struct Desk {
        HidDeviceFacts device;
        std::unique_ptr<HidStream> stream;
        Learner learner;
    };
    void listen(std::size_t desk);

    std::vector<Desk> desks_;
    std::optional<std::size_t> pupil_;
    bool is_gone_ = false;
    std::string trouble_;
};

}  // namespace quadrat::firmware_io::hid
