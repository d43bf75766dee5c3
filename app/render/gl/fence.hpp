// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <epoxy/gl.h>

#include <chrono>

namespace quadrat::render::gl {

// What was asked of the GPU until now.
class Fence {
  public:
    Fence() = default;
    ~Fence() { forget(); }
    Fence(const Fence&) = delete;
    Fence& operator=(const Fence&) = delete;

    void set() {
        forget();
        sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    }
    // Waits for it so long at most; true when it is done, or none was set.
    bool is_done_within(std::chrono::nanoseconds patience) {
        if (sync_ == nullptr) return true;
        const auto at_most = static_cast<GLuint64>(patience.count() > 0 ? patience.count() : 0);
        const GLenum status = glClientWaitSync(sync_, GL_SYNC_FLUSH_COMMANDS_BIT, at_most);
        if (status == GL_TIMEOUT_EXPIRED) return false;
        forget();
        return true;
    }

  private:
    void forget() {
        if (sync_ != nullptr) glDeleteSync(sync_);
        sync_ = nullptr;
    }
    GLsync sync_ = nullptr;
};

}  // namespace quadrat::render::gl
