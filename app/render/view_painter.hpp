// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "render/gl/buffer.hpp"
#include "render/held_ground.hpp"
#include "render/held_sky.hpp"
#include "render/passes/cover.hpp"
#include "render/passes/distance.hpp"
#include "render/passes/falling.hpp"
#include "render/passes/ground.hpp"
#include "render/passes/houses.hpp"
#include "render/passes/plants.hpp"
#include "render/passes/sky.hpp"
#include "render/passes/smoke.hpp"
#include "render/passes/stone.hpp"
#include "render/passes/water.hpp"
#include "render/renderer.hpp"
#include "render/selection.hpp"

namespace quadrat::render {

// What is sent for one picture of a view, in buffers that are kept.
struct Stock {
    HeldGround ground;
    gl::StreamBuffer instances{GL_ARRAY_BUFFER};
    gl::StreamBuffer cover{GL_ARRAY_BUFFER};
};

// Clears what the scissor box leaves of the framebuffer that is bound, and sets what all passes want. A tiler keeps the
// whole frame on its chip when colour, depth and stencil are cleared first, in one go.
void begin_drawing(const glm::vec4& colour, bool is_mirrored);

// Draws one view, or the part of it that was selected, with all passes.
class ViewPainter {
  public:
    // What of a view was drawn some frames ago; the selection says whether it serves.
    struct Held {
        const HeldSky* sky = nullptr;
        const gl::Texture2D* distance = nullptr;
    };
    // Sends its plants, drawn as closely as step says. Adds to drawn.sent_bytes.
    void send_plants(const Frame& frame, const View& view, int step, Selection& selection, Stock& stock, Drawn& drawn);
    // Into the viewport `place` of the framebuffer that is bound, no more than what the scissor box leaves; the view's
    // block is bound. Adds to drawn.of.
    void draw(const Frame& frame, const View& view, const Selection& selection, const Stock& stock, const Held& held,
              const Rect& place, Drawn& drawn) const;

    const passes::SkyPass& sky() const { return sky_; }

  private:
    void draw_plants(const View& view, const Selection& selection, const Stock& stock, Drawn& drawn) const;
    void draw_ground(const View& view, const Selection& selection, const Stock& stock, Drawn& drawn) const;
    void draw_water(const Frame& frame, const View& view, const Selection& selection, Drawn& drawn) const;
    void draw_sky(const View& view, const Selection& selection, const Held& held, const Rect& place,
                  Drawn& drawn) const;

    passes::GroundPass ground_;
    passes::SurroundPass surround_;
    passes::StonePass stone_;
    passes::HousesPass houses_;
    passes::SmokePass smoke_;
    passes::CoverPass cover_;
    passes::PlantsPass plants_;
    passes::WaterPass water_;
    passes::SkyPass sky_;
    passes::DistancePass distance_;
    passes::FallingPass falling_;
    std::vector<choose::Instance> view_instances_;  // kept from view to view for its memory only
};

}  // namespace quadrat::render
