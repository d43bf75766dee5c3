// SPDX-License-Identifier: Apache-2.0
#include "render/gl/buffer_pool.hpp"

#include <algorithm>

namespace quadrat::render::gl {
namespace {

constexpr std::size_t kLargeBytes = 512U << 10U;
// So that what is a little larger fits too.
constexpr std::size_t kStepBytes = 128U << 10U;

bool is_free(const std::shared_ptr<Buffer>& buffer) { return buffer.use_count() == 1; }

}  // namespace

std::shared_ptr<Buffer> BufferPool::take(GLenum target, std::size_t bytes) {
    if (bytes < kLargeBytes) return std::make_shared<Buffer>(target, bytes);
    auto best = pooled_.end();
    for (auto it = pooled_.begin(); it != pooled_.end(); ++it) {
        const std::size_t has = it->buffer->bytes();
        if (it->target != target || !is_free(it->buffer) || has < bytes || has > 2 * bytes + kStepBytes) continue;
        if (best == pooled_.end() || has < best->buffer->bytes()) best = it;
    }
    if (best != pooled_.end()) {
        std::rotate(best, best + 1, pooled_.end());
        std::shared_ptr<Buffer> taken = pooled_.back().buffer;
        trim(kMostFreeBytes);
        return taken;
    }
    trim(kMostFreeBytes);
    const std::size_t rounded = (bytes + kStepBytes - 1) / kStepBytes * kStepBytes;
    pooled_.push_back({target, std::make_shared<Buffer>(target, rounded)});
    return pooled_.back().buffer;
}

void BufferPool::trim(std::size_t most_free_bytes) {
    std::size_t free_bytes = 0;
    for (const Pooled& pooled : pooled_)
        if (is_free(pooled.buffer)) free_bytes += pooled.buffer->bytes();
    std::erase_if(pooled_, [&](const Pooled& pooled) {
        if (!is_free(pooled.buffer) || free_bytes <= most_free_bytes) return false;
        free_bytes -= pooled.buffer->bytes();
        return true;
    });
}

}  // namespace quadrat::render::gl
