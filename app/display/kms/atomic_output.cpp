// SPDX-License-Identifier: Apache-2.0
#include "display/kms/atomic_output.hpp"

#include <drm_fourcc.h>

#include <algorithm>
#include <cerrno>

#include "display/kms/placement.hpp"

namespace quadrat::display {
namespace {

constexpr std::uint64_t kUpright = 1;  // DRM_MODE_ROTATE_0
static_assert(kScanoutFormat == DRM_FORMAT_XRGB8888);

// A mode as the kernel holds it, for one commit.
class ModeBlob {
  public:
    ModeBlob(int card, const drmModeModeInfo& mode) : card_(card) {
        error_ = -drmModeCreatePropertyBlob(card, &mode, sizeof mode, &id_);
    }
    ~ModeBlob() {
        if (id_ != 0) drmModeDestroyPropertyBlob(card_, id_);
    }
    ModeBlob(const ModeBlob&) = delete;
    ModeBlob& operator=(const ModeBlob&) = delete;
    std::uint32_t id() const { return id_; }
    int error() const { return error_; }

  private:
    int card_;
    std::uint32_t id_ = 0;
    int error_ = 0;
};

std::vector<std::uint64_t> modifiers_in(int card, const DrmObject& plane) {
    const DrmBlob blob{drmModeGetPropertyBlob(card, static_cast<std::uint32_t>(plane.value("IN_FORMATS").value_or(0)))};
    std::vector<std::uint64_t> found;
    drmModeFormatModifierIterator at{};
    while (blob && drmModeFormatModifierBlobIterNext(blob.get(), &at))
        // Not a layout but the word for "none given"; some drivers list it and then refuse it.
        if (at.fmt == kScanoutFormat && at.mod != DRM_FORMAT_MOD_INVALID) found.push_back(at.mod);
    return found;
}

// 0 or a positive errno, also where libdrm returns -1 and leaves the reason in errno.
int commit(int card, drmModeAtomicReq* request, std::uint32_t flags) {
    const int result = drmModeAtomicCommit(card, request, flags, nullptr);
    if (result == 0) return 0;
    return result == -1 && errno != 0 ? errno : -result;
}

}  // namespace

std::optional<AtomicOutput> AtomicOutput::choose(int card, std::uint32_t connector) {
    const DrmResources resources{drmModeGetResources(card)};
    const DrmConnector found{drmModeGetConnectorCurrent(card, connector)};
    if (!resources || !found) return std::nullopt;
    AtomicOutput output;
    output.card_ = card;
    output.connector_ = DrmObject{card, connector, DRM_MODE_OBJECT_CONNECTOR};
    if (!output.find_crtc(*resources, *found)) return std::nullopt;
    return output;
}

// The CRTC that drives the connector already, when there is one: the firmware's choice needs the least retraining.
bool AtomicOutput::find_crtc(const drmModeRes& resources, const drmModeConnector& connector) {
    std::uint32_t possible = 0;
    for (int i = 0; i < connector.count_encoders; ++i) {
        const DrmEncoder encoder{drmModeGetEncoder(card_, connector.encoders[i])};
        if (encoder) possible |= encoder->possible_crtcs;
    }
    const std::uint64_t present = connector_.value("CRTC_ID").value_or(0);
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(resources.count_crtcs) && i < 32; ++i)
        if ((possible >> i & 1U) != 0) order.push_back(i);
    std::stable_partition(order.begin(), order.end(),
                          [&](std::uint32_t index) { return resources.crtcs[index] == present; });
    for (const std::uint32_t index : order) {
        crtc_ = DrmObject{card_, resources.crtcs[index], DRM_MODE_OBJECT_CRTC};
        if (find_plane(index)) return true;
    }
    return false;
}

bool AtomicOutput::find_plane(std::uint32_t crtc_index) {
    const DrmPlanes planes{drmModeGetPlaneResources(card_)};
    for (std::uint32_t i = 0; planes && i < planes->count_planes; ++i) {
        const DrmPlane plane{drmModeGetPlane(card_, planes->planes[i])};
        if (!plane || (plane->possible_crtcs >> crtc_index & 1U) == 0) continue;
        const DrmObject object{card_, plane->plane_id, DRM_MODE_OBJECT_PLANE};
        const std::uint32_t* end = plane->formats + plane->count_formats;
        const bool has_format = std::find<const std::uint32_t*>(plane->formats, end, kScanoutFormat) != end;
        if (!has_format || object.value("type") != DRM_PLANE_TYPE_PRIMARY) continue;
        // A primary plane that serves several CRTCs may be at work for another one.
        const std::uint64_t busy_for = object.value("CRTC_ID").value_or(0);
        if (plane_.id() != 0 && busy_for != crtc_.id()) continue;
        plane_ = object;
        modifiers_ = modifiers_in(card_, object);
    }
    return plane_.id() != 0;
}

void AtomicOutput::add_plane(drmModeAtomicReq* request, const drmModeModeInfo& mode, Size draw,
                             std::uint32_t framebuffer) const {
    plane_.set(request, "FB_ID", framebuffer);
    plane_.set(request, "CRTC_ID", crtc_.id());
    plane_.set(request, "SRC_X", 0);
    plane_.set(request, "SRC_Y", 0);
    plane_.set(request, "SRC_W", static_cast<std::uint64_t>(draw.width) << 16U);  // 16.16 fixed point
    plane_.set(request, "SRC_H", static_cast<std::uint64_t>(draw.height) << 16U);
    const Placement shown = placed_in({mode.hdisplay, mode.vdisplay}, draw);
    plane_.set(request, "CRTC_X", static_cast<std::uint64_t>(shown.x));
    plane_.set(request, "CRTC_Y", static_cast<std::uint64_t>(shown.y));
    plane_.set(request, "CRTC_W", static_cast<std::uint64_t>(shown.size.width));
    plane_.set(request, "CRTC_H", static_cast<std::uint64_t>(shown.size.height));
    plane_.set(request, "rotation", kUpright);  // whoever had the plane before may have turned it
}

void AtomicOutput::add_others_off(drmModeAtomicReq* request) const {
    const DrmResources resources{drmModeGetResources(card_)};
    const DrmPlanes planes{drmModeGetPlaneResources(card_)};
    for (std::uint32_t i = 0; planes && i < planes->count_planes; ++i) {
        const DrmObject plane{card_, planes->planes[i], DRM_MODE_OBJECT_PLANE};
        if (plane.id() == plane_.id() || plane.value("CRTC_ID").value_or(0) == 0) continue;
        plane.set(request, "FB_ID", 0);
        plane.set(request, "CRTC_ID", 0);
    }
    for (int i = 0; resources && i < resources->count_connectors; ++i) {
        const DrmObject other{card_, resources->connectors[i], DRM_MODE_OBJECT_CONNECTOR};
        if (other.id() != connector_.id() && other.value("CRTC_ID").value_or(0) != 0) other.set(request, "CRTC_ID", 0);
    }
    for (int i = 0; resources && i < resources->count_crtcs; ++i) {
        const DrmObject other{card_, resources->crtcs[i], DRM_MODE_OBJECT_CRTC};
        if (other.id() == crtc_.id() || other.value("ACTIVE").value_or(0) == 0) continue;
        other.set(request, "ACTIVE", 0);
        other.set(request, "MODE_ID", 0);
    }
}

int AtomicOutput::set_mode(const drmModeModeInfo& mode, Size draw, std::uint32_t framebuffer) const {
    const ModeBlob blob{card_, mode};
    if (blob.error() != 0) return blob.error();
    const DrmAtomicRequest request{drmModeAtomicAlloc()};
    connector_.set(request.get(), "CRTC_ID", crtc_.id());
    connector_.set(request.get(), "link-status", DRM_MODE_LINK_STATUS_GOOD);
    crtc_.set(request.get(), "MODE_ID", blob.id());
    crtc_.set(request.get(), "ACTIVE", 1);
    add_plane(request.get(), mode, draw, framebuffer);
    add_others_off(request.get());
    const int refusal = commit(card_, request.get(), DRM_MODE_ATOMIC_TEST_ONLY | DRM_MODE_ATOMIC_ALLOW_MODESET);
    return refusal != 0 ? refusal : commit(card_, request.get(), DRM_MODE_ATOMIC_ALLOW_MODESET);
}

int AtomicOutput::flip(std::uint32_t framebuffer) const {
    const DrmAtomicRequest request{drmModeAtomicAlloc()};
    plane_.set(request.get(), "FB_ID", framebuffer);
    return commit(card_, request.get(), DRM_MODE_ATOMIC_NONBLOCK | DRM_MODE_PAGE_FLIP_EVENT);
}

int AtomicOutput::disable() const {
    const DrmAtomicRequest request{drmModeAtomicAlloc()};
    connector_.set(request.get(), "CRTC_ID", 0);
    crtc_.set(request.get(), "ACTIVE", 0);
    crtc_.set(request.get(), "MODE_ID", 0);
    plane_.set(request.get(), "FB_ID", 0);
    plane_.set(request.get(), "CRTC_ID", 0);
    return commit(card_, request.get(), DRM_MODE_ATOMIC_ALLOW_MODESET);
}

}  // namespace quadrat::display
