// SPDX-License-Identifier: Apache-2.0
// First offers, as the exhibit makes and shows them (with a quarter of its triangles each), numbered and measured:
//     offer_sheet SEED COUNT FILE.png      so many seeds from SEED on, four landscapes each, on one sheet
//     offer_sheet SEED COUNT --measure     a line for each landscape, then their means and worst; no picture is kept
//     offer_sheet SEED COUNT --each DIR    a picture of each, 1280x720: DIR/SEED-A.png …; each draws itself again
//     offer_sheet SEED COUNT --four DIR    all four as a visitor sees them in the midst of a flight: DIR/SEED.png …
//     offer_sheet SEED COUNT --floor DIR   the same at the least that a slow machine may draw
//     any, then NAME=VALUE …               parameters for all of them
#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>

#include "breeding/session.hpp"
#include "pictures/picture.hpp"
#include "pictures/weather.hpp"
#include "scene/camera.hpp"
#include "stage/easel.hpp"
#include "support/values.hpp"
#include "synthesis/compose/view_merit.hpp"
#include "tempo/budget.hpp"
#include "tempo/governor.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::tests;

constexpr float kSeconds = 12;                            // into the flight
constexpr tempo::Budget kOneOfFour{.triangles = 60'000};  // the exhibit draws 240,000

struct Offered {
    std::uint64_t seed;
    char letter;
    genome::Recipe recipe;
    std::string name() const { return fmt::format("{}-{}", seed, letter); }
};

// The first four of the first visit of `quadrat run --seed SEED`.
std::vector<Offered> first_offer(std::uint64_t seed, const Values& extra) {
    breeding::BreederOptions options;
    options.kind = breeding::BreederKind::Belief;
    options.genome = genome::Genome::Full;
    const breeding::Session session(breeding::Breeder(options), base::Seed{seed}.child("visit").child(0U));
    std::vector<Offered> offered;
    for (std::size_t i = 0; i < session.offer().candidates.size(); ++i) {
        genome::Recipe recipe = genome::recipe_of(session.offer().candidates[i], session.flight());
        set_all(recipe, extra);
        offered.push_back({seed, static_cast<char>('A' + i), recipe});
    }
    return offered;
}

pictures::Picture picture_of(const Offered& offered, int width, int height) {
    pictures::Picture picture;
    picture.scenes = {offered.recipe};
    picture.width = width;
    picture.height = height;
    picture.seconds = kSeconds;
    return picture;
}

using WithEach = std::function<void(const Offered&)>;

void for_each_offered(std::uint64_t first, std::uint64_t seeds, const Values& extra, const WithEach& with) {
    for (std::uint64_t seed = first; seed < first + seeds; ++seed)
        for (const Offered& offered : first_offer(seed, extra)) with(offered);
}

int sheet(std::uint64_t first, std::uint64_t seeds, const std::string& file, const Values& extra) {
    constexpr int kWidth = 480;
    stage::Easel easel(kWidth * 2, 540);
    std::vector<pictures::SheetEntry> entries;
    for_each_offered(first, seeds, extra, [&](const Offered& offered) {
        pictures::Picture picture = picture_of(offered, kWidth * 2, 540);
        const mesh::Image drawn = easel.draw(picture, kOneOfFour);
        entries.push_back({pictures::scaled_to(drawn, kWidth), offered.name()});
    });
    pictures::write_image(file, pictures::contact_sheet(entries, 4, kWidth));
    return 0;
}

int each(std::uint64_t first, std::uint64_t seeds, const std::filesystem::path& folder, const Values& extra) {
    std::filesystem::create_directories(folder);
    stage::Easel easel(1280, 720);
    for_each_offered(first, seeds, extra, [&](const Offered& offered) {
        const pictures::Picture picture = picture_of(offered, 1280, 720);
        pictures::write_picture(folder / (offered.name() + ".png"), easel.draw(picture), pictures::to_json(picture));
    });
    return 0;
}

// After so many frames of a flight what is far is held, and the rest is drawn as closely as that leaves triangles for.
mesh::Image in_flight(stage::Easel& easel, pictures::Picture picture, const render::Detail& detail) {
    constexpr int kFrames = 24;
    constexpr float kFrame_s = 1.0F / 60;
    stage::Cast cast;
    for (const genome::Recipe& recipe : picture.scenes) {
        const auto scene = nursery::grow(recipe, pictures::fineness_of(picture.land_samples));
        cast.scenes.push_back({scene, stage::upload_now(easel.renderer(), scene)});
    }
    render::Frame frame;
    for (int n = kFrames - 1; n >= 0; --n) {
        picture.seconds = kSeconds - static_cast<float>(n) * kFrame_s;
        frame = stage::frame_of(picture, cast, easel.display().begin_frame());
        frame.is_one_of_many = true;
        frame.detail = detail;
        easel.renderer().draw(frame);
        if (n > 0) easel.display().present();
    }
    mesh::Image pixels = easel.renderer().read_pixels(frame);
    easel.display().present();
    return pixels;
}

int four(std::uint64_t first, std::uint64_t seeds, const std::filesystem::path& folder, const render::Detail& detail,
         const Values& extra) {
    std::filesystem::create_directories(folder);
    stage::Easel easel(1920, 1080);
    for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
        pictures::Picture picture;
        for (const Offered& offered : first_offer(seed, extra)) picture.scenes.push_back(offered.recipe);
        picture.width = 1920;
        picture.height = 1080;
        picture.seconds = kSeconds;
        pictures::write_picture(folder / fmt::format("{}.png", seed), in_flight(easel, picture, detail),
                                pictures::to_json(picture));
    }
    return 0;
}

// What a first offer may not break: something is lit, nothing is drowned, little is empty.
std::string fault_of(const ValueRange& values, float flat) {
    std::string fault;
    if (values.range() < 0.38F) fault += " range";
    if (values.light < 0.5F) fault += " unlit";
    if (values.mean < 0.2F) fault += " dark";
    if (flat > 0.25F) fault += " flat";
    return fault;
}

int measure(std::uint64_t first, std::uint64_t seeds, const Values& extra) {
    stage::Easel easel(640, 360);
    int broken = 0;
    int count = 0;
    float flat_sum = 0;
    fmt::print("offer    range  p95   mean  flat  sky   water near  far   stony subject\n");
    for_each_offered(first, seeds, extra, [&](const Offered& offered) {
        const pictures::Picture picture = picture_of(offered, 640, 360);
        const auto scene = nursery::grow(offered.recipe, pictures::fineness_of(picture.land_samples));
        const mesh::Image drawn = easel.draw(picture, nursery::Scenes{scene});
        const ValueRange values = values_of(drawn);
        const float flat = flat_share(drawn);
        const Place subject = subject_of(drawn);
        const auto seen = synthesis::outlook(*scene->land, scene::camera_at(scene->track, kSeconds));
        const std::string fault = fault_of(values, flat);
        fmt::print("{:8} {:.2f}   {:.2f}  {:.2f}  {:.2f}  {:.2f}  {:.2f}  {:.2f}  {:.2f}  {:.2f}  {:.2f} {:.2f}{}\n",
                   offered.name(), values.range(), values.light, values.mean, flat, seen.sky, seen.water, seen.near,
                   seen.far, seen.stony, subject.across, subject.down, fault);
        flat_sum += flat;
        ++count;
        if (!fault.empty()) ++broken;
    });
    fmt::print("{} of {} break a bound; {:.1f} % of the lower half is flat in the mean\n", broken, count,
               100 * flat_sum / static_cast<float>(std::max(count, 1)));
    return broken == 0 ? 0 : 1;
}

int usage() {
    fmt::print(stderr,
               "usage: offer_sheet SEED COUNT FILE.png | --measure | --each DIR | --four DIR | --floor DIR, then "
               "NAME=VALUE …\n");
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    Values extra;
    const std::vector<std::string> rest = without_values(argc, argv, extra);
    if (rest.size() < 3) return usage();
    const std::uint64_t first = std::strtoull(rest[0].c_str(), nullptr, 10);
    const std::uint64_t seeds = std::strtoull(rest[1].c_str(), nullptr, 10);
    try {
        if (rest[2] == "--measure") return measure(first, seeds, extra);
        if (rest[2] == "--each") return rest.size() > 3 ? each(first, seeds, rest[3], extra) : usage();
        if (rest[2] == "--four") return rest.size() > 3 ? four(first, seeds, rest[3], {}, extra) : usage();
        constexpr float kFloor = tempo::GovernorOptions::kLeast;
        const render::Detail least{tempo::alpha_for(kFloor), tempo::scale_for(kFloor)};
        if (rest[2] == "--floor") return rest.size() > 3 ? four(first, seeds, rest[3], least, extra) : usage();
        return sheet(first, seeds, rest[2], extra);
    } catch (const std::exception& error) {
        fmt::print(stderr, "offer_sheet: {}\n", error.what());
        return 2;
    }
}
