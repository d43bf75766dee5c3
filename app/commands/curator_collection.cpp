// SPDX-License-Identifier: Apache-2.0
#include "commands/curator_collection.hpp"

#include <fmt/format.h>

#include <algorithm>

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
    for (const fs::path& folder : {places.chosen, places.lately}) {
        std::error_code error;
        if (fs::path file = folder / (id + ".png"); fs::is_regular_file(file, error)) return file;
    }
    return std::nullopt;
}

// Favourites, what was bred lately, and what is hidden; each once.
Codes all_codes(const CollectionPlaces& places, const site::Configuration& now) {
    Codes all = now.attract.favourites;
    const auto add = [&](const std::string& code) {
        if (!holds(all, code)) all.push_back(code);
    };
    for (const staff::KeptLandscape& one : staff::landscapes_in(places.lately))
        if (!holds(now.attract.hidden, one.code)) add(one.code);
    std::ranges::for_each(now.attract.hidden, add);
    return all;
}

std::string field_of(const std::string& code) { return "show." + staff::id_of_landscape(code); }

std::string choice_of(const site::Configuration& now, const std::string& code) {
    if (holds(now.attract.favourites, code)) return kFavourite;
    return holds(now.attract.hidden, code) ? kHidden : "";
}

}  // namespace

desk::Form collection_form(const CollectionPlaces& places, const site::Configuration& now, const desk::Texts& say) {
    desk::Form form;
    form.part = "collection";
    form.hint = say("collection.hint");
    desk::Group group{say("collection.bred"), "", {}};
    int number = 0;
    for (const std::string& code : all_codes(places, now)) {
        desk::Entry entry{desk::Entry::Kind::Choice, field_of(code),
                          say("collection.landscape", {std::to_string(++number)}), choice_of(now, code)};
        entry.options = {{"", say("collection.usual")},
                         {kFavourite, say("collection.favourite")},
                         {kHidden, say("collection.hidden")}};
        const std::string id = staff::id_of_landscape(code);
        if (picture_of(places, id)) entry.picture = fmt::format("/curator/landscape/{}.png", id);
        group.entries.push_back(entry);
    }
    if (group.entries.empty()) group.hint = say("collection.none");
    form.groups = {group};
    return form;
}

std::vector<site::Edit> collection_edits(const CollectionPlaces& places, const desk::Fields& fields,
                                         const site::Configuration& now, const site::Configuration& site) {
    Codes favourites, hidden;
    for (const std::string& code : all_codes(places, now)) {
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
    for (const staff::KeptLandscape& one : staff::landscapes_in(places.lately))
        if (is_chosen(one.code))
            for (const char* kind : {".png", ".code"})
                fs::copy_file(places.lately / (one.id + kind), places.chosen / (one.id + kind),
                              fs::copy_options::skip_existing, error);
    for (const staff::KeptLandscape& one : staff::landscapes_in(places.chosen))
        if (!is_chosen(one.code))
            for (const char* kind : {".png", ".code"}) fs::remove(places.chosen / (one.id + kind), error);
}

std::optional<std::string> landscape_picture(const CollectionPlaces& places, const std::string& id) {
    const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    if (id.size() != 16 || !std::ranges::all_of(id, is_digit)) return std::nullopt;
    const auto file = picture_of(places, id);
    if (!file) return std::nullopt;
    try {
        return base::read_file(*file, kMostPicture);
    } catch (const base::InputError&) {
        return std::nullopt;  // it went away meanwhile
    }
}

}  // namespace quadrat::commands
