// SPDX-License-Identifier: Apache-2.0
// The room `nursery`: landscapes that grow in the background, until they can be shown. Nothing here speaks to a GPU or
// knows why a landscape is wanted.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "genome/recipe.hpp"
#include "nursery/graph.hpp"

namespace quadrat::nursery {

// One scene, now, on the calling thread's arena.
std::shared_ptr<const scene::Scene> grow(const genome::Recipe& recipe, const scene::Fineness& fineness = {});

struct NurseryOptions {
    int threads = 0;  // that grow; 0: all cores. They run in the background of the frame loop (base/worker.hpp).
    scene::Fineness fineness;
};

// Grows what is wanted in the background, the most urgent first. What is inherited, or was begun as soon as its answer
// was known, is not grown twice (graph.hpp). All calls from one thread; none of them waits, but wait().
class Nursery {
  public:
    explicit Nursery(const NurseryOptions& options = {});
    ~Nursery();  // gives up what has not begun
    Nursery(const Nursery&) = delete;
    Nursery& operator=(const Nursery&) = delete;

    // In place of all that was wanted before, which is forgotten. Where somebody waits for any of it, what is foreseen
    // and not among it will not come.
    void want(std::vector<Want> wants);
    // What may be awaited next, in place of what was foreseen before. It is worked out in the background too, unless
    // something is awaited first.
    void foresee(std::function<std::vector<Want>()> work_out);

    // Of what is wanted: all of them, in the best light that there is; nothing while one is missing.
    std::optional<Graph::AllLit> find(const Landscapes& landscapes) const;
    Prospect ahead() const;  // of what is foreseen, or awaited and not there yet
    float progress() const;  // of what is awaited, 0 to 1

    void wait();  // until all that is wanted is there, in its full light

    // Aspects held for what may be asked next, never more than the four scenes' twice, and aspects still to grow.
    struct Stock {
        std::size_t kept;
        std::size_t to_grow;
        bool is_busy;  // with any of it
    };
    Stock stock() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace quadrat::nursery
