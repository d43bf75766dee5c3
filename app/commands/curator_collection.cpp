// SPDX-License-Identifier: Apache-2.0
#include "commands/curator_collection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "base/file.hpp"
#include "commands/curator_entries.hpp"
#include "staff/landscapes.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;
using Codes = std::vector<std::string>;

constexpr std::size_t kMostPicture = 8U << 20U;
constexpr const char* kFavourite = "favourite";
constexpr const char* kHidden = "hidden";

bool holds(const Codes& codes, const std::string& code) { return std::ranges::find(codes, code) != codes.end(); }

// Where a landscape's picture is; nothing where it is nowhere.
std::optional<fs::path> picture_of(const CollectionPlaces& places, const std::string& id) {
    for (const fs::path& folder : {places.chosen, places.lately, places.guests}) {
        std::error_code error;
        if (fs::path file = folder / (id + ".png"); fs::is_regular_file(file, error)) return file;
    }
    return std::nullopt;
}

std::optional<fs::path> postcard_of(const CollectionPlaces& places, const std::string& id) {
    std::error_code error;
    fs::path file = places.lately / (id + staff::kPostcard);
    return fs::is_regular_file(file, error) ? std::optional(std::move(file)) : std::nullopt;
}

struct Offered {
    std::string code;
    std::string from;  // another exhibit; "": it was bred here
};

// Favourites, what was bred lately, what other exhibits share, and what is hidden; each once.
std::vector<Offered> all_of(const CollectionPlaces& places, const site::Configuration& now) {
    std::map<std::string, std::string> from;
    const auto guests = staff::landscapes_in(places.guests);
    for (const auto& kept : {guests, staff::landscapes_in(places.chosen)})
        for (const staff::KeptLandscape& one : kept) from[one.code] = one.from;
    std::vector<Offered> all;
    Codes seen;
    const auto add = [&](const std::string& code) {
        if (holds(seen, code)) return;
        seen.push_back(code);
        all.push_back({code, from[code]});
    };
    std::ranges::for_each(now.attract.favourites, add);
    for (const auto& kept : {staff::landscapes_in(places.lately), guests})
        for (const staff::KeptLandscape& one : kept)
            if (!holds(now.attract.hidden, one.code)) add(one.code);
    std::ranges::for_each(now.attract.hidden, add);
    return all;
}

std::string field_of(const std::string& code) { return "show." + staff::id_of_landscape(code); }

std::string choice_of(const site::Configuration& now, const std::string& code) {
    if (holds(now.attract.favourites, code)) return kFavourite;
    return holds(now.attract.hidden, code) ? kHidden : "";
}

const char* usual_of(const std::string& from, const site::Configuration& now) {
    if (from.empty()) return "collection.usual";
    return now.fleet.takes == "all" ? "collection.shared" : "collection.waits";
}

}  // namespace

desk::Form collection_form(const CollectionPlaces& places, const site::Configuration& now, const desk::Texts& say) {
    desk::Form form;
    form.part = "collection";
    form.hint = say("collection.hint");
    desk::Group group{say("collection.bred"), "", {}};
    int number = 0;
    for (const auto& [code, from] : all_of(places, now)) {
        const std::string count = std::to_string(++number);
        desk::Entry entry{desk::Entry::Kind::Choice, field_of(code),
                          from.empty() ? say("collection.landscape", {count}) : say("collection.guest", {count, from}),
                          choice_of(now, code)};
        entry.options = {{"", say(usual_of(from, now))},
                         {kFavourite, say("collection.favourite")},
                         {kHidden, say("collection.hidden")}};
        const std::string id = staff::id_of_landscape(code);
        if (picture_of(places, id)) entry.picture = fmt::format("/curator/landscape/{}.png", id);
        if (postcard_of(places, id)) {
            entry.download = fmt::format("/curator/postcard/{}.png", id);
            entry.download_label = say("collection.postcard");
        }
        group.entries.push_back(entry);
    }
    if (group.entries.empty()) group.hint = say("collection.none");
    form.groups = {group};
    return form;
}

std::vector<site::Edit> collection_edits(const CollectionPlaces& places, const desk::Fields& fields,
                                         const site::Configuration& now, const site::Configuration& site) {
    Codes favourites, hidden;
    for (const auto& [code, from] : all_of(places, now)) {
        const auto said = fields.find(field_of(code));
        // One that has come since the page was shown stays as it is.
        const std::string choice = said == fields.end() ? choice_of(now, code) : said->second;
        if (choice == kFavourite) favourites.push_back(code);
        if (choice == kHidden) hidden.push_back(code);
        if (choice != kFavourite && choice != kHidden && !choice.empty())
            throw base::InputError(fmt::format("\"{}\" is no choice of a landscape", choice));
    }
    const auto edit = [](const char* key, const Codes& codes, const Codes& of_the_site) {
        return site::Edit{{"attract", key},
                          codes == of_the_site ? std::nullopt : std::optional<site::CuratedValue>(codes)};
    };
    return {edit("favourites", favourites, site.attract.favourites), edit("hidden", hidden, site.attract.hidden)};
}

void keep_chosen(const CollectionPlaces& places, const site::Configuration& now) {
    std::error_code error;
    const auto is_chosen = [&](const std::string& code) { return !choice_of(now, code).empty(); };
    fs::create_directories(places.chosen, error);
    for (const fs::path& folder : {places.lately, places.guests})
        for (const staff::KeptLandscape& one : staff::landscapes_in(folder))
            if (is_chosen(one.code))
                for (const char* kind : {".png", ".code"})
                    fs::copy_file(folder / (one.id + kind), places.chosen / (one.id + kind),
                                  fs::copy_options::skip_existing, error);
    for (const staff::KeptLandscape& one : staff::landscapes_in(places.chosen))
        if (!is_chosen(one.code))
            for (const char* kind : {".png", ".code"}) fs::remove(places.chosen / (one.id + kind), error);
}

namespace {

std::optional<std::string> contents_of(const std::optional<fs::path>& file) {
    if (!file) return std::nullopt;
    try {
        return base::read_file(*file, kMostPicture);
    } catch (const base::InputError&) {
        return std::nullopt;  // it went away meanwhile
    }
}

bool is_id(const std::string& id) {
    const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    return id.size() == 16 && std::ranges::all_of(id, is_digit);
}

}  // namespace

std::optional<std::string> landscape_picture(const CollectionPlaces& places, const std::string& id) {
    return is_id(id) ? contents_of(picture_of(places, id)) : std::nullopt;
}

std::optional<std::string> landscape_postcard(const CollectionPlaces& places, const std::string& id) {
    return is_id(id) ? contents_of(postcard_of(places, id)) : std::nullopt;
}

}  // namespace quadrat::commands
