// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "display/display.hpp"
#include "display/kms/drm_object.hpp"

namespace quadrat::display {

inline constexpr std::uint32_t kScanoutFormat = 0x34325258;  // DRM_FORMAT_XRGB8888; a test holds it to libdrm's

// One connector, one CRTC, one primary plane, and the commits that drive them. Atomic only: what a card is asked for is
// taken whole or not at all. Calls return 0 or a positive errno.
class AtomicOutput {
  public:
    // Nothing: no CRTC or no primary plane can serve this connector.
    static std::optional<AtomicOutput> choose(int card, std::uint32_t connector);

    // The layouts (DRM format modifiers) this plane can show kScanoutFormat in; empty: it does not say.
    const std::vector<std::uint64_t>& modifiers() const { return modifiers_; }
    std::uint32_t crtc() const { return crtc_.id(); }

    // Shows the framebuffer, scaled from draw into the mode with its aspect kept, and switches off everything else on
    // the card: no console on a second screen, no cursor left behind. Tested first, so that a refusal changes nothing.
    // Waits until done.
    int set_mode(const drmModeModeInfo& mode, Size draw, std::uint32_t framebuffer) const;
    // At the next retrace; the card then sends an event on its descriptor.
    int flip(std::uint32_t framebuffer) const;
    // Off, link and all. Waits until done.
    int disable() const;

  private:
    AtomicOutput() = default;
    bool find_crtc(const drmModeRes& resources, const drmModeConnector& connector);
    bool find_plane(std::uint32_t crtc_index);
    void add_plane(drmModeAtomicReq* request, const drmModeModeInfo& mode, Size draw, std::uint32_t framebuffer) const;
    void add_others_off(drmModeAtomicReq* request) const;

    int card_ = -1;
    DrmObject connector_;
    DrmObject crtc_;
    DrmObject plane_;
    std::vector<std::uint64_t> modifiers_;
};

}  // namespace quadrat::display
