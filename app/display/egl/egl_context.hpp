// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <epoxy/egl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace quadrat::display {

// An initialised EGLDisplay, terminated when its last user is gone. EGL gives everybody in the process who asks for one
// platform the same handle and terminates it for all of them, hence shared.
class EglScreen {
  public:
    static std::shared_ptr<EglScreen> adopt(EGLDisplay display);  // nothing, when it cannot be initialised
    EglScreen(const EglScreen&) = delete;
    EglScreen& operator=(const EglScreen&) = delete;
    ~EglScreen();
    EGLDisplay get() const { return display_; }

  private:
    explicit EglScreen(EGLDisplay display) : display_(display) {}
    EGLDisplay display_;
};

enum class HeadlessPlatform { Surfaceless, Device };
inline const std::vector<HeadlessPlatform> kHeadlessPlatforms{HeadlessPlatform::Surfaceless, HeadlessPlatform::Device};

// Every EGL display of this kind that starts; they are kept for the life of the process. Surfaceless: Mesa's, one or
// none. Device: each GPU that has a driver, as NVIDIA's has only this way.
std::vector<std::shared_ptr<EglScreen>> headless_screens(HeadlessPlatform platform);

// A GLES 3.1 context that needs no surface.
class EglContext {
  public:
    // gbm_format: the native format (DRM fourcc) of the surfaces it will draw to; nothing: none, or a pbuffer.
    // Nothing is returned when this screen has no GLES 3.1; `why` then says so.
    static std::optional<EglContext> open(std::shared_ptr<EglScreen> screen, std::optional<std::uint32_t> gbm_format,
                                          std::string& why);
    EglContext(EglContext&& other) noexcept;
    EglContext& operator=(EglContext&&) = delete;
    ~EglContext();

    bool make_current(EGLSurface surface = EGL_NO_SURFACE) const;
    // Whether the GPU was reset and everything in the context is gone, as far as the driver tells. Must be current.
    bool is_lost() const;
    EGLDisplay display() const { return screen_->get(); }
    EGLConfig config() const { return config_; }
    std::uint32_t number() const { return number_; }  // never used twice in a process; from 1

  private:
    EglContext(std::shared_ptr<EglScreen> screen, EGLConfig config, EGLContext context, bool tells_of_resets);
    std::shared_ptr<EglScreen> screen_;
    EGLConfig config_;
    EGLContext context_;
    bool tells_of_resets_;
    std::uint32_t number_;
};

// A new number for a GL context, as in Canvas::context.
std::uint32_t next_context_number();
// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL ES 3.2 Mesa 22.3.6" of the context that is current.
std::string renderer_name();
// "EGL_BAD_ALLOC", for messages.
std::string egl_error_name();

}  // namespace quadrat::display
