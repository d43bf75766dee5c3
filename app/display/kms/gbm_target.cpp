// SPDX-License-Identifier: Apache-2.0
#include "display/kms/gbm_target.hpp"

#include <drm_fourcc.h>
#include <fmt/core.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <array>
#include <cerrno>
#include <utility>

#include "base/error.hpp"
#include "display/kms/atomic_output.hpp"

namespace quadrat::display {
namespace {

// A framebuffer that lives as long as the buffer it shows.
struct Framebuffer {
    int card = -1;
    std::uint32_t id = 0;
};

void remove_framebuffer(gbm_bo*, void* held) {
    const std::unique_ptr<Framebuffer> framebuffer{static_cast<Framebuffer*>(held)};
    drmModeRmFB(framebuffer->card, framebuffer->id);
}

bool takes_modifiers(int card) {
    std::uint64_t value = 0;
    return drmGetCap(card, DRM_CAP_ADDFB2_MODIFIERS, &value) == 0 && value != 0;
}

int add_framebuffer(int card, gbm_bo* buffer, std::uint32_t& id) {
    std::array<std::uint32_t, 4> handles{};
    std::array<std::uint32_t, 4> strides{};
    std::array<std::uint32_t, 4> offsets{};
    std::array<std::uint64_t, 4> modifiers{};
    const std::uint64_t modifier = gbm_bo_get_modifier(buffer);
    const auto planes = static_cast<std::size_t>(gbm_bo_get_plane_count(buffer));
    for (std::size_t i = 0; i < planes && i < handles.size(); ++i) {
        const int plane = static_cast<int>(i);
        handles[i] = gbm_bo_get_handle_for_plane(buffer, plane).u32;
        strides[i] = gbm_bo_get_stride_for_plane(buffer, plane);
        offsets[i] = gbm_bo_get_offset(buffer, plane);
        modifiers[i] = modifier;
    }
    const std::uint32_t width = gbm_bo_get_width(buffer);
    const std::uint32_t height = gbm_bo_get_height(buffer);
    // DRM_FORMAT_MOD_INVALID says that no layout was given: some drivers refuse it as one.
    if (modifier != DRM_FORMAT_MOD_INVALID && takes_modifiers(card) &&
        drmModeAddFB2WithModifiers(card, width, height, kScanoutFormat, handles.data(), strides.data(), offsets.data(),
                                   modifiers.data(), &id, DRM_MODE_FB_MODIFIERS) == 0)
        return 0;
    const int result =
        drmModeAddFB2(card, width, height, kScanoutFormat, handles.data(), strides.data(), offsets.data(), &id, 0);
    return result == 0 ? 0 : errno;
}

}  // namespace

Scanout::Scanout(Scanout&& other) noexcept
    : surface_(other.surface_), buffer_(std::exchange(other.buffer_, nullptr)), framebuffer_(other.framebuffer_) {}

Scanout& Scanout::operator=(Scanout&& other) noexcept {
    std::swap(surface_, other.surface_);
    std::swap(buffer_, other.buffer_);
    std::swap(framebuffer_, other.framebuffer_);
    return *this;
}

Scanout::~Scanout() {
    if (buffer_) gbm_surface_release_buffer(surface_, buffer_);
}

std::unique_ptr<GbmTarget> GbmTarget::open(int card, Size unseen, std::string& why) {
    gbm_device* device = gbm_create_device(card);
    if (!device) {
        why = "GBM cannot use this card (apt install libgbm1 libgl1-mesa-dri)";
        return nullptr;
    }
    auto screen = EglScreen::adopt(eglGetPlatformDisplayEXT(EGL_PLATFORM_GBM_KHR, device, nullptr));
    auto context = screen ? EglContext::open(screen, kScanoutFormat, why) : std::nullopt;
    if (!context) {
        if (!screen) why = "EGL cannot use this card (apt install libegl1 libegl-mesa0 libgl1-mesa-dri)";
        screen.reset();
        gbm_device_destroy(device);
        return nullptr;
    }
    std::unique_ptr<GbmTarget> target{new GbmTarget(card, device, std::move(*context))};
    screen.reset();
    try {
        target->unseen_ = std::make_unique<OffscreenTarget>(unseen);
    } catch (const base::InputError& error) {
        why = error.what();
        return nullptr;
    }
    return target;
}

GbmTarget::GbmTarget(int card, gbm_device* device, EglContext context)
    : card_(card), device_(device), context_(std::move(context)), renderer_(renderer_name()) {}

GbmTarget::~GbmTarget() {
    drop_surface();
    context_->make_current();
    unseen_.reset();
    context_.reset();  // and with its last context EGL's display, before the device under it
    gbm_device_destroy(device_);
}

bool GbmTarget::make_surface(Size size, const std::vector<std::uint64_t>& modifiers) {
    drop_surface();
    const auto width = static_cast<std::uint32_t>(size.width);
    const auto height = static_cast<std::uint32_t>(size.height);
    surface_ =
        modifiers.empty()
            ? gbm_surface_create(device_, width, height, kScanoutFormat, GBM_BO_USE_SCANOUT | GBM_BO_USE_RENDERING)
            : gbm_surface_create_with_modifiers(device_, width, height, kScanoutFormat, modifiers.data(),
                                                static_cast<unsigned>(modifiers.size()));
    if (!surface_) return false;
    egl_surface_ = eglCreatePlatformWindowSurfaceEXT(context_->display(), context_->config(), surface_, nullptr);
    surface_size_ = size;
    if (egl_surface_ != EGL_NO_SURFACE && context_->make_current(egl_surface_)) return true;
    drop_surface();
    return false;
}

void GbmTarget::drop_surface() {
    if (egl_surface_ != EGL_NO_SURFACE) {
        context_->make_current();
        eglDestroySurface(context_->display(), std::exchange(egl_surface_, EGL_NO_SURFACE));
    }
    if (surface_) gbm_surface_destroy(std::exchange(surface_, nullptr));
}

std::uint32_t GbmTarget::make_current() {
    context_->make_current(egl_surface_);
    return surface_ ? 0 : unseen_->framebuffer();
}

std::optional<Scanout> GbmTarget::take_frame(int& error_number) {
    error_number = EIO;
    if (!context_->make_current(egl_surface_) || context_->is_lost()) return std::nullopt;
    if (!eglSwapBuffers(context_->display(), egl_surface_)) return std::nullopt;
    gbm_bo* buffer = gbm_surface_lock_front_buffer(surface_);
    if (!buffer) {
        error_number = ENOMEM;
        return std::nullopt;
    }
    Scanout frame{surface_, buffer, framebuffer_of(buffer, error_number)};
    if (frame.framebuffer() == 0) return std::nullopt;
    return frame;
}

std::uint32_t GbmTarget::framebuffer_of(gbm_bo* buffer, int& error_number) const {
    if (const void* known = gbm_bo_get_user_data(buffer)) return static_cast<const Framebuffer*>(known)->id;
    std::uint32_t id = 0;
    error_number = add_framebuffer(card_, buffer, id);
    if (error_number != 0) return 0;
    gbm_bo_set_user_data(buffer, new Framebuffer{card_, id}, remove_framebuffer);
    return id;
}

}  // namespace quadrat::display
