// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "desk/curator.hpp"
#include "site/curation.hpp"

// The curator's choice among what visitors bred.
namespace quadrat::commands {

struct CollectionPlaces {
    std::filesystem::path lately;  // what the exhibit keeps of late, staff::kBredLately
    std::filesystem::path chosen;  // what was chosen, staff::kCollection
    std::filesystem::path guests;  // what other exhibits share, staff::kGuests
};

desk::Form collection_form(const CollectionPlaces& places, const site::Configuration& now, const desk::Texts& say);
std::vector<site::Edit> collection_edits(const CollectionPlaces& places, const desk::Fields& fields,
                                         const site::Configuration& now, const site::Configuration& site);

// Pictures of what is chosen come along into the folder of the chosen, and those of all else go from there. What cannot
// be written is only not seen.
void keep_chosen(const CollectionPlaces& places, const site::Configuration& now);

// PNG of one that is listed: a name is no path.
// A postcard of one that was bred lately.
std::optional<std::string> landscape_postcard(const CollectionPlaces& places, const std::string& id);
std::optional<std::string> landscape_picture(const CollectionPlaces& places, const std::string& id);

}  // namespace quadrat::commands
