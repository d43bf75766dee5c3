// SPDX-License-Identifier: Apache-2.0
#include "commands/fleet_exchange.hpp"

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "base/log.hpp"
#include "site/curation.hpp"
#include "staff/landscapes.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;
using staff::KeptLandscape;

struct Folders {
    fs::path lately, chosen, guests;
};

fs::path picture_of(const Folders& folders, const std::string& id) {
    std::error_code error;
    for (const fs::path& folder : {folders.chosen, folders.lately})
        if (fs::path file = folder / (id + ".png"); fs::exists(file, error)) return file;
    return {};
}

// Bred elsewhere: it is for that exhibit to share, and to take back.
std::set<std::string> foreign_in(const Folders& folders) {
    std::set<std::string> codes;
    for (const KeptLandscape& one : staff::landscapes_in(folders.guests)) codes.insert(one.code);
    for (const KeptLandscape& one : staff::landscapes_in(folders.chosen))
        if (!one.from.empty()) codes.insert(one.code);
    return codes;
}

std::vector<fleet::Sharing::Own> own(const Folders& folders, const site::Configuration& now) {
    std::set<std::string> passed_over = foreign_in(folders);
    passed_over.insert(now.attract.hidden.begin(), now.attract.hidden.end());
    std::vector<fleet::Sharing::Own> all;
    const auto add = [&](const std::string& code) {
        if (!passed_over.insert(code).second) return;
        const std::string id = staff::id_of_landscape(code);
        all.push_back({code, id, picture_of(folders, id)});
    };
    for (const std::string& code : now.attract.favourites) add(code);
    if (now.fleet.shares == "bred")
        for (const KeptLandscape& one : staff::landscapes_in(folders.lately)) add(one.code);
    return all;
}

void take(const Folders& folders, const std::vector<fleet::Guest>& guests) {
    std::error_code error;
    std::set<std::string> stay;
    try {
        const auto here = staff::landscapes_in(folders.guests);
        for (const fleet::Guest& guest : guests) {
            stay.insert(staff::id_of_landscape(guest.code));
            const auto is_it = [&](const KeptLandscape& one) {
                return one.code == guest.code && one.from == guest.from;
            };
            if (std::ranges::none_of(here, is_it)) staff::keep_guest(folders.guests, guest.code, guest.from);
        }
    } catch (const base::InputError& failure) {
        base::log::warn("fleet: what others share is not kept: {}", failure.what());
        return;
    }
    for (fs::directory_iterator file(folders.guests, error), end; !error && file != end; file.increment(error))
        if (!stay.contains(file->path().stem().string())) {
            std::error_code ignored;
            fs::remove(file->path(), ignored);
        }
}

void take_picture(const Folders& folders, const fleet::Guest& guest, const std::string& bytes) {
    try {
        staff::keep_picture_of_guest(folders.guests, guest.code, bytes);
    } catch (const base::InputError& error) {
        base::log::warn("fleet: a landscape that {} shares stays without a picture: {}", guest.from, error.what());
    }
}

}  // namespace

fleet::Sharing sharing_by(const site::Configuration::Fleet& settings, const fs::path& file, const fs::path& state,
                          const fs::path& runtime) {
    const Folders folders{runtime / staff::kBredLately, state / staff::kCollection, state / staff::kGuests};
    fleet::Sharing sharing;
    if (settings.shares != "nothing")
        sharing.own = [folders, curation = site::Curation(file, state), shares = settings.shares] {
            site::Configuration now = curation.now().configuration;
            now.fleet.shares = shares;  // as the whole of [fleet], another is for the next start
            return own(folders, now);
        };
    if (settings.takes == "nothing") {
        take(folders, {});
        return sharing;
    }
    sharing.take = [folders](const std::vector<fleet::Guest>& guests) { take(folders, guests); };
    sharing.take_picture = [folders](const fleet::Guest& guest, const std::string& bytes) {
        take_picture(folders, guest, bytes);
    };
    sharing.has_picture = [folders](const fleet::Guest& guest) {
        std::error_code error;
        return fs::exists(folders.guests / (staff::id_of_landscape(guest.code) + ".png"), error);
    };
    return sharing;
}

}  // namespace quadrat::commands
