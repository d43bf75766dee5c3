// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/owned.hpp"
#include "display/kms/card.hpp"
#include "display/kms/drm_object.hpp"

namespace quadrat::display {

enum class Asking {
    InFull,     // talks to the screen over its cable: some tens of milliseconds
    FromMemory  // what the kernel knows already
};

// An opened graphics card that may show pictures.
class DrmCard {
  public:
    // Never fails: what is wrong is in description().problem.
    explicit DrmCard(std::string path);

    int descriptor() const { return descriptor_.get(); }  // -1: not opened
    const Card& description() const { return description_; }
    // Asks the connectors anew. The modes' indices are those of modes_of.
    const Card& look(Asking asking);
    // The kernel's own words for the modes of a connector, as of the last look in full.
    std::vector<drmModeModeInfo> modes_of(std::uint32_t connector) const;
    // The right to set modes. False while another program has it.
    bool take_master() const;

  private:
    void refuse(int error_number);
    Connector described(const drmModeConnector& connector) const;

    base::OwnedDescriptor descriptor_;
    Card description_;
    std::map<std::uint32_t, std::vector<drmModeModeInfo>> modes_;
};

// The primary nodes of this machine, "/dev/dri/card0" and so on, in the order of their numbers.
std::vector<std::string> card_paths();

double refresh_hz_of(const drmModeModeInfo& mode);

}  // namespace quadrat::display
