// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <memory>

#include "render/choose/cover.hpp"
#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/vertex_array.hpp"
#include "render/gl/work.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

void add_cover(gl::Slices& slices, choose::CoverOfScene& cover, const std::shared_ptr<const scene::Scene>& source);

class CoverPass {
  public:
    CoverPass();

    // The instances lie in the buffer.
    gl::Work draw(const choose::CoverOfScene& cover, const choose::CoverSeen& seen,
                  const gl::StreamBuffer& instances) const;

  private:
    gl::Program program_;
    gl::VertexArray layout_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    std::array<std::size_t, scene::kCoverKinds> first_indices_{};
};

}  // namespace quadrat::render::passes
