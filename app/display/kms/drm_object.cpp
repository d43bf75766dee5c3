// SPDX-License-Identifier: Apache-2.0
#include "display/kms/drm_object.hpp"

namespace quadrat::display {

DrmObject::DrmObject(int card, std::uint32_t id, std::uint32_t type) : id_(id) {
    const std::unique_ptr<drmModeObjectProperties, FreeBy<drmModeFreeObjectProperties>> found{
        drmModeObjectGetProperties(card, id, type)};
    for (std::uint32_t i = 0; found && i < found->count_props; ++i) {
        const std::unique_ptr<drmModePropertyRes, FreeBy<drmModeFreeProperty>> property{
            drmModeGetProperty(card, found->props[i])};
        if (property) properties_[property->name] = {property->prop_id, found->prop_values[i]};
    }
}

std::optional<std::uint64_t> DrmObject::value(const std::string& name) const {
    const auto found = properties_.find(name);
    return found == properties_.end() ? std::nullopt : std::optional{found->second.value};
}

bool DrmObject::set(drmModeAtomicReq* request, const std::string& name, std::uint64_t value) const {
    const auto found = properties_.find(name);
    return found != properties_.end() && drmModeAtomicAddProperty(request, id_, found->second.id, value) > 0;
}

std::vector<std::uint8_t> blob_bytes(int card, std::uint64_t blob) {
    const DrmBlob found{blob == 0 ? nullptr : drmModeGetPropertyBlob(card, static_cast<std::uint32_t>(blob))};
    if (!found) return {};
    const auto* bytes = static_cast<const std::uint8_t*>(found->data);
    return {bytes, bytes + found->length};
}

}  // namespace quadrat::display
