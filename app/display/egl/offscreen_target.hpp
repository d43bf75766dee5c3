// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "display/display.hpp"

namespace quadrat::display {

// A framebuffer nobody sees: RGBA8, depth 24, stencil 8, in the context that is current, which must be the same one
// when it is destroyed.
class OffscreenTarget {
  public:
    // Throws InputError naming the size when the GPU has no room for it.
    explicit OffscreenTarget(Size size);
    OffscreenTarget(const OffscreenTarget&) = delete;
    OffscreenTarget& operator=(const OffscreenTarget&) = delete;
    ~OffscreenTarget();
    std::uint32_t framebuffer() const { return framebuffer_; }
    Size size() const { return size_; }

  private:
    Size size_;
    std::uint32_t framebuffer_ = 0;
    std::uint32_t colour_ = 0;
    std::uint32_t depth_ = 0;
};

}  // namespace quadrat::display
