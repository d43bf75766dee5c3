// SPDX-License-Identifier: Apache-2.0
#include "site/curation.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/owned.hpp"
#include "site/layers.hpp"
#include "site/settings.hpp"

namespace quadrat::site {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kLargest = 1U << 20U;
constexpr const char* kChanges = "desk.changes.json";
constexpr const char* kHead =
    "# What the curator says at the desk, over the site's settings: quadrat desk writes it.\n";
constexpr int kVersion = 1;

toml::table parsed(const std::string& toml) {
    try {
        return toml::parse(toml);
    } catch (const toml::parse_error& error) {
        throw base::InputError(fmt::format("what was said at the desk cannot be read: {}", error.description()));
    }
}

struct Putter {
    toml::table& table;
    const std::string& key;
    void operator()(EmptyTable) const { table.insert_or_assign(key, toml::table{}); }
    void operator()(const std::vector<std::string>& list) const {
        toml::array array;
        for (const std::string& item : list) array.push_back(item);
        table.insert_or_assign(key, std::move(array));
    }
    void operator()(const std::array<double, 2>& ends) const {
        table.insert_or_assign(key, toml::array{ends[0], ends[1]});
    }
    template <typename Plain>
    void operator()(const Plain& value) const {
        table.insert_or_assign(key, value);
    }
};

// Tables that an edit emptied go too; those that were made empty stay.
void take_out(toml::table& table, std::span<const std::string> place) {
    if (place.size() == 1) {
        table.erase(place.front());
        return;
    }
    toml::table* next = table[place.front()].as_table();
    if (next == nullptr || next->empty()) return;
    take_out(*next, place.subspan(1));
    if (next->empty()) table.erase(place.front());
}

void put_in(toml::table& table, std::span<const std::string> place, const CuratedValue& value) {
    if (place.size() == 1) return std::visit(Putter{table, place.front()}, value);
    if (!table.contains(place.front())) table.insert(place.front(), toml::table{});
    toml::table* next = table[place.front()].as_table();
    if (next == nullptr) throw base::InputError(fmt::format("{} is no table", place.front()));
    put_in(*next, place.subspan(1), value);
}

std::int64_t seconds_of(std::chrono::sys_seconds at) { return at.time_since_epoch().count(); }

CuratedChange change_from(const json& one) {
    return {std::chrono::sys_seconds{std::chrono::seconds{one.at("at_s").get<std::int64_t>()}}, one.at("who"),
            one.at("what"), one.at("before")};
}

// One at a time, whoever they are: the desk, the fleet.
base::OwnedDescriptor held(const fs::path& state) {
    const fs::path file = state / "desk.lock";
    base::OwnedDescriptor lock(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    if (!lock || ::flock(lock.get(), LOCK_EX) != 0)
        throw base::InputError(fmt::format("{}: {}", file.string(), std::strerror(errno)));
    return lock;
}

}  // namespace

std::string edited(const std::string& toml, const std::vector<Edit>& edits) {
    toml::table table = parsed(toml);
    for (const Edit& edit : edits) {
        if (edit.value)
            put_in(table, edit.place, *edit.value);
        else
            take_out(table, edit.place);
    }
    if (table.empty()) return "";
    std::ostringstream text;
    text << kHead << toml::toml_formatter(table) << "\n";
    return text.str();
}

std::string Curation::read() const {
    std::error_code error;
    const fs::path file = curated_file(state_);
    return fs::exists(file, error) ? base::read_file(file, kLargest) : "";
}

std::vector<CuratedChange> Curation::changes() const {
    std::error_code error;
    const fs::path file = state_ / kChanges;
    if (!fs::exists(file, error)) return {};
    try {
        std::vector<CuratedChange> changes;
        const json all = json::parse(base::read_file(file, 64 * kLargest));
        if (all.at("version") != kVersion) return {};
        for (const json& one : all.at("changes")) changes.push_back(change_from(one));
        return changes;
    } catch (const std::exception&) {  // the way back is lost, not what holds
        return {};
    }
}

CheckedConfiguration Curation::check_with(const std::string& curated) const {
    std::string below = "# no file of settings is named\n";
    if (!file_.empty()) below = base::read_file(file_, kLargest);
    return check_configuration(laid_over(below, curated, curated_file(state_).string()), file_.string());
}

// The way back first: were the power cut between the two, it leads to what is there, and undo() goes past that.
void Curation::write(const std::string& curated, const std::vector<CuratedChange>& changes) const {
    json all{{"quadrat", "changes"}, {"version", kVersion}, {"changes", json::array()}};
    const std::size_t skipped = changes.size() > kMostChanges ? changes.size() - kMostChanges : 0;
    for (std::size_t i = skipped; i < changes.size(); ++i)
        all["changes"].push_back({{"at_s", seconds_of(changes[i].at)},
                                  {"who", changes[i].who},
                                  {"what", changes[i].what},
                                  {"before", changes[i].before}});
    base::write_file(state_ / kChanges, all.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
    std::error_code error;
    if (!curated.empty()) {
        base::write_file(curated_file(state_), curated);
        // Whatever the service's umask: as the site's settings, anybody here may read it, the doctor too.
        fs::permissions(curated_file(state_), fs::perms{0644}, error);
        return;
    }
    fs::remove(curated_file(state_), error);
    if (error) throw base::InputError(fmt::format("{}: {}", curated_file(state_).string(), error.message()));
    base::flush_folder(state_);
}

bool Curation::change(const std::vector<Edit>& edits, const CuratedChange& by) const {
    const base::OwnedDescriptor lock = held(state_);
    const std::string before = read();
    const std::string after = edited(before, edits);
    if (after == before || (before.empty() && after.empty())) return false;
    if (CheckedConfiguration checked = check_with(after); !checked.is_usable())
        throw SettingsError(std::move(checked.mistakes));
    std::vector<CuratedChange> all = changes();
    all.push_back(by);
    all.back().before = before;
    write(after, all);
    return true;
}

std::optional<CuratedChange> Curation::undo() const {
    const base::OwnedDescriptor lock = held(state_);
    std::vector<CuratedChange> all = changes();
    const std::string now = read();
    while (!all.empty() && all.back().before == now) all.pop_back();
    if (all.empty()) return std::nullopt;
    CuratedChange last = std::move(all.back());
    all.pop_back();
    if (CheckedConfiguration checked = check_with(last.before); !checked.is_usable())
        throw SettingsError(std::move(checked.mistakes));
    write(last.before, all);
    return last;
}

}  // namespace quadrat::site
