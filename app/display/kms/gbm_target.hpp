// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gbm.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "display/display.hpp"
#include "display/egl/egl_context.hpp"
#include "display/egl/offscreen_target.hpp"

namespace quadrat::display {

// A drawn buffer on its way to the screen. The surface takes it back when this goes.
class Scanout {
  public:
    Scanout(gbm_surface* surface, gbm_bo* buffer, std::uint32_t framebuffer)
        : surface_(surface), buffer_(buffer), framebuffer_(framebuffer) {}
    Scanout(Scanout&& other) noexcept;
    Scanout& operator=(Scanout&& other) noexcept;
    ~Scanout();
    std::uint32_t framebuffer() const { return framebuffer_; }

  private:
    gbm_surface* surface_;
    gbm_bo* buffer_;
    std::uint32_t framebuffer_;
};

// What is drawn on a card, and with what: its buffers through GBM, its GPU through EGL. On a Raspberry Pi the card that
// shows has no GPU of its own; Mesa pairs it with the one that draws, on this same descriptor.
class GbmTarget {
  public:
    // The descriptor is borrowed and must outlive this. unseen: the size drawn while there is no screen.
    // Nothing: there is no GLES 3.1 for this card; `why` says so.
    static std::unique_ptr<GbmTarget> open(int card, Size unseen, std::string& why);
    ~GbmTarget();
    GbmTarget(const GbmTarget&) = delete;
    GbmTarget& operator=(const GbmTarget&) = delete;

    std::uint32_t context_number() const { return context_->number(); }
    const std::string& renderer() const { return renderer_; }

    // A surface of this size in one of these layouts, or, with none given, in one that the card surely shows.
    // False: there is none. The one before is gone in either case, with all its Scanouts, which must be gone already.
    bool make_surface(Size size, const std::vector<std::uint64_t>& modifiers);
    void drop_surface();
    // The surface when there is one, else the unseen framebuffer. Makes the context current.
    std::uint32_t make_current();
    Size size() const { return surface_ ? surface_size_ : unseen_->size(); }
    bool has_surface() const { return surface_ != nullptr; }

    // Ends the frame. Nothing: `error_number` says why; EIO when the GPU lost its context.
    std::optional<Scanout> take_frame(int& error_number);

  private:
    GbmTarget(int card, gbm_device* device, EglContext context);
    std::uint32_t framebuffer_of(gbm_bo* buffer, int& error_number) const;

    int card_;
    gbm_device* device_;
    std::optional<EglContext> context_;  // optional, so that it can go before the device under it
    std::string renderer_;
    std::unique_ptr<OffscreenTarget> unseen_;
    gbm_surface* surface_ = nullptr;
    EGLSurface egl_surface_ = EGL_NO_SURFACE;
    Size surface_size_;
};

}  // namespace quadrat::display
