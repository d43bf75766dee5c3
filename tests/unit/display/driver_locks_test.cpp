// SPDX-License-Identifier: Apache-2.0
// A driver that destroys a lock under the thread that is leaving it.
#include <dlfcn.h>
#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "display/headless/headless_display.hpp"

using namespace std::chrono_literals;

namespace {

std::atomic<bool> lingers{false};
std::atomic<int> lingered{0};
std::atomic<int> overwritten{0};

// A rasterising thread tells that its part of a picture is done, and has the fence's lock still: it is kept there as
// long as the system may keep it.
void linger(const pthread_mutex_t& held) {
    const int holder = held.__data.__owner;
    ++lingered;
    std::this_thread::sleep_for(2ms);
    if (held.__data.__owner != holder) ++overwritten;
}

bool is_rasterising() {
    std::array<char, 16> name{};
    return ::pthread_getname_np(::pthread_self(), name.data(), name.size()) == 0 &&
           std::string_view(name.data()).starts_with("llvmpipe");
}

}  // namespace

// The driver finds this one. A fence has its condition right after its lock.
extern "C" __attribute__((visibility("default"))) int pthread_cond_broadcast(pthread_cond_t* condition) noexcept {
    using Broadcast = int (*)(pthread_cond_t*);
    static const auto system_s =
        reinterpret_cast<Broadcast>(::dlvsym(RTLD_NEXT, "pthread_cond_broadcast", "GLIBC_2.3.2"));
    static const auto newer = reinterpret_cast<Broadcast>(::dlsym(RTLD_NEXT, "pthread_cond_broadcast"));
    if (lingers && is_rasterising()) linger(reinterpret_cast<const pthread_mutex_t*>(condition)[-1]);
    return (system_s != nullptr ? system_s : newer)(condition);
}

namespace quadrat::display {
namespace {

TEST(DriverLocks, OneThatIsHeldIsDestroyedWhenItIsLeft) {
    pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    std::atomic<bool> is_held{false};
    std::atomic<bool> is_left{false};
    std::jthread holder([&] {
        ::pthread_mutex_lock(&lock);
        is_held = true;
        std::this_thread::sleep_for(50ms);
        is_left = true;
        ::pthread_mutex_unlock(&lock);
    });
    while (!is_held) std::this_thread::yield();
    EXPECT_EQ(::pthread_mutex_destroy(&lock), 0);
    EXPECT_TRUE(is_left);
}

// Memory of about a fence's size, that somebody else writes to.
void use_what_is_free() {
    std::vector<std::unique_ptr<std::string>> taken;
    for (std::size_t size = 80; size <= 144; size += 16)
        for (int i = 0; i < 4; ++i) taken.push_back(std::make_unique<std::string>(size, '?'));
}

// Two pictures at a time: the driver itself drops the fence of one that seems done when it wants room for the next.
void draw_in_turns(int pictures) {
    std::array<GLuint, 2> textures{};
    std::array<GLuint, 2> targets{};
    glGenTextures(2, textures.data());
    glGenFramebuffers(2, targets.data());
    for (std::size_t i = 0; i < 2; ++i) {
        glBindTexture(GL_TEXTURE_2D, textures[i]);
        glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 64, 64);
        glBindFramebuffer(GL_FRAMEBUFFER, targets[i]);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[i], 0);
    }
    for (int i = 0; i < pictures; ++i) {
        glBindFramebuffer(GL_FRAMEBUFFER, targets[static_cast<std::size_t>(i % 2)]);
        glClear(GL_COLOR_BUFFER_BIT);
        GLsync sync = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        glFlush();
        // Asked, not waited for, as a frame that has other things to do asks.
        while (glClientWaitSync(sync, 0, 0) == GL_TIMEOUT_EXPIRED) std::this_thread::yield();
        glDeleteSync(sync);
        use_what_is_free();
    }
    glFinish();
    glDeleteFramebuffers(2, targets.data());
    glDeleteTextures(2, textures.data());
}

TEST(DriverLocks, NoFenceIsFreedUnderTheThreadThatIsLeavingIt) {
    DisplayOptions options;
    options.size = {64, 32};
    const auto display = open_headless(options, "asked for");
    display->begin_frame();
    if (std::strstr(reinterpret_cast<const char*>(glGetString(GL_RENDERER)), "llvmpipe") == nullptr)
        GTEST_SKIP() << "another driver";
    lingers = true;
    draw_in_turns(100);
    lingers = false;
    EXPECT_GT(lingered, 50) << "nobody was kept: this shows nothing";
    EXPECT_EQ(overwritten, 0);
}

}  // namespace
}  // namespace quadrat::display
