// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/vfs.h>

#include <algorithm>
#include <set>

#include "archive/state_file.hpp"
#include "backup/backup.hpp"
#include "backup/manifest.hpp"
#include "backup/staged.hpp"
#include "backup/tar.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "breeding/words/lessons.hpp"
#include "firmware-io/hid/mapping.hpp"

namespace quadrat::backup {
namespace {

namespace fs = std::filesystem;

// What goes to where the settings are.
struct Setting {
    std::string bytes;
    Ownership ownership;
};

struct Unpacked {
    Manifest manifest;
    std::map<std::string, Setting> settings;  // by name: "quadrat.toml", "broker.crt"
    std::vector<std::string> state;           // names of the files that are staged
};

class Restorer {
  public:
    Restorer(const Places& places, const fs::path& backup, const RestoreOptions& options, const Progress& progress)
        : places_(places), backup_(backup), options_(options), progress_(progress), staging_(places.state) {}

    std::vector<std::string> run() {
        require_whole(backup_);
        unpack();
        check_state();
        check_settings();
        if (options_.identity == Identity::OfTheMachine) become_another();
        const std::string before = dated_name(places_.state, "before-restore", places_.now);
        put_settings(before);
        staging_.commit(before);
        return report(before);
    }

  private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw base::InputError(fmt::format("{}: {}; nothing was changed", backup_.string(), what));
    }

    void unpack() {
        TarReader tar(backup_);
        const auto first = tar.next();
        if (!first || first->name != kManifest || !first->is_file) refuse("is not a backup of Quadrat");
        unpacked_.manifest = manifest_from(tar.bytes(kLargest), backup_.string());
        std::set<std::string> seen;
        while (const auto entry = tar.next()) {
            const auto told = unpacked_.manifest.files.find(entry->name);
            if (!entry->is_file || told == unpacked_.manifest.files.end() || told->second != entry->size ||
                !seen.insert(entry->name).second)
                refuse(fmt::format("{} is not what its {} says", entry->name, kManifest));
            take(tar, *entry);
            progress_("unpacking",
                      static_cast<double>(seen.size()) / static_cast<double>(unpacked_.manifest.files.size()));
        }
        for (const auto& [name, bytes] : unpacked_.manifest.files)
            if (!seen.contains(name)) refuse(fmt::format("{} is missing in it", name));
    }

    void take(TarReader& tar, const TarReader::Entry& entry) {
        const std::string name = entry.name.substr(std::min(entry.name.find('/'), entry.name.size() - 1) + 1);
        const auto known = site_files();
        const bool is_known = std::ranges::find(known, name) != known.end();
        if (entry.name.starts_with(kStateFolder) && (is_known || is_of_a_collection(name))) {
            if (!is_known && ++of_a_collection_ > kMostOfACollection)
                refuse("it has more landscapes than this program keeps");
            tar.extract_to(staging_.place(name));
            unpacked_.state.push_back(name);
        } else if (entry.name.starts_with(kSettingsFolder) && !name.empty() && name.find('/') == std::string::npos &&
                   !name.starts_with('.')) {
            unpacked_.settings[name] = {tar.bytes(kLargest), entry.ownership};
        } else {
            refuse(fmt::format("{} is nothing that this program restores", entry.name));
        }
    }

    // What the next start would set aside or leave unused is not put there.
    void check_state() const {
        for (const std::string& name : unpacked_.state) {
            const fs::path file = staging_.place(name);
            if (name == archive::kStateFile) check_state_file(file);
            try {
                if (name.starts_with("words")) breeding::word_lessons_from(base::read_file(file, kLargest), name);
                if (name == "buttons.map") firmware_io::hid::read_mappings(file);
            } catch (const base::InputError& error) {
                refuse(error.what());
            } catch (const std::invalid_argument& error) {
                refuse(error.what());
            }
        }
    }

    void check_state_file(const fs::path& file) const {
        const archive::StateReport found = archive::examine_state_file(file);
        if (found.condition == archive::Condition::Newer)
            refuse(
                fmt::format("{}: a newer program made it: install that one here too, or move the state there with "
                            "\"quadrat state --move-to\" before the backup",
                            found.what));
        if (found.condition != archive::Condition::Whole && found.condition != archive::Condition::Older)
            refuse(fmt::format("{} is damaged: {}", archive::kStateFile, found.what));
    }

    void check_settings() const {
        if (options_.settings == Settings::Leave || unpacked_.settings.empty()) return;
        const auto own = unpacked_.settings.find(fs::path(kSettings).filename().string());
        if (own == unpacked_.settings.end()) refuse("its settings are missing in it");
        std::set<std::string> named{own->first};
        try {
            for (const fs::path& file : files_named_in(site::configuration_from(own->second.bytes, kSettings)))
                named.insert(file.filename().string());
        } catch (const base::InputError& error) {
            refuse(fmt::format("{}; to restore all but the settings: --keep-settings", error.what()));
        }
        for (const auto& [name, setting] : unpacked_.settings)
            if (!named.contains(name)) refuse(fmt::format("{}{} is named by no setting", kSettingsFolder, name));
    }

    void become_another() {
        if (std::ranges::find(unpacked_.state, archive::kStateFile) != unpacked_.state.end())
            archive::forget_machine(staging_.place(archive::kStateFile));
        if (options_.settings == Settings::Leave) return;
        for (auto& [name, setting] : unpacked_.settings)
            if (name == "quadrat.toml") setting.bytes = without_fleet_name(setting.bytes, kSettings);
    }

    fs::path place_of_setting(const std::string& name) const {
        return name == "quadrat.toml" ? places_.settings : fs::absolute(places_.settings).parent_path() / name;
    }

    // Before the state: who finds them changed and nothing said restores once more.
    void put_settings(const std::string& before) {
        if (options_.settings == Settings::Leave || places_.settings.empty()) return;
        std::error_code error;
        for (const auto& [name, setting] : unpacked_.settings) {
            const fs::path place = place_of_setting(name);
            if (fs::exists(place, error)) keep_setting(place, before);
            fs::create_directories(fs::absolute(place).parent_path(), error);
            const mode_t usual = ::umask(077);  // a password is nobody's for a moment
            base::write_file(place, setting.bytes);
            ::umask(usual);
            own_as(place, setting.ownership);
        }
    }

    void keep_setting(const fs::path& place, const std::string& before) const {
        const fs::path folder = places_.state / before / "settings";
        std::error_code error;
        fs::create_directories(folder, error);
        const mode_t usual = ::umask(077);
        base::write_file(folder / place.filename(), base::read_file(place, kLargest));
        ::umask(usual);
    }

    std::vector<std::string> report(const std::string& before) const {
        const Manifest& manifest = unpacked_.manifest;
        std::vector<std::string> lines{fmt::format("{}: made at {} on {} by Quadrat {}", backup_.string(),
                                                   manifest.made_at, manifest.host, manifest.program)};
        for (const std::string& name : unpacked_.state)
            lines.push_back(fmt::format("restored {}", (places_.state / name).string()));
        tell_settings(lines);
        if (options_.identity == Identity::OfTheMachine)
            lines.emplace_back("this machine stays another: visits begin anew, and its own name counts in the fleet");
        std::error_code error;
        if (fs::exists(places_.state / before, error))
            lines.push_back(fmt::format("what was there lies in {}", (places_.state / before).string()));
        return lines;
    }

    void tell_settings(std::vector<std::string>& lines) const {
        if (unpacked_.settings.empty()) return lines.emplace_back("there are no settings in it"), void();
        if (options_.settings == Settings::Leave) return lines.emplace_back("settings stay as they are"), void();
        if (places_.settings.empty())
            return lines.emplace_back("its settings were left out: say where they go with --config"), void();
        for (const auto& [name, setting] : unpacked_.settings)
            lines.push_back(fmt::format("restored {}", place_of_setting(name).string()));
        constexpr long kOverlay = 0x794c7630;
        struct statfs facts {};
        if (::statfs(fs::absolute(places_.settings).parent_path().c_str(), &facts) == 0 && facts.f_type == kOverlay)
            lines.push_back(
                fmt::format("{} lies in memory over a disk that is only read: it is gone with the power "
                            "unless it is put on the disk too",
                            places_.settings.string()));
    }

    const Places& places_;
    const fs::path& backup_;
    const RestoreOptions& options_;
    const Progress& progress_;
    Staging staging_;
    Unpacked unpacked_;
    std::size_t of_a_collection_ = 0;
};

}  // namespace

std::vector<std::string> restore(const Places& places, const fs::path& backup, const RestoreOptions& options,
                                 const Progress& progress) {
    return Restorer(places, backup, options, progress).run();
}

}  // namespace quadrat::backup
