// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "base/seed.hpp"
#include "scene/parameters_fwd.hpp"
#include "synthesis/trees/bark.hpp"
#include "synthesis/trees/foliage.hpp"
#include "synthesis/trees/self_organising.hpp"
#include "synthesis/trees/skeleton.hpp"
#include "synthesis/trees/weber_penn.hpp"
#include "synthesis/trees/year.hpp"

namespace quadrat::synthesis::trees {

// Which method grows a kind's limbs. Breeding reaches every one: tests/unit/breeding/reach_test.cpp counts how often.
enum class Grower {
    ByType,     // tree.type's grammar: figure 2.6 a to d of "The Algorithmic Beauty of Plants" (pp. 55 to 57), or the
                // same four made less flat; the broad tree
    WeberPenn,  // a preset of Weber & Penn's "Creation and rendering of realistic trees" (1995); most kinds
    Ternary,    // figure 2.8 b of the same book; the ternary tree
    Colonised,  // space colonisation (Runions et al. 2007); lime and stone pine
    SelfOrganised,  // buds that compete for light (Palubicki et al. 2009); field oak, beech and mountain pine
};

// Mixed into the palette's colour: so much of an sRGB colour, then so much lighter.
struct Tint {
    std::uint32_t srgb = 0;
    float share = 0;
    float lightness = 1;
};

// A kind of tree, as its file in kinds/ tells it; the files' order is that of the parameter tree.habit. What a file
// does not name is as here.
struct Kind {
    const char* name = "";
    Grower grower = Grower::WeberPenn;
    Preset preset = Preset::Broadleaf;  // of WeberPenn
    bool is_umbrella = false;           // of Colonised: a flat crown on a high stem
    SelfOrganisation growth{};          // of SelfOrganised
    float trunk = 0.02F;                // radius at the foot to the height
    float leaf = 1;                     // length of a leaf to the gene's
    float cover = 1;                    // of the crown by leaves
    float spread = 1;                   // of leaves: 0 along their twigs to 1 every way
    float outward = 0.5F;
    float scatter = 0.04F;               // of leaves about their site, to the height
    float height = 1;                    // to the gene's
    bool has_boughs = true;              // false: a stem that no neighbour, no gene of the crown and no root changes
    bool sags = true;                    // its limbs under what they bear
    int most_stems = 4;                  // from one root; a column of two is a pair of horns
    bool keeps_radii = false;            // of the grower instead of the pipe model
    bool is_rosette = false;             // its leaves are one tuft at the top
    std::optional<LeafKind> own_leaf{};  // that the gene cannot change
    float droop = 0;                     // of leaves, besides the gene's
    float blossom = 0.75F;               // share of sites at most; 0: neither blossom nor fruit
    float spring_blossom = 0;            // of its buds, in spring, whatever the gene
    float sheds = 1;                     // of its leaves, in winter: 0 evergreen to 1
    Tint leaf_tint{};
    Tint bark_tint{};
    float lightest_bark = 0.25F;     // its luminance, linear, whatever the genes
    std::optional<Bark> own_bark{};  // that the gene cannot change
    bool is_tender = false;          // frost keeps it away
    float moisture = 0.45F, moisture_width = 0.8F;
    float shore_liking = 0, arid_liking = 0;  // see scene::Species: its zone, where several kinds share a land
    float lowest_m = 0.6F;
    float treeline = 1;                       // to the gene's
    float steepness = 1;                      // to the gene's
    std::array<const char*, 8> companions{};  // kinds that go with it, the closest first
};
int kind_count();
const Kind& kind(int habit);             // 0 to kind_count() - 1
int habit_named(std::string_view kind);  // -1: there is none

// A species' genes, its own and those it shares with the scene's first one.
struct Form {
    int habit = 0;  // its kind
    int type = 4;   // ABOP a to d, then the same made less flat
    float branch_angle_deg = 41.25F;
    float trunk_contraction = 0.88F;
    float branch_contraction = 0.74F;
    float height_m = 13;
    float crown_width = 1;
    float clear_stem = 0;
    float girth = 1;
    float taper = 2.3F;
    int stems = 1;
    float lean_deg = 3;
    float gnarl_deg = 4;
    float divergence_deg = 137.5F;
    float limb_rise = 0.04F;
    float leader = 0;
    float sag = 0.25F;
    float light_seeking = 0.2F;
    float wind_lean = 0.1F;
    float wind_from_deg = 240;
    float limb_density = 1;
    float crowding = 0.15F;
    float shade_bearing = 0.5F;
    float wind_crown = 0.1F;
    float straightening = 0.3F;
    float root_flare = 0.5F;
    float bareness = 0.06F;
    LeafKind leaf = LeafKind::Ovate;
    float leaf_length_m = 0.46F;
    float leaf_density = 1;
    float leaf_width = 1;
    float leaf_fold = 0.35F;
    float leaf_droop = 0.15F;
    float leaf_clumping = 0.4F;
    float leaf_inhibition = 0.6F;
    float blossom = 0;
    float fruit = 0;
    float season = kMidsummer;
    float climbers = 0;  // how far up its trunk, 0 to 1
    float fruit_m = 0.14F;
    int bark_kind = 0;
    float bark_depth = 0.55F;
    float bark_tile_m = 0.8F;
    LeafColours colours;
    glm::vec3 bark{0.2F};
};

enum class Rank { First, Second, Third };
Form form_of(const scene::TreeParameters& parameters, Rank rank);

// Colours of the scene's plants that go together. Linear.
struct Wear {
    glm::vec3 leaf, second, bark, grass, blossom;
};
Wear wear_of(const scene::TreeParameters& parameters);

// A leaf's colour toward yellow or, below 0, toward blue: no bluer than a spruce's, no teal, not garish. Linear.
glm::vec3 yellower(const glm::vec3& leaf, float by);

// White, pink, red, orange, yellow, violet by 0 to 1. Linear.
glm::vec3 blossom_colour(float hue);

// Of mushrooms: white, ochre, gold, red by 0 to 1. Linear.
glm::vec3 cap_colour(float hue);

// Of leaves that have turned, yellow to red by 0 to 1. Linear.
glm::vec3 turned_colour(float red);

// A tree's year: needles stay, whatever bears them.
Year year_of(const Form& form);

// A grown skeleton in metres: root at the origin, no limb under the ground but the roots' ends, which reach into it by
// less than the trunk's radius.
TreeSkeleton grow_skeleton(const Form& form, base::Seed seed);

// The same of a tree that grew among its like: in the middle of a stand, and at its edge, which is open toward +x.
struct StandSkeletons {
    TreeSkeleton middle, edge;
};
StandSkeletons grow_stand_skeletons(const Form& form, base::Seed seed);
bool grows_in_stands(const Form& form);  // whether its grower knows how

}  // namespace quadrat::synthesis::trees
