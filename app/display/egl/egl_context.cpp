// SPDX-License-Identifier: Apache-2.0
#include "display/egl/egl_context.hpp"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <set>
#include <utility>

namespace quadrat::display {
namespace {

struct OpenScreens {
    std::mutex mutex;
    std::map<EGLDisplay, std::weak_ptr<EglScreen>> by_handle;
    std::set<std::shared_ptr<EglScreen>> kept;
};
// Never destroyed: what is kept must not be terminated after the driver's own static objects are gone.
OpenScreens& open_screens() {
    static auto* screens = new OpenScreens;
    return *screens;
}

// Terminating the last display of a driver unloads it, and the next one loads and starts it anew (60 ms, and Mesa
// forgets a little memory each time): a headless one belongs to nobody's device, so it stays.
void keep(const std::shared_ptr<EglScreen>& screen) {
    OpenScreens& screens = open_screens();
    const std::lock_guard lock(screens.mutex);
    screens.kept.insert(screen);
}

bool has_client_extension(const char* name) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, name); }

std::vector<EGLDeviceEXT> devices() {
    const bool can_enumerate =
        has_client_extension("EGL_EXT_device_enumeration") || has_client_extension("EGL_EXT_device_base");
    if (!can_enumerate || !has_client_extension("EGL_EXT_platform_device")) return {};
    EGLint count = 0;
    if (!eglQueryDevicesEXT(0, nullptr, &count) || count <= 0) return {};
    std::vector<EGLDeviceEXT> found(static_cast<std::size_t>(count));
    if (!eglQueryDevicesEXT(count, found.data(), &count)) return {};
    found.resize(static_cast<std::size_t>(count));
    return found;
}

// With a native format the config must be exactly that one: EGL sorts deeper formats first, and gbm refuses a surface
// whose format is not the config's.
std::optional<EGLConfig> config_for(EGLDisplay display, std::optional<std::uint32_t> gbm_format) {
    const std::array<EGLint, 15> wanted{EGL_SURFACE_TYPE,
                                        gbm_format ? EGL_WINDOW_BIT : EGL_PBUFFER_BIT,
                                        EGL_RENDERABLE_TYPE,
                                        EGL_OPENGL_ES3_BIT,
                                        EGL_RED_SIZE,
                                        8,
                                        EGL_GREEN_SIZE,
                                        8,
                                        EGL_BLUE_SIZE,
                                        8,
                                        EGL_DEPTH_SIZE,
                                        24,
                                        EGL_STENCIL_SIZE,
                                        8,
                                        EGL_NONE};
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted.data(), nullptr, 0, &count) || count <= 0) return std::nullopt;
    std::vector<EGLConfig> configs(static_cast<std::size_t>(count));
    if (!eglChooseConfig(display, wanted.data(), configs.data(), count, &count)) return std::nullopt;
    configs.resize(static_cast<std::size_t>(count));
    for (const EGLConfig config : configs) {
        EGLint format = 0;
        eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_ID, &format);
        if (!gbm_format || static_cast<std::uint32_t>(format) == *gbm_format) return config;
    }
    return std::nullopt;
}

EGLContext create_context(EGLDisplay display, EGLConfig config, bool tells_of_resets) {
    std::vector<EGLint> wanted{EGL_CONTEXT_MAJOR_VERSION_KHR, 3, EGL_CONTEXT_MINOR_VERSION_KHR, 1};
    if (tells_of_resets)
        wanted.insert(wanted.end(),
                      {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT, EGL_LOSE_CONTEXT_ON_RESET_EXT});
    wanted.push_back(EGL_NONE);
    return eglCreateContext(display, config, EGL_NO_CONTEXT, wanted.data());
}

}  // namespace

std::shared_ptr<EglScreen> EglScreen::adopt(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY) return nullptr;
    OpenScreens& screens = open_screens();
    const std::lock_guard lock(screens.mutex);
    if (auto known = screens.by_handle[display].lock()) return known;
    if (!eglInitialize(display, nullptr, nullptr)) return nullptr;
    std::shared_ptr<EglScreen> screen{new EglScreen(display)};
    screens.by_handle[display] = screen;
    return screen;
}

EglScreen::~EglScreen() {
    OpenScreens& screens = open_screens();
    const std::lock_guard lock(screens.mutex);
    // Somebody may have adopted the handle anew between our last user's leaving and this lock: then it stays.
    const auto known = screens.by_handle.find(display_);
    if (known != screens.by_handle.end() && !known->second.expired()) return;
    screens.by_handle.erase(display_);
    eglTerminate(display_);
}

std::vector<std::shared_ptr<EglScreen>> headless_screens(HeadlessPlatform platform) {
    std::vector<std::shared_ptr<EglScreen>> found;
    const auto start = [&found](EGLDisplay display) {
        if (auto screen = EglScreen::adopt(display)) found.push_back(std::move(screen));
    };
    if (!has_client_extension("EGL_EXT_platform_base")) return found;
    if (platform == HeadlessPlatform::Device) {
        for (const EGLDeviceEXT device : devices())
            start(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
    } else if (has_client_extension("EGL_MESA_platform_surfaceless")) {
        start(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    for (const auto& screen : found) keep(screen);
    return found;
}

std::optional<EglContext> EglContext::open(std::shared_ptr<EglScreen> screen, std::optional<std::uint32_t> gbm_format,
                                           std::string& why) {
    const EGLDisplay display = screen->get();
    const std::string name =
        fmt::format("{} EGL {}", eglQueryString(display, EGL_VENDOR), eglQueryString(display, EGL_VERSION));
    if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context")) {
        why = name + " cannot draw without a surface";
        return std::nullopt;
    }
    eglBindAPI(EGL_OPENGL_ES_API);
    const auto config = config_for(display, gbm_format);
    if (!config) {
        why = name + " has no RGB888 + depth 24 + stencil 8 for OpenGL ES 3";
        return std::nullopt;
    }
    // A GPU that hangs is reset by its kernel: a context that asked for it is told so and can be made anew; others go
    // on drawing nothing, or end the process.
    bool tells_of_resets = epoxy_has_egl_extension(display, "EGL_EXT_create_context_robustness");
    EGLContext context = tells_of_resets ? create_context(display, *config, true) : EGL_NO_CONTEXT;
    if (context == EGL_NO_CONTEXT) {
        tells_of_resets = false;
        context = create_context(display, *config, false);
    }
    if (context == EGL_NO_CONTEXT) {
        why = fmt::format("{} has no OpenGL ES 3.1 ({})", name, egl_error_name());
        return std::nullopt;
    }
    EglContext opened{std::move(screen), *config, context, tells_of_resets};
    if (opened.make_current()) return opened;
    why = fmt::format("{} cannot make its context current ({})", name, egl_error_name());
    return std::nullopt;
}

EglContext::EglContext(std::shared_ptr<EglScreen> screen, EGLConfig config, EGLContext context, bool tells_of_resets)
    : screen_(std::move(screen)),
      config_(config),
      context_(context),
      tells_of_resets_(tells_of_resets),
      number_(next_context_number()) {}

EglContext::EglContext(EglContext&& other) noexcept
    : screen_(std::move(other.screen_)),
      config_(other.config_),
      context_(std::exchange(other.context_, EGL_NO_CONTEXT)),
      tells_of_resets_(other.tells_of_resets_),
      number_(other.number_) {}

EglContext::~EglContext() {
    if (context_ == EGL_NO_CONTEXT) return;
    if (eglGetCurrentContext() == context_) eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display(), context_);
}

bool EglContext::make_current(EGLSurface surface) const {
    if (eglGetCurrentContext() == context_ && eglGetCurrentSurface(EGL_DRAW) == surface) return true;
    eglBindAPI(EGL_OPENGL_ES_API);
    return eglMakeCurrent(display(), surface, surface, context_) == EGL_TRUE;
}

bool EglContext::is_lost() const {
    if (!tells_of_resets_) return false;
    if (epoxy_gl_version() >= 32) return glGetGraphicsResetStatus() != GL_NO_ERROR;
    return epoxy_has_gl_extension("GL_EXT_robustness") && glGetGraphicsResetStatusEXT() != GL_NO_ERROR;
}

std::uint32_t next_context_number() {
    static std::atomic<std::uint32_t> last{0};
    return ++last;
}

std::string renderer_name() {
    const auto text = [](GLenum name) {
        const GLubyte* value = glGetString(name);
        return value ? reinterpret_cast<const char*>(value) : "unknown";
    };
    return fmt::format("{}, {}", text(GL_RENDERER), text(GL_VERSION));
}

std::string egl_error_name() {
    const EGLint error = eglGetError();
    switch (error) {
        case EGL_NOT_INITIALIZED:
            return "EGL_NOT_INITIALIZED";
        case EGL_BAD_ACCESS:
            return "EGL_BAD_ACCESS";
        case EGL_BAD_ALLOC:
            return "EGL_BAD_ALLOC";
        case EGL_BAD_ATTRIBUTE:
            return "EGL_BAD_ATTRIBUTE";
        case EGL_BAD_CONFIG:
            return "EGL_BAD_CONFIG";
        case EGL_BAD_CONTEXT:
            return "EGL_BAD_CONTEXT";
        case EGL_BAD_DISPLAY:
            return "EGL_BAD_DISPLAY";
        case EGL_BAD_MATCH:
            return "EGL_BAD_MATCH";
        case EGL_BAD_NATIVE_WINDOW:
            return "EGL_BAD_NATIVE_WINDOW";
        case EGL_BAD_PARAMETER:
            return "EGL_BAD_PARAMETER";
        case EGL_BAD_SURFACE:
            return "EGL_BAD_SURFACE";
        case EGL_CONTEXT_LOST:
            return "EGL_CONTEXT_LOST";
        default:
            return fmt::format("EGL error 0x{:x}", error);
    }
}

}  // namespace quadrat::display
