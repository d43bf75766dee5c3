// SPDX-License-Identifier: Apache-2.0
#include "render/passes/grid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/gl/buffer_upload.hpp"
#include "render/gl/wires.hpp"

namespace quadrat::render::passes {
namespace {

std::uint16_t share_of(float value, float lowest, float range) {
    return static_cast<std::uint16_t>(std::lround(std::clamp((value - lowest) / range, 0.0F, 1.0F) * 65535.0F));
}

std::vector<GridPlace> places_of(const GridOnGpu& grid, const mesh::Field& height_m, const mesh::Image& kinds) {
    std::vector<GridPlace> places;
    places.reserve(height_m.samples.size());
    for (int row = 0; row < height_m.rows; ++row) {
        for (int column = 0; column < height_m.columns; ++column) {
            const choose::Blocks::Leaving leaving = grid.blocks->leaving(height_m, column, row);
            // Rounded up: it has moved before the level can change. None divides by nothing.
            const float units = std::clamp(std::ceil(leaving.error_m / choose::kErrorUnit_m), 1.0F, 65535.0F);
            GridPlace place{share_of(height_m.at(column, row), grid.lowest_m, grid.range_m),
                            share_of(leaving.coarser_m, grid.lowest_m, grid.range_m),
                            static_cast<std::uint16_t>(units),
                            {255, 0}};
            if (!kinds.bytes.empty()) {
                place.kinds[0] = kinds.pixel(column, row)[0];
                place.kinds[1] = kinds.pixel(column, row)[1];
            }
            places.push_back(place);
        }
    }
    return places;
}

}  // namespace

void add_grid(gl::Slices& slices, GridOnGpu& grid, const std::shared_ptr<gl::BufferPool>& pool,
              const std::shared_ptr<const mesh::Field>& height_m, const std::shared_ptr<const mesh::Image>& kinds,
              const GridShape& shape) {
    grid.cell_m = shape.cell_m;
    grid.columns = height_m->columns;
    const auto places = std::make_shared<std::vector<GridPlace>>();
    slices.prepare([&grid, height_m, kinds, shape, places] {
        const auto [lowest, highest] = std::ranges::minmax(height_m->samples);
        grid.lowest_m = lowest;
        grid.range_m = std::max(highest - lowest, 1e-3F);
        grid.blocks.emplace(*height_m, shape.cell_m, shape.block_cells, shape.hole_half_side_m);
        *places = places_of(grid, *height_m, *kinds);
    });
    gl::add_elements<GridPlace>(slices, grid.places, pool, GL_ARRAY_BUFFER, height_m->samples.size(),
                                [places] { return std::span<const GridPlace>(*places); });
}

void set_grid(const GridOnGpu& grid, const choose::IndexRange& range) {
    const auto columns = static_cast<float>(grid.columns);
    glUniform4f(0, grid.cell_m, columns, grid.lowest_m, grid.range_m);
    glUniform4f(2, range.ease, choose::Blocks::kEaseFrom / (1 - choose::Blocks::kEaseFrom), 1 / columns,
                (columns - 1) / 2);
}

gl::Work draw_indices(const gl::VertexArray& vertices, const gl::StreamBuffer& indices, std::size_t first,
                      std::size_t count) {
    vertices.feed_indices(indices.name());
    gl::draw_triangles(GL_UNSIGNED_INT, first, count);
    return gl::work_of_mesh(count);
}

}  // namespace quadrat::render::passes
