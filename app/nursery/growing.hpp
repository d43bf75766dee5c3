// SPDX-License-Identifier: Apache-2.0
// The room `nursery`: landscapes that grow in the background, until they can be shown. Nothing here speaks to a GPU or
// knows why a landscape is wanted.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "genome/offer.hpp"
#include "genome/recipe.hpp"
#include "nursery/ahead.hpp"
#include "scene/scene.hpp"

namespace quadrat::nursery {

// One scene, now, on the calling thread's arena.
std::shared_ptr<const scene::Scene> grow(const genome::Recipe& recipe, const scene::Fineness& fineness = {});

struct GrowerOptions {
    int threads = 0;  // that grow; 0: all cores. They run in the background of the frame loop (low_priority.hpp).
    scene::Fineness fineness;
};

// What has grown of scenes to come.
struct Prospect {
    std::vector<scene::Ground> grounds;  // that stand, until their scenes are taken in their own light
    Scenes lit;                          // whole, in first light; of some of them at most four will be taken
};

// Grows in the background. Aspects are kept by what they were grown from, so one that is inherited, or was begun as
// soon as its answer was known, is not grown twice. All calls from one thread; none of them waits, but wait().
class Grower {
  public:
    explicit Grower(const GrowerOptions& options = {});
    ~Grower();  // gives up what has not begun
    Grower(const Grower&) = delete;
    Grower& operator=(const Grower&) = delete;

    // Works for an order that has not been given: what is known of it grows, is laid out once trees and land are known,
    // and once they stand, each of the possible orders gets its skies and first light; whichever of them is given is
    // ready at once. It is worked out beside the caller too, unless an order or another head start comes first.
    void begin(std::function<HeadStart()> work_out);

    Prospect ahead();

    // Whole scenes. Replaces an order that has not been taken. They are ready in a first, coarse light; until then
    // somebody waits.
    void order(Order wanted);

    bool is_ready();               // the order can be taken
    std::optional<Scenes> take();  // once an order; nothing while it is not ready
    float progress();              // of the order, 0 to 1
    // From now on they grow in their own light too: a visitor who waits to see the first has the cores until then.
    void refine();
    // The same scenes in that light, once, unless take() gave them so already.
    std::optional<Scenes> take_refined();
    bool is_refining();  // or has refined what nobody took
    void wait();         // refines; until the order is ready in its own light

    // Aspects held for what may be asked next, never more than the four scenes' twice, and aspects still to grow.
    struct Stock {
        std::size_t kept;
        std::size_t to_grow;
        bool is_busy;  // with any of it
    };
    Stock stock();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace quadrat::nursery
