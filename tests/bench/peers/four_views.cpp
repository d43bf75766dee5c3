// SPDX-License-Identifier: Apache-2.0
#include "benches/four_views.hpp"

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/peers/flight.hpp"
#include "bench/peers/peers.hpp"
#include "machine/heap.hpp"

namespace quadrat::peers {
namespace {

double median_frame_ms(benches::FourViews& views, float alpha, int frames) {
    constexpr int kWarmUp = 12;  // in which each view's distance has its turn three times
    views.picture.detail.alpha = alpha;
    std::vector<double> took_ms;
    for (int n = -kWarmUp; n < frames; ++n) {
        const double ms = benches::milliseconds_of([&] {
            views.look(seconds_of_frame(n));
            views.draw();
        });
        if (n >= 0) took_ms.push_back(ms);
    }
    return quantile(took_ms, 0.5);
}

// Not what getrusage() says, which is at least what the parent had.
double peak_mb() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        double kb = 0;
        if (word == "VmHWM:" && status >> kb) return kb / 1024;
    }
    return machine::peak_memory_mb();
}

double on_the_clock_ms(std::chrono::steady_clock::time_point at) {
    return std::chrono::duration<double, std::milli>(at.time_since_epoch()).count();
}

}  // namespace

std::string four_views(const Options& how) {
    machine::hold_memory();  // as quadrat run does
    const auto begun = std::chrono::steady_clock::now();
    benches::Options frames;
    frames.size = how.size;
    benches::FourViews views(frames, kSeedOfFour);
    views.draw();
    const std::chrono::duration<double, std::milli> grown = std::chrono::steady_clock::now() - begun;
    nlohmann::ordered_json json;
    json["first_seen_ms"] = on_the_clock_ms(views.first_seen);
    json["grown_ms"] = grown.count();
    json["frame_alpha_1_ms"] = median_frame_ms(views, 1, frames_of(how));
    json["frame_alpha_02_ms"] = median_frame_ms(views, 0.2F, frames_of(how));
    json["memory_mb"] = peak_mb();
    json["renderer"] = views.easel.display().description();
    return json.dump();
}

}  // namespace quadrat::peers
