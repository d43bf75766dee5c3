// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/seed.hpp"
#include "mesh/model.hpp"

namespace quadrat::synthesis::houses {

// A façade's grammar as text, a line a statement; # at a line's beginning is a remark:
//     name Alpine farmhouse
//     set storey = 2.6                                   a number, from others, width and height of the façade
//     choose shutter = #9c3b2e 2 | #3f5f45 1             drawn once for the whole house, by weights
//     Facade -> split y 0.6 Plinth, 1r Storeys           absolute sizes in metres; 1r: a share of what is left
//     Storeys -> repeat y storey Storey                  as often as fits best
//     Storey when width > 4 -> repeat x 1.9 Bay snap     where marked splits of that axis are, there divisions too
//     Roofline -> split y mark 1r Upper, 0.3 Eave        its lines are marks
//     Bay -> free Window else Blank                      free: wholly on the façade, away from roof and neighbours
//     Window -> inset 0.4 0.8 0.4 0.3 Pane               left, bottom, right, top
//     Pane when shutter is #9c3b2e -> panel #445566 depth -0.1 with Frame
//     Blank -> nothing
// The first rule of a symbol whose conditions hold is taken; conditions are joined by "and". The axiom is Facade.
// Expressions have + - * / and parentheses; in a rule, width and height are those of the shape at hand. front is 1 on
// the side that has the door, 0 on the others.
class FacadeGrammar {
  public:
    FacadeGrammar();
    ~FacadeGrammar();
    FacadeGrammar(FacadeGrammar&&) noexcept;
    FacadeGrammar& operator=(FacadeGrammar&&) noexcept;

    struct Rules;
    std::unique_ptr<Rules> rules;
    std::string name;
    std::string source;
};

// Throws InputError "SOURCE:LINE:COLUMN: …".
FacadeGrammar read_facade(std::string_view text, std::string_view source);

struct FacadeShape {
    double width_m = 8, height_m = 6;  // to the eaves
    double gable_m = 0;                // above them, in the middle; 0: none
    // Rectangles that neighbours cover, from the façade's lower left corner.
    struct Covered {
        glm::dvec2 low_m, high_m;
    };
    std::vector<Covered> covered;
    bool is_front = true;  // the grammar's attribute front: 1, or 0 on a side that has no door
};

struct FacadePanel {
    glm::dvec2 low_m{0}, high_m{0};
    double depth_m = 0;       // before the wall; behind it below 0
    double depth_from_m = 0;  // of what it stands on
    glm::vec3 colour{0.5F};   // sRGB, 0 to 1
    std::string symbol;       // whose rule made it
};

// From the back to the front. Throws InputError naming the rule's place where it does not end.
std::vector<FacadePanel> derive_facade(const FacadeGrammar& grammar, const FacadeShape& shape, base::Seed seed);

// Front faces and reveals; x to the right, y up, z towards the viewer.
mesh::Model facade_model(const std::vector<FacadePanel>& panels);

struct NamedFacade {
    std::string_view name, text;
};
const std::vector<NamedFacade>& facade_library();

}  // namespace quadrat::synthesis::houses
