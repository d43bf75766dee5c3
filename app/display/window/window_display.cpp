// SPDX-License-Identifier: Apache-2.0
#include "display/window/window_display.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <cctype>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "display/egl/egl_context.hpp"
#include "display/monotonic.hpp"
#include "display/options.hpp"
#include "display/window/keys.hpp"
#include "tempo/flight_log.hpp"

namespace quadrat::display {
namespace {

struct EndGlfw {
    void operator()(bool*) const { glfwTerminate(); }
};
// GLFW is one per process and must be ended once, after its windows.
using Glfw = std::unique_ptr<bool, EndGlfw>;

struct CloseWindow {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using Window = std::unique_ptr<GLFWwindow, CloseWindow>;

std::string last_glfw_error() {
    const char* message = nullptr;
    glfwGetError(&message);
    return message ? message : "no reason given";
}

[[noreturn]] void refuse(const std::string& what) {
    throw base::InputError(
        fmt::format("window display: {} ({}); start it from a desktop session, or use --display headless", what,
                    last_glfw_error()));
}

Glfw start_glfw() {
    static bool is_started = false;
    if (!glfwInit()) refuse("no desktop can be reached");
    return Glfw{&is_started};
}

Window make_window(const DisplayOptions& options) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    glfwWindowHint(GLFW_STENCIL_BITS, 8);
    glfwWindowHint(GLFW_ALPHA_BITS, 0);  // a compositor would show the desktop through what is not opaque
    GLFWmonitor* monitor = nullptr;
    Size size = options.size;
    if (size == Size{}) {
        monitor = glfwGetPrimaryMonitor();
        const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
        if (!mode) refuse("the desktop has no monitor");
        glfwWindowHint(GLFW_REFRESH_RATE, mode->refreshRate);
        glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
        size = {mode->width, mode->height};
    }
    Window window{glfwCreateWindow(size.width, size.height, options.title.c_str(), monitor, nullptr)};
    if (!window) refuse("no window with OpenGL ES 3.1 can be opened");
    if (monitor) glfwSetInputMode(window.get(), GLFW_CURSOR, GLFW_CURSOR_HIDDEN);
    return window;
}

std::chrono::nanoseconds refresh_period(GLFWwindow* window) {
    GLFWmonitor* monitor = glfwGetWindowMonitor(window);
    if (!monitor) monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode || mode->refreshRate <= 0) return {};
    return std::chrono::nanoseconds{1'000'000'000 / mode->refreshRate};
}

// GLFW names keys by their place on an American keyboard; a letter should be the one printed on the key.
int token_as_printed(int token, int scancode) {
    const char* printed = glfwGetKeyName(token, scancode);
    if (!printed || printed[0] == '\0' || printed[1] != '\0') return token;
    const auto letter = static_cast<unsigned char>(printed[0]);
    return std::isalpha(letter) && letter < 128 ? std::toupper(letter) : token;
}

class WindowDisplay final : public Display {
  public:
    WindowDisplay(const DisplayOptions& options, std::string why)
        : Display(std::move(why)),
          options_(options),
          glfw_(start_glfw()),
          window_(make_window(options)),
          context_number_(next_context_number()) {
        glfwMakeContextCurrent(window_.get());
        context_ = eglGetCurrentContext();
        glfwSwapInterval(1);
        glfwSetWindowUserPointer(window_.get(), this);
        glfwSetKeyCallback(window_.get(), [](GLFWwindow* window, int token, int scancode, int action, int) {
            static_cast<WindowDisplay*>(glfwGetWindowUserPointer(window))->key_moved(token, scancode, action);
        });
        renderer_ = renderer_name();
        period_ = refresh_period(window_.get());
    }

    std::string_view kind() const override { return "window"; }
    std::string description() const override {
        const Size size = canvas().size;
        return fmt::format("{}, {}x{} window", renderer_, size.width, size.height);
    }
    std::string renderer() const override { return renderer_; }
    Canvas canvas() const override {
        Size size;
        glfwGetFramebufferSize(window_.get(), &size.width, &size.height);
        const bool is_drawable = size.width > 0 && size.height > 0;  // a minimised window may have no pixels at all
        const bool is_seen = is_drawable && power_ == Power::On && !glfwGetWindowAttrib(window_.get(), GLFW_ICONIFIED);
        return {context_number_, 0, is_drawable ? size : Size{1, 1}, options_.rotation, options_.mirroring, is_seen};
    }
    Canvas begin_frame() override {
        glfwPollEvents();
        // Asked of EGL: GLFW does not notice when another display of the process took the thread.
        if (eglGetCurrentContext() != context_) glfwMakeContextCurrent(window_.get());
        return canvas();
    }
    Presented present(const tempo::HandOver& how) override {
        ++frame_;
        if (power_ == Power::Off) {
            flights_.interrupted();
            return {Outcome::Off, shown_frame_, shown_at_, period_, "switched off"};
        }
        if (how.not_before)
            std::this_thread::sleep_until(std::chrono::steady_clock::time_point{how.not_before->time_since_epoch()});
        flights_.handed_over(frame_, how, display_now());
        glfwSwapBuffers(window_.get());
        shown_frame_ = frame_;
        shown_at_ = display_now();
        flights_.shown(shown_at_, period_);
        return {Outcome::Shown, shown_frame_, shown_at_, period_, {}, flights_.take_finished(), {}};
    }
    void set_power(Power power) override {
        if (power == Power::Off && power_ == Power::On) {
            begin_frame();
            glBindFramebuffer(GL_FRAMEBUFFER, 0);
            glDisable(GL_SCISSOR_TEST);
            glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
            glClear(GL_COLOR_BUFFER_BIT);
            glfwSwapBuffers(window_.get());
        }
        power_ = power;
    }
    std::vector<KeyMotion> take_keys() override {
        glfwPollEvents();
        return std::exchange(keys_, {});
    }
    bool wants_to_close() const override { return glfwWindowShouldClose(window_.get()) != 0; }

  private:
    void key_moved(int token, int scancode, int action) {
        if (action == GLFW_REPEAT) return;
        const auto key = key_from_glfw(token_as_printed(token, scancode));
        if (key) keys_.push_back({*key, action == GLFW_PRESS ? KeyMove::Down : KeyMove::Up, monotonic_now()});
    }

    DisplayOptions options_;
    Glfw glfw_;
    Window window_;
    std::uint32_t context_number_;
    EGLContext context_ = EGL_NO_CONTEXT;
    std::string renderer_;
    std::chrono::nanoseconds period_{0};
    std::vector<KeyMotion> keys_;
    Power power_ = Power::On;
    std::uint64_t frame_ = 0;
    std::uint64_t shown_frame_ = 0;
    base::DisplayTime shown_at_{};
    tempo::FlightLog flights_;
};

}  // namespace

std::unique_ptr<Display> open_window(const DisplayOptions& options, std::string why) {
    check(options);
    return std::make_unique<WindowDisplay>(options, std::move(why));
}

}  // namespace quadrat::display
