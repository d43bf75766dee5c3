// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quadrat::display {

// What libdrm allocates, freed by what it names for it.
template <auto Free>
struct FreeBy {
    template <typename T>
    void operator()(T* pointer) const {
        Free(pointer);
    }
};
using DrmResources = std::unique_ptr<drmModeRes, FreeBy<drmModeFreeResources>>;
using DrmPlanes = std::unique_ptr<drmModePlaneRes, FreeBy<drmModeFreePlaneResources>>;
using DrmPlane = std::unique_ptr<drmModePlane, FreeBy<drmModeFreePlane>>;
using DrmConnector = std::unique_ptr<drmModeConnector, FreeBy<drmModeFreeConnector>>;
using DrmEncoder = std::unique_ptr<drmModeEncoder, FreeBy<drmModeFreeEncoder>>;
using DrmBlob = std::unique_ptr<drmModePropertyBlobRes, FreeBy<drmModeFreePropertyBlob>>;
using DrmVersion = std::unique_ptr<drmVersion, FreeBy<drmFreeVersion>>;
using DrmAtomicRequest = std::unique_ptr<drmModeAtomicReq, FreeBy<drmModeAtomicFree>>;

// The properties of one connector, CRTC or plane, by name.
class DrmObject {
  public:
    DrmObject() = default;
    DrmObject(int card, std::uint32_t id, std::uint32_t type);
    std::uint32_t id() const { return id_; }
    bool has(const std::string& name) const { return properties_.contains(name); }
    // The value when the object was read; nothing when it has no such property.
    std::optional<std::uint64_t> value(const std::string& name) const;
    // False, and nothing added, when the object has no such property.
    bool set(drmModeAtomicReq* request, const std::string& name, std::uint64_t value) const;

  private:
    struct Property {
        std::uint32_t id = 0;
        std::uint64_t value = 0;
    };
    std::uint32_t id_ = 0;
    std::map<std::string, Property> properties_;
};

std::vector<std::uint8_t> blob_bytes(int card, std::uint64_t blob);

}  // namespace quadrat::display
