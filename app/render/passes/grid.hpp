// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>

#include "mesh/field.hpp"
#include "mesh/image.hpp"
#include "mesh/roam.hpp"
#include "render/choose/blocks.hpp"
#include "render/choose/ranges.hpp"
#include "render/gl/buffer_pool.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/vertex_array.hpp"
#include "render/gl/work.hpp"

namespace quadrat::render::passes {

// A sample as shaders/common/grid.glsl reads it; its number tells where it lies.
struct GridPlace {
    std::uint16_t height;   // share of the heights' range
    std::uint16_t coarser;  // the same, on the next coarser level (Blocks::Leaving)
    std::uint16_t error;    // in choose::kErrorUnit_m
    std::uint8_t kinds[2];  // how far its grain is soft ground's, how far stone's
};

// A heightfield's vertices; which of its triangles are drawn is chosen every frame.
struct GridOnGpu {
    std::shared_ptr<gl::Buffer> places;  // GridPlace a sample
    std::optional<choose::Blocks> blocks;
    // Its triangles, where they are drawn instead; where its blocks are, none. As it is for the eye that was last: who
    // draws it for another one updates it first, and keeps no more of it than indices.
    std::unique_ptr<mesh::Roam> roam;
    float cell_m = 1;
    int columns = 1;
    float lowest_m = 0;
    float range_m = 1;  // of the heights
};

struct GridShape {
    float cell_m = 1;
    int block_cells = 16;
    float hole_half_side_m = 0;  // see Blocks
};

// Adds the slices that fill grid, which must stay where it is until they are done. kinds: as scene::Land has them, or
// an empty picture.
void add_grid(gl::Slices& slices, GridOnGpu& grid, const std::shared_ptr<gl::BufferPool>& pool,
              const std::shared_ptr<const mesh::Field>& height_m, const std::shared_ptr<const mesh::Image>& kinds,
              const GridShape& shape);

// The uniforms of shaders/common/grid.glsl in the program that is used.
void set_grid(const GridOnGpu& grid, const choose::IndexRange& range);

inline const std::initializer_list<gl::Attribute> kPlaceAttributes{
    {1, 2, GL_UNSIGNED_SHORT, gl::Numbers::Normalised, offsetof(GridPlace, height)},
    {3, 2, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(GridPlace, kinds)},
    {5, 1, GL_UNSIGNED_SHORT, gl::Numbers::AsTheyAre, offsetof(GridPlace, error)}};

// Of the vertex array that is bound.
gl::Work draw_indices(const gl::VertexArray& vertices, const gl::StreamBuffer& indices, std::size_t first,
                      std::size_t count);

}  // namespace quadrat::render::passes
