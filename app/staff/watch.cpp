// SPDX-License-Identifier: Apache-2.0
#include "staff/watch.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <ctime>
#include <utility>

#include "site/settings.hpp"
#include "staff/landscapes.hpp"

namespace quadrat::staff {

namespace fs = std::filesystem;

Watch::Watch(fs::path configuration_file, std::optional<std::string> held, fs::path runtime, fs::path state)
    : configuration_file_(std::move(configuration_file)),
      runtime_(std::move(runtime)),
      state_(std::move(state)),
      last_time_(state_),
      held_(std::move(held)),
      worked_(held_.value_or("")) {}

Watch::Stamp Watch::stamp_of(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return {};
    return {status.st_ino, static_cast<std::uint64_t>(status.st_size),
            status.st_mtim.tv_sec * std::int64_t{1'000'000'000} + status.st_mtim.tv_nsec};
}

std::optional<Seen::Changed> Watch::changed_settings() {
    const Stamps stamp{configuration_file_.empty() ? Stamp{} : stamp_of(configuration_file_),
                       stamp_of(site::curated_file(state_))};
    const bool is_settled = seen_ == stamp;
    seen_ = stamp;
    if (!is_settled || read_ == stamp) return std::nullopt;
    read_ = stamp;
    std::optional<std::string> holds;
    site::CheckedConfiguration checked = site::check_settings(configuration_file_, state_, &holds);
    if (holds == std::exchange(held_, holds)) return std::nullopt;
    if (auto cut = site::cut_off(holds.value_or(""), worked_, configuration_file_.string()); cut && checked.is_usable())
        checked.mistakes.push_back(std::move(*cut));
    if (checked.is_usable()) worked_ = *holds;
    return Seen::Changed{std::move(checked), std::move(holds).value_or("")};
}

// A folder is another when something was moved into it or out of it.
std::optional<std::vector<std::string>> Watch::changed_guests() {
    const fs::path folder = state_ / kGuests;
    const Stamp stamp = stamp_of(folder);
    if (stamp == std::exchange(guests_seen_, stamp)) return std::nullopt;
    std::vector<std::string> codes;
    for (KeptLandscape& one : landscapes_in(folder)) codes.push_back(std::move(one.code));
    std::ranges::sort(codes);
    if (codes == std::exchange(guests_, codes)) return std::nullopt;
    return codes;
}

Seen Watch::look() {
    Seen seen;
    seen.machine = machine::read_machine();
    zone_.look();
    seen.wall = site::read_wall_clock(last_time_);
    if (seen.wall.is_trusted) last_time_.note(std::time(nullptr));
    seen.free_mb = machine::free_mb(state_);
    std::error_code ignored;
    seen.is_picture_asked = fs::exists(runtime_ / kPictureAsked, ignored);
    seen.is_glance_asked = fs::exists(runtime_ / kGlanceAsked, ignored);
    seen.stands_by = fs::exists(runtime_ / kStandBy, ignored);
    seen.is_restart_asked = fs::remove(runtime_ / kRestartAsked, ignored);
    seen.is_health_asked = fs::exists(runtime_ / kHealthAsked, ignored);
    seen.is_lamp_test_asked = fs::remove(runtime_ / kLampTestAsked, ignored);
    seen.projector = projector::told_in(runtime_, fs::file_time_type::clock::now());
    seen.preview = take_preview_wish(runtime_);
    seen.settings = changed_settings();
    seen.guests = changed_guests();
    return seen;
}

std::string apply(const site::Configuration& changed, site::Configuration& running) {
    std::string later;
    const auto note = [&](const char* key, bool is_same) {
        if (!is_same) later += (later.empty() ? "" : ", ") + std::string(key);
    };
    const auto& now = running;
    note("screen", changed.screen.display == now.screen.display && changed.screen.size == now.screen.size &&
                       changed.screen.connector == now.screen.connector && changed.screen.mode == now.screen.mode &&
                       changed.screen.rotation_deg == now.screen.rotation_deg &&
                       changed.screen.is_mirrored == now.screen.is_mirrored);
    note("screen.power (systemctl restart quadrat-projector)",
         changed.screen.power == now.screen.power &&
             changed.screen.power_password_file == now.screen.power_password_file);
    note("buttons.inputs", changed.inputs == now.inputs);
    note("breeding", changed.breeding.genome == now.breeding.genome &&
                         changed.breeding.breeder == now.breeding.breeder &&
                         changed.breeding.learning_rate == now.breeding.learning_rate &&
                         changed.breeding.mutation == now.breeding.mutation &&
                         changed.breeding.mutation_form == now.breeding.mutation_form);
    note("hours.zone", changed.zone == now.zone);
    note("picture.land_samples", changed.picture.land_samples == now.picture.land_samples);
    note("picture.ground", changed.picture.ground == now.picture.ground);
    note("sound", changed.sound.is_on == now.sound.is_on && changed.sound.speaks == now.sound.speaks &&
                      changed.sound.speech_folder == now.sound.speech_folder &&
                      changed.sound.device == now.sound.device &&
                      changed.sound.private_device == now.sound.private_device);
    note("fleet (systemctl restart quadrat-fleet)", changed.fleet == now.fleet);
    running.visit = changed.visit;
    running.play = changed.play;
    running.sound.level = changed.sound.level;
    running.sound.soundscape = changed.sound.soundscape;
    running.sound.signals = changed.sound.signals;
    running.sound.private_level = changed.sound.private_level;
    running.look = changed.look;
    running.take_home = changed.take_home;
    running.postcard = changed.postcard;
    running.picture.alpha = changed.picture.alpha;
    running.picture.samples = changed.picture.samples;
    running.hours = changed.hours;
    running.closing = changed.closing;
    running.breeding.locked = changed.breeding.locked;
    running.words = changed.words;
    running.texts = changed.texts;
    running.texts_in = changed.texts_in;
    running.themes = changed.themes;
    running.attract = changed.attract;
    return later;
}

}  // namespace quadrat::staff
