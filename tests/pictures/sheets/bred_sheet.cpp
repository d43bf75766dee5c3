// SPDX-License-Identifier: Apache-2.0
// Landscapes that were bred, chosen by what they have:
//     bred_sheet SEED COUNT FILE.png NAME=LOW:HIGH …      so many on one sheet, named VISIT-OFFER-LETTER
//     bred_sheet SEED COUNT --each DIR NAME=LOW:HIGH …    a picture of each, 1920x1080; each draws itself again
//     bred_sheet SEED COUNT --tell NAME=LOW:HIGH …        what rare things each has, and how much of them is seen
// With --with cave|rock|stones|houses|road also those alone that have such a thing, wherever it stands.
// Plays visits from SEED on, each of seven offers in which chance picks, and keeps the first landscape of an offer of
// which every named parameter lies between LOW and HIGH: what a visitor may come to see, with nothing set by hand.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "breeding/session.hpp"
#include "pictures/picture.hpp"
#include "pictures/sheets/in_picture.hpp"
#include "stage/easel.hpp"

namespace {

using namespace quadrat;

constexpr float kSeconds = 12;  // into the flight
constexpr int kOffers = 7;
constexpr std::uint64_t kMostVisits = 400;

struct Wanted {
    genome::ParameterId id;
    float low;
    float high;
};

// What is looked for.
struct Hunt {
    std::vector<Wanted> wanted;
    std::string thing;  // that it has when it is grown; empty: any
};

struct Bred {
    std::string name;
    genome::Recipe recipe;
};

Wanted wanted_of(const std::string& word) {
    const auto equals = word.find('=');
    const auto colon = word.find(':', equals);
    if (equals == std::string::npos || colon == std::string::npos)
        throw std::runtime_error(word + ": say NAME=LOW:HIGH");
    const auto id = genome::parameter_named(word.substr(0, equals));
    if (!id) throw std::runtime_error(word.substr(0, equals) + " is not a parameter");
    return {*id, std::strtof(word.c_str() + equals + 1, nullptr), std::strtof(word.c_str() + colon + 1, nullptr)};
}

bool has_all(const genome::Candidate& candidate, base::Seed flight, const Hunt& hunt) {
    for (const Wanted& w : hunt.wanted)
        if (candidate.values[w.id] < w.low || candidate.values[w.id] > w.high) return false;
    if (hunt.thing.empty()) return true;
    const auto grown = nursery::grow(genome::recipe_of(candidate, flight));
    const auto all = tests::all_in_picture(*grown, kSeconds);
    return std::ranges::any_of(all, [&](const tests::InPicture& one) { return one.what == hunt.thing; });
}

// Of one visit, at most one from each offer.
void play(std::uint64_t visit, std::size_t most, const Hunt& hunt, std::vector<Bred>& found) {
    breeding::BreederOptions options;
    options.kind = breeding::BreederKind::Belief;
    options.genome = genome::Genome::Full;
    breeding::Session session(breeding::Breeder(options), base::Seed{visit}.child("visit").child(0U));
    base::RandomStream chance{base::Seed{visit}.child("reach")};
    for (int offer = 0; offer < kOffers && found.size() < most; ++offer) {
        if (offer > 0) {
            genome::Pick pick;
            for (const genome::Aspect aspect : genome::kAspects) pick[aspect] = chance.below(genome::kCandidates);
            session.next(pick);
        }
        for (std::size_t i = 0; i < genome::kCandidates; ++i) {
            const genome::Candidate& candidate = session.offer().candidates[i];
            if (!has_all(candidate, session.flight(), hunt)) continue;
            found.push_back({fmt::format("{}-{}-{}", visit, offer + 1, static_cast<char>('A' + i)),
                             genome::recipe_of(candidate, session.flight())});
            break;
        }
    }
}

pictures::Picture picture_of(const Bred& bred, int width, int height) {
    pictures::Picture picture;
    picture.scenes = {bred.recipe};
    picture.width = width;
    picture.height = height;
    picture.seconds = kSeconds;
    return picture;
}

void sheet(const std::vector<Bred>& bred, const std::filesystem::path& file) {
    constexpr int kWidth = 640;
    stage::Easel easel(kWidth * 2, kWidth * 9 / 8);
    std::vector<pictures::SheetEntry> entries;
    for (const Bred& b : bred)
        entries.push_back({pictures::scaled_to(easel.draw(picture_of(b, kWidth * 2, kWidth * 9 / 8)), kWidth), b.name});
    pictures::write_image(file, pictures::contact_sheet(entries, 3, kWidth));
}

void each(const std::vector<Bred>& bred, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    stage::Easel easel(1920, 1080);
    for (const Bred& b : bred) {
        const pictures::Picture picture = picture_of(b, 1920, 1080);
        pictures::write_picture(folder / (b.name + ".png"), easel.draw(picture), pictures::to_json(picture));
    }
}

// "cave 0.12 of 78 %": so much of the picture's height, and so much of it hidden by nothing.
void tell(const std::vector<Bred>& bred) {
    for (const Bred& b : bred) {
        fmt::print("{}:", b.name);
        for (const tests::InPicture& one : tests::all_in_picture(*nursery::grow(b.recipe), kSeconds))
            fmt::print("  {} {:.3f} of {:.0f} %", one.what, one.size, 100 * one.open);
        fmt::print("\n");
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> rest;
    Hunt hunt;
    try {
        for (const std::string& word : std::vector<std::string>(argv + 1, argv + argc)) {
            if (!rest.empty() && rest.back() == "--with") {
                rest.pop_back();
                hunt.thing = word;
            } else if (word.find('=') == std::string::npos) {
                rest.push_back(word);
            } else {
                hunt.wanted.push_back(wanted_of(word));
            }
        }
        const bool is_each = rest.size() == 4 && rest[2] == "--each";
        if (!is_each && rest.size() != 3)
            throw std::runtime_error(
                "usage: bred_sheet SEED COUNT FILE.png | --each DIR | --tell, then NAME=LOW:HIGH …");
        const std::uint64_t first = std::strtoull(rest[0].c_str(), nullptr, 10);
        const std::size_t most = std::strtoull(rest[1].c_str(), nullptr, 10);
        std::vector<Bred> bred;
        std::uint64_t visit = first;
        for (; visit < first + kMostVisits && bred.size() < most; ++visit) play(visit, most, hunt, bred);
        fmt::print("{} found in {} offers\n", bred.size(), (visit - first) * kOffers);
        is_each ? each(bred, rest[3]) : rest[2] == "--tell" ? tell(bred) : sheet(bred, rest[2]);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bred_sheet: {}\n", error.what());
        return 2;
    }
    return 0;
}
