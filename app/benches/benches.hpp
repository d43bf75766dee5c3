// SPDX-License-Identifier: Apache-2.0
// The room `benches`: `quadrat bench`, what this machine measures of the program. Nobody includes it but commands.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "genome/offer.hpp"
#include "genome/recipe.hpp"
#include "machine/measurement.hpp"

namespace quadrat::benches {

// What was measured, and on what.
struct Results {
    std::vector<machine::Measurement> figures{};
    std::string gpu{};        // that drew; empty where nothing was drawn
    std::string visit_svg{};  // its frames and what the governor did; empty where no visit was played

    void push_back(machine::Measurement figure) { figures.push_back(std::move(figure)); }
};

// What `quadrat bench` was asked for, beyond the group.
struct Options {
    std::string size = "1280x720";
    int frames = 120;
    float alpha = 1;
    double minutes = 2;         // of visits
    double hz = 30;             // of the screen they are played on
    double then_hz = 0;         // and in the last third of them; 0: the same
    bool is_busy = false;       // another process takes a core, and time from uploads, for their middle third
    std::string attended;       // visit: folder where staff look at it from afar, as at an exhibit's; "": nobody does
    std::string profile;        // detail: "pi4", "pi5": what a frame would take there; or empty
    std::size_t triangles = 0;  // of a frame at most; 0: whatever alpha makes of it
    std::size_t pixels = 0;
    std::string ground = "blocks";  // or "roam": what draws the land
};

// One function a group of `quadrat bench`; each appends its figures. A file a group.
void frame(Results& results, const Options& options);
void generation(Results& results);
void trees(Results& results);
void land(Results& results);
void sky(Results& results);
void breeding(Results& results);
void detail(Results& results, const Options& options);
void fidelity(Results& results, const Options& options);
void visit(Results& results, const Options& options);
void start(Results& results, const Options& options);
void worth(Results& results);

// Shared by the groups.
double milliseconds_of(const std::function<void()>& work);
int cores();

// The least of several runs on the clock: what the work needs when nothing else runs.
double least_ms(int runs, const std::function<void()>& work);

// The median over scenes seed:1 to seed:N: one landscape says little about the next.
double median_over_scenes(int scenes, const std::function<void(const genome::Recipe&)>& work);

// The same with 1 and with all threads, as two rows of that name.
void over_threads(Results& results, const std::string& name, const std::function<void(const genome::Recipe&)>& work);

std::vector<genome::Candidate> random_candidates(std::uint64_t seed);

}  // namespace quadrat::benches
