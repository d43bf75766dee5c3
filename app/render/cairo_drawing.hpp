// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cairo.h>

#include <memory>

#include "mesh/image.hpp"

// What letters and pictograms are drawn with.
namespace quadrat::render {

struct FreeCairo {
    void operator()(cairo_t* c) const { cairo_destroy(c); }
    void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
};
using Surface = std::unique_ptr<cairo_surface_t, FreeCairo>;
using Pen = std::unique_ptr<cairo_t, FreeCairo>;

Surface new_surface(int width, int height);  // clear, premultiplied; at least 1 by 1

// Cairo's premultiplied BGRA words as premultiplied RGBA bytes.
mesh::Image image_of(cairo_surface_t* surface);

// Lays the image over a dark halo of its own outline.
void put_halo_under(mesh::Image& image, float radius_px);

}  // namespace quadrat::render
