// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "genome/offer.hpp"
#include "genome/recipe.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace quadrat::kiosk {

using Scenes = std::vector<std::shared_ptr<const scene::Scene>>;

// One scene, now, on the calling thread's arena.
std::shared_ptr<const scene::Scene> grow(const genome::Recipe& recipe, const scene::Fineness& fineness = {});

struct GrowerOptions {
    int threads = 0;  // that grow; 0: all cores. They run at low priority beside the frame loop.
    scene::Fineness fineness;
};

// Grows in the background. Aspects are kept by what they were grown from, so one that is inherited, or was begun as
// soon as its answer was known, is not grown twice. All calls from one thread; none of them waits, but wait().
class Grower {
  public:
    explicit Grower(const GrowerOptions& options = {});
    ~Grower();  // gives up what has not begun
    Grower(const Grower&) = delete;
    Grower& operator=(const Grower&) = delete;

    // A head start: this aspect of the four candidates.
    void begin(genome::Aspect aspect, const genome::Offer& offer);

    // A further one: once their trees and lands have grown, lays the four out for this flight.
    void begin_layouts(const genome::Offer& offer, base::Seed flight);

    // What stands of the scenes to come: the trees and lands that have grown of those last laid out, until they are
    // taken in their own light.
    std::vector<render::Ground> ahead();

    // Whole scenes, composed for one flight. Replaces an order that has not been taken. They are ready in a first,
    // coarse light; it is refined at once.
    void order(std::vector<genome::Candidate> candidates, base::Seed flight);

    bool is_ready();               // the order can be taken
    std::optional<Scenes> take();  // once an order; nothing while it is not ready
    float progress();              // of the order, 0 to 1
    // The same scenes in their own light, once, unless take() gave them so already.
    std::optional<Scenes> take_refined();
    bool is_refining();  // or has refined what nobody took
    void wait();         // until the order is ready in its own light

    // Aspects held for what may be asked next, never more than the four scenes' twice, and aspects still to grow.
    struct Stock {
        std::size_t kept;
        std::size_t to_grow;
        bool is_busy;  // growing or composing
    };
    Stock stock();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace quadrat::kiosk
