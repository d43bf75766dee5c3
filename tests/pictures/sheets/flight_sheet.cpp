// SPDX-License-Identifier: Apache-2.0
// A flight with what is far held, beside the same flight drawn anew each frame:
//     flight_sheet SEED SECONDS FILE.png [WIDTHxHEIGHT [HZ [FRAMES [SCALE]]]]
// Flies FRAMES (24) of them at HZ (60) up to SECONDS, four views of seeds SEED to SEED + 3. Writes the last frame:
// held, drawn anew, and their difference eight times as strong, one above the other; prints for each frame the root
// mean square of the difference, that of its worst tile of 16 by 16, triangles of both, and what both took.
#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "display/display.hpp"
#include "nursery/growing.hpp"
#include "pictures/flight.hpp"
#include "pictures/picture.hpp"
#include "stage/easel.hpp"

namespace {

using namespace quadrat;

mesh::Image above_one_another(const mesh::Image& a, const mesh::Image& b) {
    mesh::Image all(a.width, 3 * a.height, a.channels);
    const std::size_t bytes = a.bytes.size();
    for (std::size_t i = 0; i < bytes; ++i) {
        all.bytes[i] = a.bytes[i];
        all.bytes[bytes + i] = b.bytes[i];
        const bool is_alpha = a.channels == 4 && i % 4 == 3;
        const int difference = std::abs(a.bytes[i] - b.bytes[i]);
        all.bytes[2 * bytes + i] = is_alpha ? 255 : static_cast<std::uint8_t>(std::min(8 * difference, 255));
    }
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        fmt::print(stderr, "flight_sheet SEED SECONDS FILE.png [WIDTHxHEIGHT [HZ [FRAMES [SCALE]]]]\n");
        return 2;
    }
    const auto word = [&](int i, const char* otherwise) { return std::string(argc > i ? argv[i] : otherwise); };
    const std::uint64_t seed = std::strtoull(argv[1], nullptr, 10);
    const auto seconds = std::strtof(argv[2], nullptr);
    const display::Size size = display::size_from(word(4, "1280x720"), "size");
    const auto hz = std::strtof(word(5, "60").c_str(), nullptr);
    const int frames = std::atoi(word(6, "24").c_str());
    const auto scale = std::strtof(word(7, "1").c_str(), nullptr);

    std::vector<std::shared_ptr<const scene::Scene>> scenes;
    for (std::uint64_t i = 0; i < 4; ++i) scenes.push_back(nursery::grow(genome::random_recipe(base::Seed{seed + i})));
    stage::Easel easel(size.width, size.height);
    tests::Flight held(easel, scenes, {size.width, size.height}, true);
    tests::Flight anew(easel, scenes, {size.width, size.height}, false);
    held.frame.detail.scale = anew.frame.detail.scale = scale;
    for (int n = 0; n < frames; ++n) {
        const float at = seconds + static_cast<float>(n + 1 - frames) / hz;
        const tests::Flight::Shown a = held.draw(at);
        const tests::Flight::Shown b = anew.draw(at);
        const tests::Off off = tests::off(a.pixels, b.pixels);
        fmt::print("{:3} rms {:.2f} worst tile {:.2f} triangles {} of {} ms {:.1f} of {:.1f}\n", n, off.rms, off.worst,
                   a.drawn.triangles, b.drawn.triangles, a.ms, b.ms);
        if (n + 1 == frames) pictures::write_image(argv[3], above_one_another(a.pixels, b.pixels));
    }
    return 0;
}
