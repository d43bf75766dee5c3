// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/foliage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>

#include "scene/colour.hpp"
#include "synthesis/trees/phyllotaxis.hpp"

namespace quadrat::synthesis::trees {
namespace {

glm::vec3 any_direction(base::RandomStream& random) {
    // Archimedes: height and longitude are uniform on a sphere.
    const float y = random.between(-1, 1);
    const float turn = random.between(0, 6.2831853F);
    const float r = std::sqrt(std::max(1 - y * y, 0.0F));
    return {r * std::cos(turn), y, r * std::sin(turn)};
}

struct Crown {
    glm::vec3 middle_m;
    glm::vec3 half_m;
};

Crown crown_of(const TreeSkeleton& skeleton) {
    glm::vec3 low{1.0e6F};
    glm::vec3 high{-1.0e6F};
    for (const Site& site : skeleton.sites) {
        low = glm::min(low, site.at_m);
        high = glm::max(high, site.at_m);
    }
    return {0.5F * (low + high), glm::max(0.5F * (high - low), glm::vec3{0.2F})};
}

// How much light comes down through the blades: each cell's own and those above it and beside that, fading.
class CrownLight {
  public:
    CrownLight(const Crown& crown, std::span<const glm::vec3> sites) : crown_(crown) {
        const float each = 620.0F / static_cast<float>(std::max<std::size_t>(sites.size(), 1));
        for (const glm::vec3& site : sites) cell(index(site)) += each;
        // From the top down: what stands over a cell is its share of what stood over the nine above.
        for (int y = kCells - 2; y >= 0; --y)
            for (int z = 0; z < kCells; ++z)
                for (int x = 0; x < kCells; ++x) over(x, y, z) = gathered(x, y + 1, z);
    }

    float at(const glm::vec3& point) const {
        const auto i = index(point);
        const float depth = 0.5F * density_[flat(i[0], i[1], i[2])] + above_[flat(i[0], i[1], i[2])];
        return 0.24F + 0.76F * std::exp(-0.36F * depth);
    }

  private:
    static constexpr int kCells = 10;
    static std::size_t flat(int x, int y, int z) { return static_cast<std::size_t>((y * kCells + z) * kCells + x); }

    std::array<int, 3> index(const glm::vec3& p) const {
        std::array<int, 3> i{};
        for (int k = 0; k < 3; ++k) {
            const float unit = 0.5F + 0.5F * (p[k] - crown_.middle_m[k]) / crown_.half_m[k];
            i[k] = std::clamp(static_cast<int>(unit * kCells), 0, kCells - 1);
        }
        return i;
    }
    float& cell(const std::array<int, 3>& i) { return density_[flat(i[0], i[1], i[2])]; }
    float& over(int x, int y, int z) { return above_[flat(x, y, z)]; }

    float gathered(int x, int y, int z) const {
        float sum = 0;
        for (int dz = -1; dz <= 1; ++dz) {
            for (int dx = -1; dx <= 1; ++dx) {
                const int cx = std::clamp(x + dx, 0, kCells - 1);
                const int cz = std::clamp(z + dz, 0, kCells - 1);
                const float weight = dx == 0 && dz == 0 ? 0.36F : 0.08F;
                sum += weight * (density_[flat(cx, y, cz)] + above_[flat(cx, y, cz)]);
            }
        }
        return sum;
    }

    Crown crown_;
    std::array<float, kCells * kCells * kCells> density_{};
    std::array<float, kCells * kCells * kCells> above_{};
};

// A crown is lit as the clumps that it falls into, each with a light top and a dark side, not as one ball: leaves that
// are close to one another look away from the middle of them all.
class Clumps {
  public:
    Clumps(const Crown& crown, std::span<const glm::vec3> sites, base::Seed seed)
        : low_m_(crown.middle_m - crown.half_m),
          side_m_(kSide * std::max({crown.half_m.x, crown.half_m.z, 0.2F})),
          tones_(seed) {
        // No two trees fall apart alike.
        base::RandomStream random{seed};
        low_m_ -= side_m_ * glm::vec3{random.unit_f(), random.unit_f(), random.unit_f()};
        for (const glm::vec3& site : sites) {
            Clump& clump = clumps_[key(site)];
            clump.sum_m += site;
            clump.count += 1;
        }
    }

    struct Light {
        glm::vec3 out;  // from the middle of its clump, 1 at about its rim
        float tone;     // how light its leaves are, to the crown's
    };
    Light at(const glm::vec3& site) const {
        const auto& [key, clump] = *clumps_.find(this->key(site));
        const glm::vec3 off = (site - clump.sum_m / clump.count) / (0.5F * side_m_);
        return {off / std::max(glm::length(off), 1.0F),
                1 + kTone * (base::unit_of(base::hash_of(tones_, key, 0)) - 0.5F)};
    }

  private:
    static constexpr float kSide = 0.55F;  // of a clump, to the crown's radius
    static constexpr float kTone = 0.38F;
    struct Clump {
        glm::vec3 sum_m{0};
        float count = 0;
    };
    std::int64_t key(const glm::vec3& at_m) const {
        const glm::ivec3 cell{glm::floor((at_m - low_m_) / side_m_)};
        return (static_cast<std::int64_t>(cell.y) * 64 + cell.z) * 64 + cell.x;
    }
    glm::vec3 low_m_;
    float side_m_;
    base::Seed tones_;
    std::map<std::int64_t, Clump> clumps_;
};

struct Place {
    glm::vec3 at_m;
    const Site* site;
    float sway;
    std::optional<glm::vec3> wood_m = {};  // where its own limb is not drawn: on the nearest that is
};

// Blades spread over the sites by their weights, then shuffled, so that a prefix covers the whole crown.
std::vector<Place> shuffled_places(const TreeSkeleton& skeleton, const FoliageOptions& options, base::Seed seed) {
    std::vector<Place> places;
    places.reserve(options.blades);
    float total = 0;
    for (const Site& site : skeleton.sites) total += site.weight;
    const float each = total / static_cast<float>(options.blades);
    std::size_t at_site = 0;
    float passed = skeleton.sites.front().weight;
    for (std::size_t i = 0; i < options.blades; ++i) {
        base::RandomStream random{base::Seed{base::hash_of(seed, 1, static_cast<std::int64_t>(i))}};
        while (passed < each * (static_cast<float>(i) + 0.5F) && at_site + 1 < skeleton.sites.size())
            passed += skeleton.sites[++at_site].weight;
        // A tuft: the blade moves to the first of its group of neighbours, but none leaves a limb's tip bare.
        const bool gathers = random.unit_f() < 0.5F * options.clumping;
        const bool is_tip =
            at_site + 1 >= skeleton.sites.size() || skeleton.sites[at_site + 1].limb != skeleton.sites[at_site].limb;
        const Site& site = skeleton.sites[gathers && !is_tip ? at_site - at_site % 5 : at_site];
        const glm::vec3 way = any_direction(random);
        const glm::vec3 off = options.scatter_m * (1 - 0.55F * options.clumping) * random.unit_f() * way;
        const bool is_leaf = site.organ != Organ::Flower && site.organ != Organ::Fruit;
        places.push_back(
            {site.at_m + (is_leaf ? 1.0F : 0.5F) * off, &site, skeleton.limbs[site.limb].nodes[site.node].sway});
    }
    base::RandomStream random{seed.child("shuffle")};
    for (std::size_t i = places.size(); i > 1; --i)
        std::swap(places[i - 1], places[random.below(static_cast<std::uint32_t>(i))]);
    return places;
}

// Blades of limbs too thin to be drawn would float: they draw in to those that are.
void bear(std::vector<Place>& places, const mesh::Nearness& wood, float reach_m) {
    constexpr float kSlack = 0.2F;
    constexpr float kDrawn_m = 0.08F;  // from its surface
    std::uint32_t last = 0;
    for (Place& place : places) {
        const mesh::Nearness::Nearest of_site = wood.nearest(place.site->at_m, last, kSlack);
        const mesh::Nearness::Nearest on = wood.nearest(place.at_m, of_site.triangle, kSlack);
        last = on.triangle;
        if (of_site.distance_m > kDrawn_m) place.wood_m = on.at_m;
        if (on.distance_m > reach_m) place.at_m = glm::mix(on.at_m, place.at_m, reach_m / on.distance_m);
    }
}

glm::vec3 across(const glm::vec3& wish, const glm::vec3& along) {
    const glm::vec3 v = wish - glm::dot(wish, along) * along;
    const float length2 = glm::dot(v, v);
    if (length2 > 1.0e-6F) return v / std::sqrt(length2);
    const glm::vec3 other = std::abs(along.y) < 0.9F ? glm::vec3{0, 1, 0} : glm::vec3{1, 0, 0};
    return glm::normalize(glm::cross(along, other));
}

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
    const float length2 = glm::dot(v, v);
    return length2 > 1.0e-8F ? v / std::sqrt(length2) : otherwise;
}

// Colours of a crown, mixed once: a blade picks one.
class Palette {
  public:
    explicit Palette(const LeafColours& c)
        : colours_(c), young_(scene::mix_colours(scene::shifted_colour(c.leaf, 1.22F, 1.1F), kSpring, 0.3F)) {
        for (std::size_t i = 0; i < kSteps; ++i) {
            const float t = static_cast<float>(i) / static_cast<float>(kSteps - 1);
            green_[i] = scene::mix_colours(c.leaf, c.second, t);
            turned_[i] = scene::mix_colours(scene::mix_colours(c.leaf, c.turned, 0.75F),
                                            scene::shifted_colour(c.turned, 1.08F), t);
            // Through a whole crown that turns: some still half green, some gold, some as far as it goes.
            turning_[i] = t < 0.5F
                              ? scene::mix_colours(c.leaf, scene::mix_colours(c.turned, kGold, 0.6F), 0.45F + t)
                              : scene::mix_colours(scene::mix_colours(c.turned, kGold, 0.55F), c.turned, 2 * t - 1);
        }
    }
    glm::vec3 pick(const Site& site, float out, base::RandomStream& random) const {
        const float light = random.between(0.90F, 1.10F);
        const float lean = random.unit_f();
        const float when = random.unit_f();
        if (site.organ == Organ::Flower) return colours_.blossom * light;
        if (site.organ == Organ::Fruit) return colours_.fruit * light;
        if (site.organ == Organ::YoungLeaf) return young_ * light;
        const float varied = 1 + (2.3F + 0.7F * colours_.variety) * (light - 1);
        if (site.organ == Organ::TurnedLeaf) return turning_[step_at(lean)] * varied;
        const bool has_turned = when * (1.25F - 0.35F * std::min(out, 1.0F)) < colours_.autumn;
        const float t = has_turned ? lean : lean * lean * (0.35F + colours_.variety);
        return (has_turned ? turned_ : green_)[step_at(t)] * varied;
    }

  private:
    static constexpr std::size_t kSteps = 12;
    static std::size_t step_at(float t) {
        return static_cast<std::size_t>(std::clamp(t, 0.0F, 1.0F) * static_cast<float>(kSteps - 1) + 0.5F);
    }
    static constexpr glm::vec3 kGold{0.68F, 0.38F, 0.03F};
    static constexpr glm::vec3 kSpring{0.42F, 0.52F, 0.10F};  // the yellow green of leaves that unfold
    const LeafColours& colours_;
    glm::vec3 young_;
    std::array<glm::vec3, kSteps> green_;
    std::array<glm::vec3, kSteps> turned_;
    std::array<glm::vec3, kSteps> turning_;
};

// From a spray back to the limb that it grows on, some of it along that; where that is not drawn, to one that is.
glm::vec3 twig_to(const Place& place, const TreeSkeleton& skeleton, float spray_m) {
    constexpr float kLeast = 0.6F;  // of the spray's length
    constexpr float kMost = 1.5F;
    if (place.wood_m) return *place.wood_m - place.at_m;
    const Limb& limb = skeleton.limbs[static_cast<std::size_t>(place.site->limb)];
    glm::vec3 back_m{0};
    for (int node = place.site->node; node >= 0 && glm::length(back_m) < kLeast * spray_m; --node)
        back_m = limb.nodes[static_cast<std::size_t>(node)].at_m - place.at_m;
    const float length_m = glm::length(back_m);
    return length_m > kMost * spray_m ? back_m * (kMost * spray_m / length_m) : back_m;
}

constexpr float kYoung = 0.6F;  // length of a leaf that unfolds, to a grown one's

BladeShape blade_at(const Place& place, const FoliageOptions& o, const glm::vec3& out_unit,
                    base::RandomStream& random) {
    const LeafShape& shape = spray_shape(o.kind);
    BladeShape blade;
    blade.site_m = place.at_m;
    const glm::vec3 chance = any_direction(random);
    blade.along = unit_or((1.25F - 0.85F * o.spread) * place.site->along + 0.35F * place.site->out +
                              o.outward * out_unit + 0.85F * o.spread * chance + glm::vec3{0, -2.2F * o.droop, 0},
                          place.site->along);
    if (o.is_rosette) {
        // Fronds of a palm: the young stand up in the middle, the old hang.
        const float age = random.unit_f();
        blade.along = unit_or(place.site->out + glm::vec3{0, 1.35F - 1.7F * age, 0} + 0.2F * chance, place.site->along);
        blade.face = across({0, 1, 0}, blade.along);
        blade.length_m = o.length_m * random.between(0.82F, 1.12F);
        blade.half_width_m = 0.5F * o.width * shape.width * blade.length_m;
        blade.fold_m = -0.5F * o.fold * blade.half_width_m;
        blade.bow_m = -(0.30F + 0.5F * o.droop) * blade.length_m;
        return blade;
    }
    // Blades turn their flat side to the light.
    blade.face = across(0.8F * out_unit + glm::vec3{0, 0.8F, 0} + 0.5F * o.spread * any_direction(random), blade.along);
    const Organ organ = place.site->organ;
    blade.length_m = (organ == Organ::YoungLeaf ? kYoung : 1.0F) * o.length_m * random.between(0.78F, 1.18F);
    if (organ == Organ::Flower || organ == Organ::Fruit) {
        blade.is_disc = true;
        blade.is_cluster = organ == Organ::Flower;
        blade.length_m = (organ == Organ::Flower ? o.flower_m : o.fruit_m) * random.between(0.85F, 1.2F);
        blade.half_width_m = 0.5F * blade.length_m;
        blade.fold_m = 0.3F * blade.half_width_m;
        blade.face = unit_or(out_unit + 0.5F * chance + glm::vec3{0, 0.35F, 0}, glm::vec3{0, 1, 0});
        blade.along = across(chance, blade.face);
        return blade;
    }
    blade.half_width_m = 0.5F * o.width * shape.width * blade.length_m;
    blade.fold_m = o.fold * blade.half_width_m;
    blade.bow_m = -shape.arch * blade.length_m;
    return blade;
}

constexpr int kConeScales = 9;
constexpr std::uint64_t kPlacesACone = 4;  // one of so many places of fruit bears a cone: a cone is many blades

// A conifer's fruit: scales by the golden angle around an axis that hangs from the twig.
void add_cone(scene::Leaves& leaves, const Place& place, const FoliageOptions& o, const glm::vec3& out_unit,
              scene::Leaves::Vertex common, base::RandomStream& random) {
    const glm::vec3 axis = unit_or(0.4F * out_unit + 0.25F * any_direction(random) - glm::vec3{0, 1, 0}, {0, -1, 0});
    const glm::vec3 side = across({1, 0, 0}, axis);
    const glm::vec3 third = glm::cross(axis, side);
    const float size_m = o.fruit_m * random.between(0.85F, 1.2F);
    const glm::vec3 colour = common.colour;
    for (int n = 0; n < kConeScales; ++n) {
        glm::vec3 outward;
        const glm::vec3 at = scale_on_cone(n, kConeScales, outward);
        BladeShape scale;
        scale.site_m = place.at_m + 1.7F * size_m * at.y * axis + 0.36F * size_m * (at.x * side + at.z * third);
        scale.face = unit_or(outward.x * side + outward.y * axis + outward.z * third, side);
        scale.along = across(axis, scale.face);
        scale.is_disc = true;
        scale.half_width_m = 0.34F * size_m;
        scale.fold_m = 0.3F * scale.half_width_m;
        common.normal = unit_or(0.7F * scale.face + out_unit, {0, 1, 0});
        common.colour = colour * (0.8F + 0.4F * at.y);
        add_blade(leaves, spray_shape(o.kind), scale, common);
    }
}

// The twig begins at its limb, whatever size its leaves are drawn in; a flower's is as grey as bark.
void root_twig(scene::Leaves& leaves, std::size_t first, const LeafShape& shape, const BladeShape& b) {
    constexpr float kHalf = 0.03F;  // of a flower's twig, to the flower
    constexpr float kBark = 0.2F;
    float aside_m = kHalf * b.half_width_m;
    for (const std::uint32_t foot : shape.twig_foot) {
        scene::Leaves::Vertex& at = leaves.vertices[first + foot];
        at.site_m += (b.is_disc ? aside_m * b.along : at.corner_m) + b.twig_m;
        at.corner_m = glm::vec3{0};
        aside_m = -aside_m;
    }
    if (!b.is_disc) return;
    const std::size_t foot = first + shape.twig_foot.front();
    for (std::size_t v = foot; v < foot + 3; ++v)
        leaves.vertices[v].colour = glm::vec3{kBark * scene::luminance(leaves.vertices[v].colour)};
}

}  // namespace

void add_blade(scene::Leaves& leaves, const LeafShape& shape, const BladeShape& b,
               const scene::Leaves::Vertex& common) {
    const auto first = static_cast<std::uint32_t>(leaves.vertices.size());
    const glm::vec3 side = glm::cross(b.along, b.face);
    const auto count = shape.outline.size();
    for (std::size_t k = 0; k < count; ++k) {
        scene::Leaves::Vertex vertex = common;
        vertex.site_m = b.site_m;
        if (b.is_disc) {
            const glm::vec2 p = b.is_cluster && !shape.cluster.empty() ? shape.cluster[k] : shape.disc[k];
            vertex.on_blade = {0.8F, static_cast<float>(k) / static_cast<float>(count)};
            // Domed: the middle stands out.
            const float up = 1.0F - 0.8F * glm::dot(p, p);
            vertex.corner_m = b.half_width_m * (p.x * b.along + p.y * side) + up * b.fold_m * b.face;
        } else {
            const glm::vec2 p = shape.outline[k];
            const float fold = b.fold_m * 2 * std::abs(p.y);
            vertex.corner_m =
                b.length_m * p.x * b.along + 2 * b.half_width_m * p.y * side + (fold + b.bow_m * p.x * p.x) * b.face;
            if (!shape.lift.empty()) vertex.corner_m += b.length_m * shape.lift[k] * b.face;
            vertex.colour *= shape.lightness[k];
            vertex.on_blade = shape.on_blade[k];
        }
        leaves.vertices.push_back(vertex);
    }
    if (!shape.twig_foot.empty()) root_twig(leaves, first, shape, b);
    for (const std::uint32_t t : shape.triangles) leaves.indices.push_back(first + t);
    for (const std::uint32_t t : shape.plain) leaves.plain_indices.push_back(first + t);
    ++leaves.blades;
}

void set_organs(TreeSkeleton& skeleton, float blossom, float fruit, base::Seed seed) {
    for (std::size_t i = 0; i < skeleton.sites.size(); ++i) {
        const float draw = base::unit_of(base::hash_of(seed, static_cast<std::int64_t>(i), 0));
        Organ& organ = skeleton.sites[i].organ;
        if (draw < blossom)
            organ = Organ::Flower;
        else if (draw < blossom + fruit)
            organ = Organ::Fruit;
    }
}

LeafShape shape_of(const FoliageOptions& o) {
    return o.inhibition > 0 ? spray_shape(o.kind, o.inhibition) : spray_shape(o.kind);
}

scene::Leaves make_foliage(const TreeSkeleton& skeleton, const FoliageOptions& options, base::Seed seed) {
    scene::Leaves leaves;
    if (skeleton.sites.empty() || options.blades == 0) return leaves;
    const Crown crown = crown_of(skeleton);
    std::vector<Place> places = shuffled_places(skeleton, options, seed);
    if (options.wood != nullptr) bear(places, *options.wood, options.reach_m);
    std::vector<glm::vec3> at;
    at.reserve(places.size());
    for (const Place& place : places)
        if (place.site->organ != Organ::None) at.push_back(place.at_m);
    const CrownLight light(crown, at);
    const Clumps clumps(crown, at, seed.child("clumps"));
    const Palette palette(options.colours);
    const LeafShape shape = shape_of(options);
    leaves.are_sprays = !shape.twig_foot.empty();
    leaves.vertices.reserve(shape.outline.size() * places.size());
    leaves.indices.reserve(shape.triangles.size() * places.size());
    leaves.plain_indices.reserve(shape.plain.size() * places.size());
    for (std::size_t i = 0; i < places.size() && leaves.blades < options.blades; ++i) {
        base::RandomStream random{base::Seed{base::hash_of(seed, 2, static_cast<std::int64_t>(i))}};
        const Place& place = places[i];
        if (place.site->organ == Organ::None) continue;
        const glm::vec3 outward = (place.at_m - crown.middle_m) / crown.half_m;
        const float out = std::min(glm::length(outward), 1.2F);
        const glm::vec3 out_unit = unit_or(outward, {0, 1, 0});
        BladeShape blade = blade_at(place, options, out_unit, random);
        if (!options.is_rosette) blade.twig_m = twig_to(place, skeleton, blade.length_m);
        scene::Leaves::Vertex vertex;
        // Mostly the crown's own: leaves that are lit each for itself read as paper, not as a mass.
        const Clumps::Light clump = clumps.at(place.at_m);
        vertex.normal =
            unit_or(0.5F * blade.face + 0.6F * out_unit + 0.8F * clump.out + glm::vec3{0, 0.25F, 0}, {0, 1, 0});
        const float depth = 1.0F - std::min(out, 1.0F);
        vertex.shade = light.at(place.at_m) * (1.0F - 0.55F * depth);
        vertex.colour = clump.tone * palette.pick(*place.site, out, random);
        const float share = std::min(place.site->path_m / std::max(skeleton.longest_path_m, 1.0e-3F), 1.0F);
        vertex.age = std::min(0.12F + 0.83F * share, 1.0F);
        vertex.sway = std::clamp(place.sway, 0.0F, 1.0F);
        if (place.site->organ == Organ::Fruit && options.kind == LeafKind::Needles) {
            if (base::hash_of(seed, 3, static_cast<std::int64_t>(i)) % kPlacesACone == 0 &&
                leaves.blades + kConeScales <= options.blades)
                add_cone(leaves, place, options, out_unit, vertex, random);
            continue;
        }
        add_blade(leaves, shape, blade, vertex);
    }
    return leaves;
}

}  // namespace quadrat::synthesis::trees
