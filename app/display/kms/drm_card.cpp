// SPDX-License-Identifier: Apache-2.0
#include "display/kms/drm_card.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace quadrat::display {
namespace {

ConnectorUse use_of(std::uint32_t type) {
    if (type == DRM_MODE_CONNECTOR_WRITEBACK) return ConnectorUse::Writeback;
    return type == DRM_MODE_CONNECTOR_VIRTUAL ? ConnectorUse::Virtual : ConnectorUse::Screen;
}

Plug plug_of(drmModeConnection connection) {
    if (connection == DRM_MODE_CONNECTED) return Plug::Connected;
    return connection == DRM_MODE_DISCONNECTED ? Plug::Disconnected : Plug::Unknown;
}

ScreenMode described(const drmModeModeInfo& mode) {
    return {{mode.hdisplay, mode.vdisplay},
            refresh_hz_of(mode),
            (mode.type & DRM_MODE_TYPE_PREFERRED) != 0,
            (mode.flags & DRM_MODE_FLAG_INTERLACE) != 0};
}

std::string driver_of(int card) {
    const DrmVersion version{drmGetVersion(card)};
    return version && version->name ? std::string(version->name, static_cast<std::size_t>(version->name_len))
                                    : "unknown";
}

}  // namespace

double refresh_hz_of(const drmModeModeInfo& mode) {
    const double pixels = static_cast<double>(mode.htotal) * mode.vtotal;
    if (pixels <= 0.0) return mode.vrefresh;
    double hz = mode.clock * 1000.0 / pixels;
    if ((mode.flags & DRM_MODE_FLAG_INTERLACE) != 0) hz *= 2.0;
    if ((mode.flags & DRM_MODE_FLAG_DBLSCAN) != 0) hz /= 2.0;
    return mode.vscan > 1 ? hz / mode.vscan : hz;
}

std::vector<std::string> card_paths() {
    std::vector<std::pair<int, std::string>> found;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator("/dev/dri", error)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("card")) found.emplace_back(std::atoi(name.c_str() + 4), entry.path().string());
    }
    std::sort(found.begin(), found.end());
    std::vector<std::string> paths;
    paths.reserve(found.size());
    for (auto& [number, path] : found) paths.push_back(std::move(path));
    return paths;
}

DrmCard::DrmCard(std::string path) {
    description_.path = std::move(path);
    description_.driver = "unknown";
    descriptor_.reset(::open(description_.path.c_str(), O_RDWR | O_CLOEXEC | O_NOCTTY));
    if (!descriptor_) {
        refuse(errno);
        return;
    }
    description_.driver = driver_of(descriptor());
    description_.is_atomic = drmSetClientCap(descriptor(), DRM_CLIENT_CAP_UNIVERSAL_PLANES, 1) == 0 &&
                             drmSetClientCap(descriptor(), DRM_CLIENT_CAP_ATOMIC, 1) == 0;
    look(Asking::InFull);
}

void DrmCard::refuse(int error_number) {
    description_.problem = error_number == EACCES || error_number == EPERM
                               ? "may not be opened; add the user to the group video: adduser USER video"
                               : fmt::format("cannot be opened ({})", std::strerror(error_number));
}

const Card& DrmCard::look(Asking asking) {
    if (!descriptor_) return description_;
    const DrmResources resources{drmModeGetResources(descriptor())};
    description_.connectors.clear();
    for (int i = 0; resources && i < resources->count_connectors; ++i) {
        const std::uint32_t id = resources->connectors[i];
        const DrmConnector connector{asking == Asking::InFull ? drmModeGetConnector(descriptor(), id)
                                                              : drmModeGetConnectorCurrent(descriptor(), id)};
        if (!connector) continue;  // a connector of a dock that left between the two calls
        if (asking == Asking::InFull) modes_[id] = {connector->modes, connector->modes + connector->count_modes};
        description_.connectors.push_back(described(*connector));
    }
    return description_;
}

Connector DrmCard::described(const drmModeConnector& connector) const {
    Connector told;
    told.id = connector.connector_id;
    const char* type = drmModeGetConnectorTypeName(connector.connector_type);
    told.name = fmt::format("{}-{}", type ? type : "Unknown", connector.connector_type_id);
    told.use = use_of(connector.connector_type);
    told.plug = plug_of(connector.connection);
    for (int i = 0; i < connector.count_modes; ++i) told.modes.push_back(display::described(connector.modes[i]));
    const DrmObject properties{descriptor(), told.id, DRM_MODE_OBJECT_CONNECTOR};
    told.is_link_bad = properties.value("link-status").value_or(DRM_MODE_LINK_STATUS_GOOD) == DRM_MODE_LINK_STATUS_BAD;
    told.edid = blob_bytes(descriptor(), properties.value("EDID").value_or(0));
    return told;
}

std::vector<drmModeModeInfo> DrmCard::modes_of(std::uint32_t connector) const {
    const auto found = modes_.find(connector);
    return found == modes_.end() ? std::vector<drmModeModeInfo>{} : found->second;
}

// Whoever opened a free card first has the right already; asking again then succeeds too.
bool DrmCard::take_master() const { return drmIsMaster(descriptor()) || drmSetMaster(descriptor()) == 0; }

}  // namespace quadrat::display
