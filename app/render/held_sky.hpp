// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>

#include "render/choose/view_block.hpp"
#include "render/gl/buffer.hpp"
#include "render/gl/texture_target.hpp"
#include "render/passes/sky.hpp"
#include "render/renderer.hpp"

namespace quadrat::render {

// One view's dome and clouds as a picture that serves some frames: a little wider than the view and coarser, for clouds
// are soft. In between it moves with the layer of cloud that hides most: the lower clouds turn about the eye; a flat
// layer that drifts over an eye that moves shears the directions in which it is seen. Either is a matrix. The other
// layer and the dome go with it, and are put right when the view has its turn: a pixel or two overhead where the wind
// is strong.
class HeldSky {
  public:
    static constexpr std::size_t kFrames = 4;  // from one turn of a view to its next

    // What a picture is of.
    struct Sight {
        std::weak_ptr<const GpuScene> scene;
        Rect viewport;
        float fov_deg = 0;
        choose::ViewBlock block;
    };

    // From the view's clip xy and 1 to coordinates of picture(), times depth. now: the view's block of this frame.
    // None: what is held would leave a corner of the view bare, or is of another scene, or too old for its dome.
    std::optional<glm::mat3> from_view(const View& view, const choose::ViewBlock& now) const;

    // Where the skies of all views are drawn, one at a time: what they show is a copy.
    class Canvas {
      public:
        // Leaves the framebuffer that was bound bound, and no test enabled.
        gl::Work draw(const View& view, float seconds, const passes::SkyPass& sky);

      private:
        friend class HeldSky;
        gl::TextureTarget target_;
        gl::Texture2D picture_;
        gl::StreamBuffer block_{GL_UNIFORM_BUFFER};
        Sight drawn_;
    };
    // Holds what was drawn there last. A software rasteriser finishes it first: a frame later it has.
    void take(const Canvas& canvas);

    const gl::Texture2D& picture() const { return picture_; }
    // Of its light, where the view has been dimmed since.
    float kept(const choose::ViewBlock& now) const { return now.to_sun.w / held_.block.to_sun.w; }

  private:
    Sight held_;
    gl::Texture2D picture_;
};

}  // namespace quadrat::render
