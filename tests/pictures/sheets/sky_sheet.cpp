// SPDX-License-Identifier: Apache-2.0
// Sheets of skies to look at, and what a thousand random pictures measure:
//     sky_sheet weather FILE.png    24 skies by hour and weather over one land
//     sky_sheet hours FILE.png      one scene at twelve hours
//     sky_sheet genomes FILE.png    48 random genomes; [FIRST_SEED]
//     sky_sheet measure [COUNT]     luminance of as many random genomes, and whether
//                                  their light is of numbers: a line for each that breaks a bound
//     any, then NAME=VALUE …        parameters for all of its pictures
#include <fmt/core.h>

#include <cstdlib>
#include <string>

#include "genome/parameter_rules.hpp"
#include "pictures/picture.hpp"
#include "pictures/weather.hpp"
#include "stage/easel.hpp"
#include "support/exposure.hpp"
#include "support/finite.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::tests;

void add(std::vector<pictures::SheetEntry>& sheet, stage::Easel& easel, genome::Recipe recipe,
         const std::string& caption, int width, int height) {
    for (const genome::Aspect aspect : genome::kAspects) genome::make_consistent(aspect, recipe.values);
    pictures::Picture picture;
    picture.scenes = {recipe};
    picture.width = width;
    picture.height = height;
    picture.seconds = 12;
    sheet.push_back({easel.draw(picture), caption});
}

int weather_sheet(const std::string& file, const Values& extra) {
    constexpr int kWidth = 480;
    stage::Easel easel(kWidth, 270);
    std::vector<pictures::SheetEntry> sheet;
    for (const Hour& weather : weathers())
        for (const Hour& hour : hours()) {
            genome::Recipe recipe = place();
            set_all(recipe, weather.values);
            set_all(recipe, hour.values);
            set_all(recipe, extra);
            add(sheet, easel, recipe, fmt::format("{}, {}", weather.name, hour.name), kWidth, 270);
        }
    pictures::write_image(file, pictures::contact_sheet(sheet, 4, kWidth));
    return 0;
}

int hours_sheet(const std::string& file, const Values& extra) {
    constexpr int kWidth = 480;
    stage::Easel easel(kWidth, 270);
    std::vector<pictures::SheetEntry> sheet;
    // Heights and bearings of the sun over a day in April at 50 degrees north, every two hours.
    struct Position {
        int hour;
        float height_deg, bearing_deg;
    };
    for (const Position& p :
         {Position{0, -29, 0}, Position{2, -24, 31}, Position{4, -10, 58}, Position{6, 7, 82}, Position{8, 26, 107},
          Position{10, 43, 139}, Position{12, 50, 180}, Position{14, 43, -139}, Position{16, 26, -107},
          Position{18, 7, -82}, Position{20, -10, -58}, Position{22, -24, -31}}) {
        genome::Recipe recipe = place();
        if (p.height_deg > 2)
            set_all(recipe, {{"sun.elevation_deg", p.height_deg}});
        else
            set_all(recipe, {{"night.share", std::min((0.5F - p.height_deg) / 14.5F, 1.0F)}});
        set_all(recipe, {{"sun.azimuth_deg", p.bearing_deg}});
        set_all(recipe, extra);
        add(sheet, easel, recipe, fmt::format("{} h", p.hour), kWidth, 270);
    }
    pictures::write_image(file, pictures::contact_sheet(sheet, 3, kWidth));
    return 0;
}

int genomes_sheet(const std::string& file, std::uint64_t first, const Values& extra) {
    constexpr int kWidth = 400;
    stage::Easel easel(kWidth, 225);
    std::vector<pictures::SheetEntry> sheet;
    for (std::uint64_t seed = first; seed < first + 48; ++seed) {
        genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        set_all(recipe, extra);
        add(sheet, easel, recipe, fmt::format("seed:{}", seed), kWidth, 225);
    }
    pictures::write_image(file, pictures::contact_sheet(sheet, 8, kWidth));
    return 0;
}

int measure(std::uint64_t count) {
    stage::Easel easel(320, 180);
    int broken = 0;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        pictures::Picture picture;
        picture.scenes = {genome::random_recipe(base::Seed{seed})};
        picture.width = 320;
        picture.height = 180;
        picture.land_samples = 129;
        const auto scene = nursery::grow(picture.scenes[0], pictures::fineness_of(picture.land_samples));
        const tests::Exposure e = tests::exposure_of(easel.draw(picture, nursery::Scenes{scene}));
        const bool is_night = picture.scenes[0].values[*genome::parameter_named("night.share")] > 0;
        std::string fault = tests::not_finite(*scene->sky, scene->exposure);
        if (fault.empty()) fault = tests::fault_of(e, is_night);
        if (!fault.empty()) fmt::print("seed:{} {}: {}\n", seed, is_night ? "night" : "day", fault);
        if (!fault.empty()) ++broken;
    }
    fmt::print("{} of {} break a bound\n", broken, count);
    return broken == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    Values extra;
    std::vector<std::string> rest;
    for (const std::string& word : words) {
        const auto equals = word.find('=');
        if (equals == std::string::npos)
            rest.push_back(word);
        else
            extra[word.substr(0, equals)] = std::strtof(word.c_str() + equals + 1, nullptr);
    }
    try {
        if (rest.size() >= 1 && rest[0] == "measure")
            return measure(rest.size() > 1 ? std::strtoull(rest[1].c_str(), nullptr, 10) : 1000);
        if (rest.size() >= 2 && rest[0] == "weather") return weather_sheet(rest[1], extra);
        if (rest.size() >= 2 && rest[0] == "hours") return hours_sheet(rest[1], extra);
        if (rest.size() >= 2 && rest[0] == "genomes")
            return genomes_sheet(rest[1], rest.size() > 2 ? std::strtoull(rest[2].c_str(), nullptr, 10) : 1, extra);
    } catch (const std::exception& error) {
        fmt::print(stderr, "sky_sheet: {}\n", error.what());
        return 2;
    }
    fmt::print(stderr,
               "usage: sky_sheet weather|hours|genomes FILE.png [FIRST_SEED] [NAME=VALUE …], or measure [COUNT]\n");
    return 2;
}
