// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "render/gl/picture_upload.hpp"
#include "render/passes/encode.hpp"
#include "render/passes/packing.hpp"

namespace quadrat::render::passes {
namespace {

struct GridPlace {
    std::int16_t column;
    std::int16_t row;
    float height_m;
    std::uint8_t kinds[4];  // how far its grain is soft ground's, how far stone's; two to spare
};

// Of the surround, which has no picture of its own.
struct Facing {
    PackedNormal normal;
    std::uint8_t root_colour[4];
};


constexpr int kSurroundBlock = 8;
constexpr std::size_t kPieceBytes = 128U << 10U;

void write_places(GridOnGpu& grid, const mesh::Field& field, const mesh::Image& kinds, std::size_t first,
                  std::size_t count) {
    std::vector<GridPlace> places(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto at = static_cast<int>(first + i);
        const int column = at % field.columns;
        const int row = at / field.columns;
        places[i] = {static_cast<std::int16_t>(column),
                     static_cast<std::int16_t>(row),
                     field.samples[first + i],
                     {255, 0, 0, 0}};
        if (kinds.bytes.empty()) continue;
        places[i].kinds[0] = kinds.pixel(column, row)[0];
        places[i].kinds[1] = kinds.pixel(column, row)[1];
    }
    grid.places.write<GridPlace>(first, places);
}

PackedNormal normal_at(const mesh::Field& field, float cell_m, int column, int row) {
    const auto height = [&](int c, int r) {
        return field.at(std::clamp(c, 0, field.columns - 1), std::clamp(r, 0, field.rows - 1));
    };
    return packed_normal(glm::normalize(glm::vec3{height(column - 1, row) - height(column + 1, row), 2 * cell_m,
                                                  height(column, row - 1) - height(column, row + 1)}));
}

void write_facings(GridOnGpu& grid, const scene::Land& land, std::size_t first, std::size_t count) {
    const mesh::Field& field = land.surround_m;
    std::vector<Facing> facings(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto at = static_cast<int>(first + i);
        const int column = at % field.columns;
        const int row = at / field.columns;
        Facing& facing = facings[i];
        facing.normal = normal_at(field, grid.cell_m, column, row);
        for (int c = 0; c < 3; ++c)
            facing.root_colour[c] = land.surround_albedo.bytes.empty()
                                        ? unsigned_byte(std::sqrt(land.far_colour[c]))
                                        : gl::root_of_srgb(land.surround_albedo.pixel(column, row)[c]);
    }
    grid.facings.write<Facing>(first, facings);
}

void add_places(gl::Slices& slices, GridOnGpu& grid, std::shared_ptr<const mesh::Field> field,
                std::shared_ptr<const mesh::Image> kinds, float cell_m) {
    const std::size_t samples = field->samples.size();
    grid.cell_m = cell_m;
    grid.middle_column = static_cast<float>(field->columns - 1) / 2;
    slices.add(0, [&grid, samples] { grid.places = gl::Buffer{GL_ARRAY_BUFFER, samples * sizeof(GridPlace)}; });
    slices.add_pieces(samples, kPieceBytes / sizeof(GridPlace), sizeof(GridPlace),
                      [&grid, field, kinds](std::size_t first, std::size_t count) {
                          write_places(grid, *field, *kinds, first, count);
                      });
}

void add_blocks(gl::Slices& slices, GridOnGpu& grid, const std::shared_ptr<const mesh::Field>& field, float cell_m,
                int block_cells, float hole_m) {
    grid.blocks.emplace(Blocks::Unmeasured{}, field->columns, cell_m, block_cells, hole_m);
    // Measuring a row of blocks takes as long as moving so much.
    slices.add_pieces(static_cast<std::size_t>(grid.blocks->blocks_a_side()), 1, kPieceBytes,
                      [&grid, field](std::size_t row, std::size_t) {
                          grid.blocks->measure_row(*field, static_cast<int>(row));
                      });
}

void add_facings(gl::Slices& slices, GridOnGpu& grid, std::shared_ptr<const scene::Land> land) {
    const std::size_t samples = land->surround_m.samples.size();
    slices.add(0, [&grid, samples] { grid.facings = gl::Buffer{GL_ARRAY_BUFFER, samples * sizeof(Facing)}; });
    slices.add_pieces(
        samples, kPieceBytes / sizeof(Facing), sizeof(Facing),
        [&grid, land](std::size_t first, std::size_t count) { write_facings(grid, *land, first, count); });
}

// The ground's grain in the light of the sun, which stands still: what faces it is brighter than level ground, what
// turns away darker.
void light_grain_row(const scene::Land& land, glm::vec3 to_sun, mesh::Image& lit, int row) {
    const glm::vec2 tilt = glm::vec2{to_sun.x, to_sun.z} / std::max(to_sun.y, 0.35F);
    const int channels = land.detail.channels;
    for (int x = 0; x < lit.width; ++x) {
        for (int kind = 0; kind < 2; ++kind) {
            float light = static_cast<float>(land.detail.pixel(x, row)[std::min(kind, channels - 1)]);
            if (!land.detail_slopes.bytes.empty()) {
                const std::uint8_t* slopes = land.detail_slopes.pixel(x, row) + 2 * kind;
                const glm::vec2 rise{static_cast<float>(slopes[0]) - 128, static_cast<float>(slopes[1]) - 128};
                light -= glm::dot(rise, tilt);
            }
            lit.pixel(x, row)[kind] = static_cast<std::uint8_t>(std::clamp(light + 0.5F, 0.0F, 255.0F));
        }
    }
}

// The grain once more, larger and turned, as a relief of metres that the ground's picture holds itself.
class CoarseRelief {
  public:
    // grain: lit.
    CoarseRelief(const scene::Land& land, const mesh::Image& grain) : land_(land), relief_(gl::halved(grain)) {}

    // Brighter and darker, by what each kind of ground has of it.
    void add_to(mesh::Image& shown, int row) const {
        const float per_px = land_.side_m() / (static_cast<float>(shown.width) * land_.detail_tile_m) * kTiles;
        const float z = (static_cast<float>(row) + 0.5F - 0.5F * static_cast<float>(shown.height)) * per_px;
        const float x0 = (0.5F - 0.5F * static_cast<float>(shown.width)) * per_px;
        const mesh::Image& kinds = land_.kinds;
        const int across = relief_.width - 1;  // a power of two
        const int down = relief_.height - 1;
        const std::uint8_t* kind_row =
            kinds.bytes.empty() ? nullptr : kinds.pixel(0, row * (kinds.height - 1) / (shown.height - 1));
        for (int x = 0; x < shown.width; ++x) {
            const float east = x0 + static_cast<float>(x) * per_px;
            const int u = static_cast<int>(std::floor((east - 0.5F * z) * static_cast<float>(relief_.width)));
            const int v = static_cast<int>(std::floor((z + 0.5F * east) * static_cast<float>(relief_.height)));
            const std::uint8_t* lit = relief_.pixel(u & across, v & down);
            const std::uint8_t* kind =
                kind_row == nullptr ? kSoft : kind_row + kinds.channels * (x * (kinds.width - 1) / (shown.width - 1));
            // In 1/65536 of the brightness.
            const int more = (((lit[0] - 128) * kind[0] + (lit[1] - 128) * kind[1]) * kStrength) >> 16;
            std::uint8_t* out = shown.pixel(x, row);
            for (int c = 0; c < 3; ++c)
                out[c] = static_cast<std::uint8_t>(std::clamp((out[c] * (65536 + more) + 32768) >> 16, 0, 255));
        }
    }

  private:
    static constexpr float kTiles = 0.107F;  // of it to one of the grain
    static constexpr int kStrength = static_cast<int>(0.5F * kGrain * 65536 / (255 * 255) * 65536);
    static constexpr std::uint8_t kSoft[2] = {255, 0};
    const scene::Land& land_;
    mesh::Image relief_;
};

// The light over one row of the ground's picture, as roots: between the rows and columns of a coarser image.
struct LightRow {
    const mesh::Image& light;
    float down;
    int upper;
    int lower;

    LightRow(const mesh::Image& light_, int row, int rows) : light(light_) {
        const float at =
            (static_cast<float>(row) + 0.5F) * static_cast<float>(light.height) / static_cast<float>(rows) - 0.5F;
        const int above = static_cast<int>(std::floor(at));
        down = at - static_cast<float>(above);
        upper = std::clamp(above, 0, light.height - 1);
        lower = std::clamp(above + 1, 0, light.height - 1);
    }
    float at(int column, int channel) const {
        const float a = light.pixel(column, upper)[channel];
        const float b = light.pixel(column, lower)[channel];
        return a + (b - a) * down;
    }
};

// Depth of water as the eye takes it: what light is lost on the way down and up. The rim is deep: all beyond it repeats
// the rim.
std::array<std::uint8_t, 256> deepness_of_depth() {
    std::array<std::uint8_t, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = unsigned_byte(1 - std::exp(-0.35F * 24.0F * static_cast<float>(i) / 255));
    return table;
}

// What is shown for the root of a light; entry i: root i / 4 / 255, to the root of two.
std::array<std::uint8_t, 1445> shown_by_root() {
    std::array<std::uint8_t, 1445> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = unsigned_byte(encode_root(static_cast<float>(i) / (4 * 255)));
    return table;
}

void light_row(const mesh::Image& albedo, const mesh::Image& light, mesh::Image& lit, int row) {
    static const auto deepness = deepness_of_depth();
    static const auto shown = shown_by_root();
    const LightRow over(light, row, lit.height);
    std::vector<float> smooth(static_cast<std::size_t>(light.width + 1) * 4);
    for (int column = 0; column <= light.width; ++column)
        for (int c = 0; c < 4; ++c)
            smooth[static_cast<std::size_t>(4 * column + c)] = over.at(std::min(column, light.width - 1), c);
    const float step = static_cast<float>(light.width) / static_cast<float>(lit.width);
    for (int x = 0; x < lit.width; ++x) {
        const float at = std::max((static_cast<float>(x) + 0.5F) * step - 0.5F, 0.0F);
        const auto left = static_cast<int>(at);
        const float aside = at - static_cast<float>(left);
        const float* from = &smooth[static_cast<std::size_t>(4 * left)];
        const std::uint8_t* colour = albedo.pixel(x, row);
        std::uint8_t* out = lit.pixel(x, row);
        for (int c = 0; c < 3; ++c) {
            const float halved_light = from[c] + (from[c + 4] - from[c]) * aside;
            const float root = static_cast<float>(gl::root_of_srgb(colour[c])) * std::sqrt(halved_light * (2.0F / 255));
            out[c] = shown[static_cast<std::size_t>(4 * root + 0.5F)];
        }
        const bool is_rim = row == 0 || x == 0 || row == lit.height - 1 || x == lit.width - 1;
        out[3] = is_rim ? std::uint8_t{255}
                        : deepness[static_cast<std::size_t>(from[3] + (from[7] - from[3]) * aside + 0.5F)];
    }
}

bool is_wet(const mesh::Field& field) {
    return std::ranges::any_of(field.samples, [](float h) { return h < 0; });
}

// A part of the scene that keeps the scene alive.
template <typename Part>
std::shared_ptr<const Part> part_of(const std::shared_ptr<const scene::Scene>& scene, const Part& part) {
    return {scene, &part};
}

const std::initializer_list<gl::Attribute> kPlaceAttributes{
    {0, 2, GL_SHORT, gl::Numbers::AsTheyAre, offsetof(GridPlace, column)},
    {1, 1, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(GridPlace, height_m)},
    {3, 2, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(GridPlace, kinds)}};

void draw_range(const gl::VertexArray& vertices, const gl::StreamBuffer& indices, IndexRange range) {
    vertices.feed_indices(indices.name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(range.count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(range.first * sizeof(std::uint32_t)));
}

}  // namespace

void add_land(gl::Slices& slices, LandOnGpu& land, const std::shared_ptr<const scene::Scene>& scene) {
    const scene::Land& source = *scene->land;
    land.side_m = source.side_m();
    slices.add(0, [&land, scene] {
        const scene::Land& from = *scene->land;
        land.has_water = is_wet(from.height_m) || is_wet(from.surround_m);
    });
    add_blocks(slices, land.land, part_of(scene, source.height_m), source.cell_m, kLandBlock, 0);
    add_places(slices, land.land, part_of(scene, source.height_m), part_of(scene, source.kinds), source.cell_m);
    if (source.surround_m.columns >= 2) {
        // Some of the surround reaches under the land's rim, so that nothing shines through between them.
        const float hole_m = source.side_m() / 2 - source.surround_cell_m;
        add_blocks(slices, land.surround, part_of(scene, source.surround_m), source.surround_cell_m, kSurroundBlock,
                   hole_m);
        add_places(slices, land.surround, part_of(scene, source.surround_m), std::make_shared<mesh::Image>(),
                   source.surround_cell_m);
        add_facings(slices, land.surround, scene->land);
    }
    gl::TextureShape tiled;
    tiled.wrap_s = tiled.wrap_t = gl::Wrap::Repeat;
    tiled.width = source.detail.width;
    tiled.height = source.detail.height;
    tiled.channels = 2;
    const auto grain = gl::add_painting(slices, land.grain, tiled, [scene](mesh::Image& lit, int row) {
        light_grain_row(*scene->land, scene->sky->sun_direction, lit, row);
    });
    gl::TextureShape shape;
    shape.width = source.albedo.width;
    shape.height = source.albedo.height;
    const auto coarse = std::make_shared<std::optional<CoarseRelief>>();
    slices.add(kPieceBytes, [coarse, scene, grain] { coarse->emplace(*scene->land, *grain); });
    gl::add_painting(slices, land.lit, shape, [scene, coarse](mesh::Image& lit, int row) {
        light_row(scene->land->albedo, scene->light.ground, lit, row);
        (*coarse)->add_to(lit, row);
    });
}

GroundPass::GroundPass()
    : near_("near_ground.vert", "near_ground.frag"),
      far_("ground.vert", "ground.frag"),
      vertices_{{0, sizeof(GridPlace), gl::Advance::PerVertex, kPlaceAttributes}} {}

void GroundPass::draw(const LandOnGpu& land, const gl::StreamBuffer& indices, IndexRange range,
                      float grain_m) const {
    if (range.count == 0) return;
    land.lit.bind(0);
    land.grain.bind(1);
    vertices_.bind();
    vertices_.feed(0, land.land.places.name());
    if (range.near_count > 0) {
        near_.use();
        glUniform2f(0, land.land.cell_m, land.land.middle_column);
        glUniform1f(1, 1 / grain_m);
        draw_range(vertices_, indices, {range.first, range.near_count});
    }
    if (range.near_count == range.count) return;
    far_.use();
    glUniform2f(0, land.land.cell_m, land.land.middle_column);
    draw_range(vertices_, indices, {range.first + range.near_count, range.count - range.near_count});
}

SurroundPass::SurroundPass()
    : program_("surround.vert", "lit_ground.frag"),
      vertices_{{0, sizeof(GridPlace), gl::Advance::PerVertex, kPlaceAttributes},
                {1,
                 sizeof(Facing),
                 gl::Advance::PerVertex,
                 {{2, 4, GL_BYTE, gl::Numbers::Normalised, 0},
                  {4, 3, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(Facing, root_colour)}}}} {}

void SurroundPass::draw(const LandOnGpu& land, const gl::StreamBuffer& indices, IndexRange range) const {
    if (range.count == 0) return;
    program_.use();
    glUniform2f(0, land.surround.cell_m, land.surround.middle_column);
    vertices_.bind();
    vertices_.feed(0, land.surround.places.name());
    vertices_.feed(1, land.surround.facings.name());
    draw_range(vertices_, indices, range);
}

void add_stone(gl::Slices& slices, StoneOnGpu& stone, const std::shared_ptr<const scene::Scene>& scene) {
    const std::size_t corners = scene->land->stone.mesh.positions_m.size();
    if (scene->land->stone.mesh.indices.empty()) return;
    const auto ordered = std::make_shared<std::vector<std::uint32_t>>();
    slices.add(0, [&stone, scene, corners, ordered] {
        const mesh::Mesh& from = scene->land->stone.mesh;
        stone.corners = gl::Buffer{GL_ARRAY_BUFFER, corners * sizeof(glm::vec3)};
        stone.facings = gl::Buffer{GL_ARRAY_BUFFER, corners * sizeof(Facing)};
        stone.indices = gl::Buffer{GL_ELEMENT_ARRAY_BUFFER, from.indices.size() * sizeof(std::uint32_t)};
        stone.chunks = Chunks(from, kChunk_m);
        *ordered = stone.chunks.take_indices();
    });
    constexpr std::size_t kPiece = 1U << 13U;
    slices.add_pieces(corners, kPiece, sizeof(glm::vec3) + sizeof(Facing),
                      [&stone, scene](std::size_t first, std::size_t many) {
                          const scene::Stone& from = scene->land->stone;
                          std::vector<Facing> facings;
                          for (std::size_t i = first; i < first + many; ++i) {
                              const auto root = [&](int c) { return unsigned_byte(std::sqrt(from.colours[i][c])); };
                              facings.push_back({packed_normal(from.mesh.normals[i]), {root(0), root(1), root(2), 0}});
                          }
                          stone.corners.write<glm::vec3>(first, std::span(from.mesh.positions_m).subspan(first, many));
                          stone.facings.write<Facing>(first, facings);
                      });
    slices.add_pieces(scene->land->stone.mesh.indices.size(), kPiece, sizeof(std::uint32_t),
                      [&stone, ordered](std::size_t first, std::size_t many) {
                          stone.indices.write<std::uint32_t>(
                              first, std::span<const std::uint32_t>(*ordered).subspan(first, many));
                      });
}

StonePass::StonePass()
    : program_("stone.vert", "lit_ground.frag"),
      vertices_{{0, sizeof(glm::vec3), gl::Advance::PerVertex, {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, 0}}},
                {1,
                 sizeof(Facing),
                 gl::Advance::PerVertex,
                 {{2, 4, GL_BYTE, gl::Numbers::Normalised, 0},
                  {4, 3, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(Facing, root_colour)}}}} {}

std::size_t StonePass::draw(const StoneOnGpu& stone, const Frustum& frustum) const {
    const std::vector<Chunks::Range> seen = stone.chunks.seen(frustum);
    if (seen.empty()) return 0;
    program_.use();
    vertices_.bind();
    vertices_.feed(0, stone.corners.name());
    vertices_.feed(1, stone.facings.name());
    vertices_.feed_indices(stone.indices.name());
    return draw_ranges(seen);
}

}  // namespace quadrat::render::passes
