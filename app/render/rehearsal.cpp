// SPDX-License-Identifier: Apache-2.0
#include "render/rehearsal.hpp"

#include <utility>

namespace quadrat::render {
namespace {

constexpr int kSamples = 33;
constexpr float kCell_m = 10;
constexpr int kPicture_px = 8;

mesh::Image grey(int width, int height, int channels) {
    mesh::Image image(width, height, channels);
    image.bytes.assign(image.bytes.size(), 128);
    return image;
}

mesh::Image picture(int channels) { return grey(kPicture_px, kPicture_px, channels); }

mesh::Mesh tetrahedron(float size_m) {
    mesh::Mesh mesh;
    mesh.positions_m = {{-1, 0, 1}, {1, 0, 1}, {0, 0, -1}, {0, 1, 0}};
    for (glm::vec3& p : mesh.positions_m) p *= size_m;
    mesh.normals.assign(mesh.positions_m.size(), {0, 1, 0});
    mesh.texcoords.assign(mesh.positions_m.size(), {0, 0});
    mesh.indices = {0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 2, 1};
    return mesh;
}

scene::Settlement hut() {
    scene::Masses masses;
    masses.mesh = tetrahedron(6);
    masses.mesh.texcoords.assign(4, {0, 0});
    masses.colours.assign(4, glm::vec3{0.3F});
    masses.claddings.assign(4, scene::Cladding::Tiles);
    masses.lamps.assign(4, 0.5F);
    scene::Settlement settlement;
    settlement.buildings.push_back({{masses}, {4, 4}, 6, {{0, 7, 0}}});
    scene::House house;
    house.foot_m = {120, 18, 90};
    house.plume.strength = 1;
    settlement.houses.push_back(house);
    return settlement;
}

// From under the sea in the west to a shore, so ribbed that near and far ground are triangles of their own however they
// are chosen.
scene::Land shore() {
    scene::Land land;
    land.cell_m = kCell_m;
    land.height_m = mesh::Field(kSamples, kSamples);
    for (int row = 0; row < kSamples; ++row)
        for (int column = 0; column < kSamples; ++column)
            land.height_m.at(column, row) = static_cast<float>(column + 2 * (column % 2)) - 8;
    land.surround_m = mesh::Field(9, 9, 5.0F);
    land.albedo = scene::GroundColours(picture(4));
    land.detail = picture(2);
    land.detail_slopes = picture(4);
    land.kinds = grey(kSamples, kSamples, 2);
    land.surround_albedo = grey(9, 9, 4);
    mesh::Mesh& river = land.fresh_water;
    river.positions_m = {{40, 30, -20}, {50, 30, -20}, {40, 30, -30}, {50, 30, -30}};
    river.texcoords.assign(4, {1, 0});
    river.indices = {0, 1, 2, 1, 3, 2};
    land.stone.mesh = tetrahedron(12);
    for (glm::vec3& p : land.stone.mesh.positions_m) p += glm::vec3{30, 15, -30};
    land.stone.mesh.texcoords.clear();
    land.stone.colours.assign(4, glm::vec3{0.3F});
    land.settlement = hut();
    return land;
}

scene::Leaves leaves() {
    constexpr std::size_t kBlades = 200;
    scene::Leaves leaves;
    leaves.blades = kBlades;
    leaves.are_sprays = true;
    for (std::size_t blade = 0; blade < kBlades; ++blade) {
        const auto first = static_cast<std::uint32_t>(leaves.vertices.size());
        const glm::vec3 site_m{0, 4 + 6 * static_cast<float>(blade) / kBlades, 0};
        for (const glm::vec2 corner : {glm::vec2{-1, 0}, glm::vec2{1, 0}, glm::vec2{-1, 1}, glm::vec2{1, 1}})
            leaves.vertices.push_back(
                {site_m, glm::vec3{corner, 0.0F} * 0.4F, {0, 1, 0}, glm::vec3{0.1F}, 1, 1, 1, {0, corner.y}});
        for (const std::uint32_t i : {0U, 1U, 2U, 1U, 3U, 2U}) leaves.indices.push_back(first + i);
        for (const std::uint32_t i : {0U, 1U, 2U}) leaves.plain_indices.push_back(first + i);
    }
    return leaves;
}

scene::Flora tree() {
    scene::Species species;
    species.height_m = 10;
    scene::Wood wood;
    wood.mesh = tetrahedron(3);
    species.wood.push_back(std::move(wood));
    species.leaves = leaves();
    scene::CrownMass mass;
    mass.mesh = tetrahedron(6);
    mass.mesh.texcoords.clear();
    mass.colours.assign(4, glm::vec3{0.1F});
    for (auto* values : {&mass.shades, &mass.ages, &mass.sways}) values->assign(4, 1.0F);
    species.masses.push_back(std::move(mass));
    species.bark = picture(4);
    species.leaf = picture(1);
    species.foliage = picture(1);
    scene::Flora flora;
    flora.species.push_back(std::move(species));
    return flora;
}

scene::Sky rainy_night() {
    scene::Sky sky;
    sky.disc.picture = picture(2);
    sky.stars.push_back({{0, 0.6F, -0.8F}, 1});
    for (scene::CloudLayer& layer : sky.clouds) layer.density = layer.lit = picture(1);
    sky.precipitation.kind = scene::Precipitation::Kind::Rain;
    sky.precipitation.amount = 0.1F;
    sky.bow = 1;
    return sky;
}

}  // namespace

scene::Scene rehearsal_scene() {
    scene::Scene scene;
    scene.land = std::make_shared<scene::Land>(shore());
    scene.flora = std::make_shared<scene::Flora>(tree());
    scene.sky = std::make_shared<scene::Sky>(rainy_night());
    for (float away_m = 4; away_m < 1000; away_m *= 1.4F)
        scene.plants.push_back({0, {160 - 0.3F * away_m, 15, 160 - away_m}});
    scene.light.ground = picture(4);
    scene.sward.tufts.resize(1);
    scene.sward.tufts[0].root_m = {150, 15, 130};
    scene.sward.cells.push_back({{149, 15, 129}, {151, 16, 131}, 0, {1, 0, 0, 0}});
    scene.sward.reach_m = 100;
    return scene;
}

scene::Camera rehearsal_camera() { return {{160, 26, 160}, {120, 18, 40}}; }

}  // namespace quadrat::render
