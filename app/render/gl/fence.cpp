// SPDX-License-Identifier: Apache-2.0
#include "render/gl/fence.hpp"

#include <utility>

namespace quadrat::render::gl {

Fences::~Fences() {
    glFinish();
    for (const Sync& sync : waiting_) glDeleteSync(sync.name);
}

Fences::Sync Fences::set() { return {glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0), ++number_}; }

void Fences::passed(const Sync& sync) {
    std::erase_if(waiting_, [&](const Sync& earlier) {
        if (earlier.number >= sync.number) return false;
        glDeleteSync(earlier.name);
        return true;
    });
    waiting_.push_back(sync);
}

// Asked once, so that frames that nobody waits for do not pile up.
void Fences::given_up(const Sync& sync) {
    if (glClientWaitSync(sync.name, 0, 0) == GL_TIMEOUT_EXPIRED)
        waiting_.push_back(sync);
    else
        passed(sync);
}

void Fence::set() {
    forget();
    sync_ = fences_->set();
}

bool Fence::is_done_within(std::chrono::nanoseconds patience) {
    if (sync_.name == nullptr) return true;
    const auto at_most = static_cast<GLuint64>(patience.count() > 0 ? patience.count() : 0);
    const GLenum status = glClientWaitSync(sync_.name, GL_SYNC_FLUSH_COMMANDS_BIT, at_most);
    if (status == GL_TIMEOUT_EXPIRED) return false;
    fences_->passed(std::exchange(sync_, {}));
    return true;
}

void Fence::forget() {
    if (sync_.name != nullptr) fences_->given_up(std::exchange(sync_, {}));
}

}  // namespace quadrat::render::gl
