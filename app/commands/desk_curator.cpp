// SPDX-License-Identifier: Apache-2.0
#include "commands/desk_curator.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "base/error.hpp"
#include "commands/curator_collection.hpp"
#include "commands/curator_entries.hpp"
#include "commands/curator_forms.hpp"
#include "commands/preview.hpp"
#include "site/curation.hpp"
#include "site/state_folder.hpp"
#include "staff/landscapes.hpp"

namespace quadrat::commands {
namespace {

using std::chrono::system_clock;

constexpr const char* kCollectionPart = "collection";

[[noreturn]] void refuse(const site::SettingsError& error) { throw base::InputError(in_one_line(error)); }

// What holds, and what would without the curator: as far as it is right.
struct Both {
    site::Configuration now, site;
};
Both both_in(const site::Curation& curation) {
    return {curation.now().configuration, curation.of_the_site().configuration};
}

std::string date_of(std::chrono::sys_seconds at) {
    return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(system_clock::to_time_t(at)));
}

}  // namespace

std::string in_one_line(const site::SettingsError& error) {
    constexpr std::size_t kMost = 3;
    std::string words;
    for (std::size_t i = 0; i < std::min(kMost, error.mistakes().size()); ++i) {
        site::Mistake mistake = error.mistakes()[i];
        mistake.line = 0;
        words += fmt::format("{}{}{}{}", i == 0 ? "" : "; ", mistake.what, mistake.remedy.empty() ? "" : ": ",
                             mistake.remedy);
    }
    return words + ".";
}

desk::Curator curator_of(const DeskPlaces& places) {
    const std::filesystem::path file = site::tended_configuration(places.named_configuration, places.named_state);
    const site::Curation curation(file, places.state);
    desk::Curator curator;
    const CollectionPlaces collection{places.runtime / staff::kBredLately, places.state / staff::kCollection,
                                      places.state / staff::kGuests};
    curator.parts = [] {
        auto parts = curator_parts();
        parts.emplace_back(kCollectionPart);
        return parts;
    };
    curator.landscape = [collection](const std::string& id) { return landscape_picture(collection, id); };
    curator.postcard = [collection](const std::string& id) { return landscape_postcard(collection, id); };
    curator.form = [curation, collection](const std::string& part, const desk::Fields& query,
                                          const desk::Texts& say) -> std::optional<desk::Form> {
        if (part == kCollectionPart) return collection_form(collection, curation.now().configuration, say);
        return curator_form(part, query, say, curation.now().configuration);
    };
    curator.save = [curation, collection](const std::string& part, const desk::Fields& form, desk::Curator::Deed deed,
                                          const std::string& who) {
        const Both both = both_in(curation);
        try {
            const bool is_of_collection = part == kCollectionPart;
            const bool is_other =
                curation.change(is_of_collection ? collection_edits(collection, form, both.now, both.site)
                                                 : curator_edits(part, form, deed, both.now, both.site),
                                {std::chrono::floor<std::chrono::seconds>(system_clock::now()), who, part, ""});
            if (is_of_collection) keep_chosen(collection, curation.now().configuration);
            return is_other;
        } catch (const site::SettingsError& error) {
            refuse(error);
        }
    };
    curator.changes = [curation] {
        std::vector<desk::Change> changes;
        for (const site::CuratedChange& one : curation.changes())
            changes.push_back({date_of(one.at), one.who, one.what});
        std::ranges::reverse(changes);
        return changes;
    };
    curator.undo = [curation](const std::string&) -> std::optional<std::string> {
        try {
            const auto taken_back = curation.undo();
            return taken_back ? std::optional(taken_back->what) : std::nullopt;
        } catch (const site::SettingsError& error) {
            refuse(error);
        }
    };
    curator.ask_preview = [places, curation](const desk::Fields& form, const std::string& entry) {
        const std::string code = spoken_in(form, curation.now().configuration);
        ask_preview(places.runtime,
                    {code, entry.substr(std::min<std::size_t>(entry.find('.') + 1, entry.size())), texts_in(form)});
    };
    curator.preview = [places] { return preview_in(places.runtime); };
    curator.why_preview_waits = [places] { return why_preview_waits(places.runtime); };
    return curator;
}

}  // namespace quadrat::commands
