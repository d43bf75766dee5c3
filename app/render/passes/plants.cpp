// SPDX-License-Identifier: Apache-2.0
#include "render/passes/plants.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/vec2.hpp>
#include <set>
#include <span>

#include "render/gl/buffer_upload.hpp"
#include "render/gl/picture_upload.hpp"
#include "render/gl/wires.hpp"
#include "render/passes/packing.hpp"
#include "scene/colour.hpp"
#include "scene/night_eye.hpp"

namespace quadrat::render::passes {
namespace {

constexpr std::size_t kOfMany_percent = 36;  // of its blades: so enlarged, each shows many (shaders/leaves.vert)

// What a blade shows of its picture (shaders/common/leaf.glsl). Both depend on how many times it is enlarged: what
// comes first, and what comes for each time.
struct BladePicture {
    glm::vec2 part, shows;
    glm::vec2 moved;
};
constexpr BladePicture kOfOne{{1, 0}, {3, -1.78F}, {0, 0}};
constexpr BladePicture kOfMany{{0, 0.2F}, {-2.53F, 1.5F}, {37, 11}};

constexpr float kCopyAside = 0.55F;    // of a spray's length, so far may its copy's tip lie from it on each axis
constexpr float kFoliageTiles = 4.2F;  // to a plant's height: a leaf of the picture stands for several

struct WoodPlace {
    glm::vec3 position_m;
    std::uint16_t to_coarser_m[3];  // half floats
    std::uint16_t unused;
    std::uint8_t age;
    std::uint8_t sway;
    std::uint8_t coarser_sway;
    std::uint8_t unused_too;
};
struct WoodSurface {
    PackedNormal normal;
    PackedNormal grain;
    glm::vec2 texcoord;  // tiles of the bark
};
struct LeafPlace {
    glm::vec3 site_m;
    glm::vec3 corner_m;
    std::uint8_t age;
    std::uint8_t sway;
    std::uint16_t rank;
};
struct LeafSurface {
    PackedNormal normal;
    std::uint8_t root_red, root_green, root_blue, shade;
    std::uint8_t across, along;
    std::uint16_t unused;
};

struct MassPlace {
    glm::vec3 position_m;
    std::uint16_t to_coarser_m[3];  // half floats
    std::uint8_t age;
    std::uint8_t sway;
};
struct MassSurface {
    PackedNormal normal;
    std::uint8_t root_red, root_green, root_blue, shade;
};

float entry(const std::vector<float>& values, std::size_t i, float missing) {
    return i < values.size() ? values[i] : missing;
}

void put_halves(const glm::vec3& v, std::uint16_t (&halves)[3]) {
    for (int axis = 0; axis < 3; ++axis) halves[axis] = glm::packHalf1x16(v[axis]);
}

// What the coarsest level becomes is wider: a stem that is no pixel wide would be dots.
WoodPlace place_of(const scene::Wood& wood, std::size_t i, float widening_m) {
    const bool is_coarsest = wood.coarser_m.empty();
    const float sway = entry(wood.sways, i, 0);
    WoodPlace place{wood.mesh.positions_m[i], {}, 0, unsigned_byte(entry(wood.ages, i, 0)), unsigned_byte(sway), 0, 0};
    place.coarser_sway = is_coarsest ? place.sway : unsigned_byte(wood.coarser_sways[i]);
    put_halves(is_coarsest ? widening_m * wood.mesh.normals[i] : wood.coarser_m[i] - place.position_m,
               place.to_coarser_m);
    return place;
}

MassPlace place_of(const scene::CrownMass& mass, std::size_t i) {
    MassPlace place{mass.mesh.positions_m[i], {}, unsigned_byte(mass.ages[i]), unsigned_byte(mass.sways[i])};
    if (!mass.coarser_m.empty()) put_halves(mass.coarser_m[i] - place.position_m, place.to_coarser_m);
    return place;
}

WoodSurface surface_of(const scene::Wood& wood, std::size_t i, float tiles_per_m) {
    WoodSurface surface{packed_normal(wood.mesh.normals[i]), {0, 127, 0, 0}, glm::vec2{0}};
    if (i < wood.grains.size()) {
        surface.grain = packed_normal(glm::vec3(wood.grains[i]));
        surface.grain.w = signed_byte(wood.grains[i].w);
    }
    if (i < wood.mesh.texcoords.size()) surface.texcoord = wood.mesh.texcoords[i] * tiles_per_m;
    return surface;
}

void add_wood(gl::Slices& slices, WoodOnGpu& wood, const std::shared_ptr<const scene::Wood>& source, float tiles_per_m,
              float widening_m) {
    const std::size_t vertices = source->mesh.positions_m.size();
    wood.index_count = source->mesh.indices.size();
    gl::add_made<WoodPlace>(slices, wood.places, GL_ARRAY_BUFFER, vertices,
                            [source, widening_m](std::size_t i) { return place_of(*source, i, widening_m); });
    gl::add_made<WoodSurface>(slices, wood.surfaces, GL_ARRAY_BUFFER, vertices,
                              [source, tiles_per_m](std::size_t i) { return surface_of(*source, i, tiles_per_m); });
    gl::add_elements<std::uint32_t>(slices, wood.indices, GL_ELEMENT_ARRAY_BUFFER, {source, &source->mesh.indices});
}

std::uint8_t root_byte(float linear) { return unsigned_byte(std::sqrt(std::max(linear, 0.0F))); }

LeafSurface surface_of(const scene::Leaves::Vertex& v) {
    return {packed_normal(v.normal), root_byte(v.colour.r),       root_byte(v.colour.g),       root_byte(v.colour.b),
            unsigned_byte(v.shade),  unsigned_byte(v.on_blade.x), unsigned_byte(v.on_blade.y), 0};
}

void add_mass(gl::Slices& slices, MassOnGpu& mass, const std::shared_ptr<const scene::CrownMass>& source) {
    const std::size_t vertices = source->mesh.positions_m.size();
    mass.index_count = source->mesh.indices.size();
    gl::add_made<MassPlace>(slices, mass.places, GL_ARRAY_BUFFER, vertices,
                            [source](std::size_t i) { return place_of(*source, i); });
    gl::add_made<MassSurface>(slices, mass.surfaces, GL_ARRAY_BUFFER, vertices, [source](std::size_t i) {
        const glm::vec3 colour = source->colours[i];
        return MassSurface{packed_normal(source->mesh.normals[i]), root_byte(colour.r), root_byte(colour.g),
                           root_byte(colour.b), unsigned_byte(source->shades[i])};
    });
    gl::add_elements<std::uint32_t>(slices, mass.indices, GL_ELEMENT_ARRAY_BUFFER, {source, &source->mesh.indices});
}

// A blade's vertices follow one another, so the place in the order is the blade's own.
std::uint16_t rank_of(const scene::Leaves& leaves, std::size_t vertex) {
    const std::size_t per_blade =
        std::max<std::size_t>(leaves.vertices.size() / std::max<std::size_t>(leaves.blades, 1), 1);
    const double rank = static_cast<double>(vertex / per_blade) / static_cast<double>(leaves.blades);
    return static_cast<std::uint16_t>(std::clamp(rank, 0.0, 1.0) * 65535.0);
}

std::size_t distinct(const std::vector<std::uint32_t>& indices, std::size_t first_so_many) {
    return std::set<std::uint32_t>(indices.begin(), indices.begin() + static_cast<std::ptrdiff_t>(first_so_many))
        .size();
}

void add_leaves(gl::Slices& slices, SpeciesOnGpu& species, const std::shared_ptr<const scene::Leaves>& source) {
    const std::size_t vertices = source->vertices.size();
    species.blades = source->blades;
    species.indices_per_blade = source->indices_per_blade();
    species.indices_per_plain_blade = source->indices_per_plain_blade();
    if (source->blades == 0) return;
    species.vertices_per_blade = distinct(source->indices, species.indices_per_blade);
    species.vertices_per_plain_blade = distinct(source->plain_indices, species.indices_per_plain_blade);
    gl::add_elements<std::uint32_t>(slices, species.plain_leaf_indices, GL_ELEMENT_ARRAY_BUFFER,
                                    {source, &source->plain_indices});
    gl::add_made<LeafPlace>(slices, species.leaf_places, GL_ARRAY_BUFFER, vertices, [source](std::size_t i) {
        const scene::Leaves::Vertex& v = source->vertices[i];
        return LeafPlace{v.site_m, v.corner_m, unsigned_byte(v.age), unsigned_byte(v.sway), rank_of(*source, i)};
    });
    gl::add_made<LeafSurface>(slices, species.leaf_surfaces, GL_ARRAY_BUFFER, vertices,
                              [source](std::size_t i) { return surface_of(source->vertices[i]); });
    gl::add_elements<std::uint32_t>(slices, species.leaf_indices, GL_ELEMENT_ARRAY_BUFFER, {source, &source->indices});
}

// Of the light on limbs in it, how much its leaves take; and over which share of the height a tenth of them hang.
glm::vec2 crown_of(const scene::Species& species, const choose::PlantKind& kind) {
    constexpr float kTaken = 0.68F;  // of what a crown hides
    std::vector<float> heights_m;
    for (const scene::Leaves::Vertex& v : species.leaves.vertices) heights_m.push_back(v.site_m.y);
    if (heights_m.empty() || kind.are_slivers) return {0, 1};
    const auto tenth = heights_m.begin() + static_cast<std::ptrdiff_t>(heights_m.size() / 10);
    std::ranges::nth_element(heights_m, tenth);
    return {kTaken * kind.opacity, *tenth / std::max(species.height_m, 0.1F)};
}

// What every species without a picture of its own has: neither relief nor spots.
std::shared_ptr<const mesh::Image> plain_picture(int channels) {
    auto plain = std::make_shared<mesh::Image>(1, 1, channels);
    plain->bytes.assign(static_cast<std::size_t>(channels), 128);
    return plain;
}

void add_pictures(gl::Slices& slices, SpeciesOnGpu& species, const std::shared_ptr<const scene::Flora>& source,
                  const scene::Species& from) {
    const auto picture = [&source](const mesh::Image& own, int channels) {
        return own.bytes.empty() ? plain_picture(channels) : std::shared_ptr<const mesh::Image>{source, &own};
    };
    gl::TextureShape shape;
    shape.sampling = gl::Sampling::Sharp;
    gl::add_picture(slices, species.leaf, picture(from.leaf, 1), shape);
    shape.wrap_s = gl::Wrap::Repeat;
    shape.wrap_t = gl::Wrap::Repeat;
    gl::add_picture(slices, species.bark, picture(from.bark, 4), shape);
    gl::add_picture(slices, species.foliage, picture(from.foliage, 1), shape);
}

void add_species(gl::Slices& slices, FloraOnGpu& flora, std::size_t index,
                 const std::shared_ptr<const scene::Flora>& source) {
    const scene::Species& from = source->species[index];
    SpeciesOnGpu& species = flora.species[index];
    species.bark_colour = from.bark_colour;
    species.height_m = from.height_m;
    flora.kinds[index] = choose::plant_kind_of(from);
    species.crown = crown_of(from, flora.kinds[index]);
    species.blade_m = flora.kinds[index].blade_m;
    species.wood.resize(from.wood.size());
    for (std::size_t level = 0; level < from.wood.size(); ++level)
        add_wood(slices, species.wood[level], {source, &from.wood[level]}, 1 / std::max(from.bark_tile_m, 0.01F),
                 choose::kWidening * from.trunk_radius_m);
    species.masses.resize(from.masses.size());
    for (std::size_t level = 0; level < from.masses.size(); ++level)
        add_mass(slices, species.masses[level], {source, &from.masses[level]});
    add_pictures(slices, species, source, from);
    add_leaves(slices, species, {source, &from.leaves});
}

const std::initializer_list<gl::Attribute> kInstanceAttributes{
    {8, 4, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(choose::Instance, root_scale)},
    {9, 4, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(choose::Instance, turn_grown_share)},
    {10, 4, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(choose::Instance, wind_sun_through)},
    {11, 4, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(choose::Instance, air)},
    {12, 4, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(choose::Instance, half_tint_enlarged)},
    {13, 4, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(choose::Instance, becoming)}};

std::size_t halvings(std::size_t all, std::size_t left) {
    std::size_t count = 0;
    while (all / 2 >= left && left > 0) {
        all /= 2;
        ++count;
    }
    return count;
}

gl::Work draw_instances(std::size_t vertices, std::size_t index_count, std::size_t instances) {
    gl::draw_triangles(GL_UNSIGNED_INT, 0, index_count, instances);
    return {1, instances * index_count / 3, instances * vertices};
}

}  // namespace

void add_flora(gl::Slices& slices, FloraOnGpu& flora, const std::shared_ptr<const scene::Flora>& source) {
    flora.species.resize(source->species.size());
    flora.kinds.resize(source->species.size());
    for (std::size_t i = 0; i < source->species.size(); ++i) add_species(slices, flora, i, source);
}

PlantsPass::PlantsPass()
    : wood_("wood.vert", "wood.frag"),
      masses_("crown.vert", "leaves.frag"),
      leaves_("leaves.vert", "leaves.frag"),
      plain_leaves_("leaves.vert", "lit.frag"),
      copied_leaves_("copied_leaves.vert", "leaves.frag"),
      plain_copied_leaves_("copied_leaves.vert", "lit.frag"),
      wood_vertices_{{0,
                      sizeof(WoodPlace),
                      gl::Advance::PerVertex,
                      {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(WoodPlace, position_m)},
                       {1, 3, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(WoodPlace, age)},
                       {5, 3, GL_HALF_FLOAT, gl::Numbers::AsTheyAre, offsetof(WoodPlace, to_coarser_m)}}},
                     {1,
                      sizeof(WoodSurface),
                      gl::Advance::PerVertex,
                      {{2, 4, GL_BYTE, gl::Numbers::Normalised, offsetof(WoodSurface, normal)},
                       {3, 4, GL_BYTE, gl::Numbers::Normalised, offsetof(WoodSurface, grain)},
                       {4, 2, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(WoodSurface, texcoord)}}},
                     {2, sizeof(choose::Instance), gl::Advance::PerInstance, kInstanceAttributes}},
      leaf_vertices_{{0,
                      sizeof(LeafPlace),
                      gl::Advance::PerVertex,
                      {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(LeafPlace, site_m)},
                       {1, 3, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(LeafPlace, corner_m)},
                       {2, 2, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(LeafPlace, age)},
                       {3, 1, GL_UNSIGNED_SHORT, gl::Numbers::Normalised, offsetof(LeafPlace, rank)}}},
                     {1,
                      sizeof(LeafSurface),
                      gl::Advance::PerVertex,
                      {{4, 4, GL_BYTE, gl::Numbers::Normalised, offsetof(LeafSurface, normal)},
                       {5, 4, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(LeafSurface, root_red)},
                       {6, 2, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(LeafSurface, across)}}},
                     {2, sizeof(choose::Instance), gl::Advance::PerInstance, kInstanceAttributes}},
      mass_vertices_{{0,
                      sizeof(MassPlace),
                      gl::Advance::PerVertex,
                      {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(MassPlace, position_m)},
                       {2, 2, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(MassPlace, age)},
                       {3, 3, GL_HALF_FLOAT, gl::Numbers::AsTheyAre, offsetof(MassPlace, to_coarser_m)}}},
                     {1,
                      sizeof(MassSurface),
                      gl::Advance::PerVertex,
                      {{4, 4, GL_BYTE, gl::Numbers::Normalised, offsetof(MassSurface, normal)},
                       {5, 4, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(MassSurface, root_red)}}},
                     {2, sizeof(choose::Instance), gl::Advance::PerInstance, kInstanceAttributes}} {}

gl::Work PlantsPass::draw_mass(const SpeciesOnGpu& species, const choose::Batch& batch, GLuint instances) const {
    const MassOnGpu& mass = species.masses[batch.level];
    glUniform2f(0, species.height_m, kFoliageTiles / species.height_m);
    species.foliage.bind(0);
    mass_vertices_.feed(0, mass.places.name());
    mass_vertices_.feed(1, mass.surfaces.name());
    mass_vertices_.feed(2, instances, batch.first * sizeof(choose::Instance));
    mass_vertices_.feed_indices(mass.indices.name());
    gl::Wires::set_level(batch.level);
    return draw_instances(mass.places.bytes() / sizeof(MassPlace), mass.index_count, batch.count);
}

gl::Work PlantsPass::draw_wood(const SpeciesOnGpu& species, const choose::Batch& batch, GLuint instances,
                               const choose::ViewBlock& view) const {
    const WoodOnGpu& wood = species.wood[batch.level];
    const glm::vec3 bark = 2.0F * scene::seen_by_night(species.bark_colour, view.eye_snow.x);
    glUniform4f(0, bark.r, bark.g, bark.b, 1 / species.height_m);
    glUniform2f(1, species.crown.x, species.crown.y);
    wood_vertices_.feed(0, wood.places.name());
    species.bark.bind(0);
    wood_vertices_.feed(1, wood.surfaces.name());
    wood_vertices_.feed(2, instances, batch.first * sizeof(choose::Instance));
    wood_vertices_.feed_indices(wood.indices.name());
    gl::Wires::set_level(batch.level);
    return draw_instances(wood.places.bytes() / sizeof(WoodPlace), wood.index_count, batch.count);
}

gl::Work PlantsPass::draw_leaves(const SpeciesOnGpu& species, const choose::Batch& batch, GLuint instances) const {
    const bool stands_for_many = batch.blades * 100 < kOfMany_percent * species.blades;
    if (!batch.is_plain) {
        (stands_for_many ? species.foliage : species.leaf).bind(0);
        const BladePicture& shown = stands_for_many ? kOfMany : kOfOne;
        glUniform4f(0, shown.part.x, shown.part.y, shown.shows.x, shown.shows.y);
        glUniform2f(2, shown.moved.x, shown.moved.y);
    }
    if (batch.copy > 0) {
        const auto copy = static_cast<float>(batch.copy);
        glUniform4f(1, 7.3F * copy, 9.1F * copy, 5.7F * copy, kCopyAside * species.blade_m);
    }
    leaf_vertices_.feed(0, species.leaf_places.name());
    leaf_vertices_.feed(1, species.leaf_surfaces.name());
    leaf_vertices_.feed(2, instances, batch.first * sizeof(choose::Instance));
    leaf_vertices_.feed_indices(batch.is_plain ? species.plain_leaf_indices.name() : species.leaf_indices.name());
    const std::size_t per_blade = batch.is_plain ? species.indices_per_plain_blade : species.indices_per_blade;
    gl::Wires::set_level(halvings(species.blades, batch.blades));
    const std::size_t vertices = batch.is_plain ? species.vertices_per_plain_blade : species.vertices_per_blade;
    return draw_instances(batch.blades * vertices, batch.blades * per_blade, batch.count);
}

PlantsPass::Drawn PlantsPass::draw(const FloraOnGpu& flora, const std::vector<choose::Batch>& batches,
                                   const gl::StreamBuffer& instances, const choose::ViewBlock& view) const {
    Drawn drawn;
    // Leaves first: they hide most of the wood, and what is hidden need not be shaded.
    glDisable(GL_CULL_FACE);
    leaf_vertices_.bind();
    struct Leaves {
        const gl::Program* program;
        bool are_plain, are_copied;
    };
    for (const Leaves& leaves : {Leaves{&leaves_, false, false}, Leaves{&copied_leaves_, false, true},
                                 Leaves{&plain_leaves_, true, false}, Leaves{&plain_copied_leaves_, true, true}}) {
        leaves.program->use();
        for (const choose::Batch& batch : batches)
            if (batch.part == choose::Batch::Part::Leaves && batch.is_plain == leaves.are_plain &&
                (batch.copy > 0) == leaves.are_copied)
                drawn.leaves += draw_leaves(flora.species[batch.species], batch, instances.name());
    }
    glEnable(GL_CULL_FACE);
    masses_.use();
    mass_vertices_.bind();
    for (const choose::Batch& batch : batches)
        if (batch.part == choose::Batch::Part::Mass)
            drawn.leaves += draw_mass(flora.species[batch.species], batch, instances.name());
    wood_.use();
    // A low sun's colour is nearly bark's own: all of it on a trunk in the open would be gaudy.
    const glm::vec3 own{view.sunlight};
    const glm::vec3 sun = glm::mix(own, glm::vec3{scene::luminance(own)}, 0.4F);
    glUniform3f(2, sun.r, sun.g, sun.b);
    wood_vertices_.bind();
    for (const choose::Batch& batch : batches)
        if (batch.part == choose::Batch::Part::Wood)
            drawn.wood += draw_wood(flora.species[batch.species], batch, instances.name(), view);
    return drawn;
}

}  // namespace quadrat::render::passes
