// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <set>

#include "firmware-io/hid/mapping.hpp"
#include "firmware-io/hid/report_reader.hpp"

namespace quadrat::firmware_io::hid {

// Which control a person pressed, out of what was pressed at rest, while it was held, and after it was let go: the one
// that came and went. If several did, a button or key counts before a hat before an axis (a trigger is often a button
// and an axis); empty if that leaves none, or more than one.
std::optional<HidSignal> pressed_control(std::span<const HidSignal> at_rest, std::span<const HidSignal> held,
                                         std::span<const HidSignal> let_go);

// Learns a device by asking for one button after the other, in the order of kButtons. Feed it the device's reports and
// ask what it asks. A control is taken when it is let go, so an axis that rests off its centre is nobody's press.
class Learner {
  public:
    explicit Learner(HidDeviceFacts device);

    void report(std::span<const std::uint8_t> report);
    void skip();  // the button that is asked for does not exist

    std::optional<Button> asked() const;                     // empty: everything was asked
    const std::string& trouble() const { return trouble_; }  // what to tell the person about the last press, or ""
    HidMapping mapping() const;                              // what was learned so far

  private:
    void learn(const HidSignal& signal);

    HidIdentity identity_;
    ReportReader reader_;
    std::vector<HidSignal> at_rest_;
    std::set<HidSignal> held_;
    Bindings bindings_;
    std::size_t asked_ = 0;
    std::string trouble_;
};

}  // namespace quadrat::firmware_io::hid
