// SPDX-License-Identifier: Apache-2.0
#include "kiosk/staff/watch.hpp"

#include <utility>

#include "base/error.hpp"

namespace quadrat::kiosk::staff {
namespace {

namespace fs = std::filesystem;

fs::file_time_type written_at(const fs::path& file) {
    std::error_code error;
    const auto at = fs::last_write_time(file, error);
    return error ? fs::file_time_type{} : at;
}

}  // namespace

Watch::Watch(fs::path configuration_file, fs::path runtime, fs::path state)
    : configuration_file_(std::move(configuration_file)),
      runtime_(std::move(runtime)),
      state_(std::move(state)),
      last_time_(state_) {
    if (!configuration_file_.empty()) configured_at_ = written_at(configuration_file_);
}

Seen Watch::look() {
    Seen seen;
    seen.machine = read_machine();
    zone_.look();
    seen.wall = read_wall_clock(last_time_);
    if (seen.wall.is_trusted) last_time_.note(std::time(nullptr));
    seen.free_mb = free_mb(state_);
    std::error_code ignored;
    seen.is_picture_asked = fs::exists(runtime_ / kPictureAsked, ignored);
    if (configuration_file_.empty()) return seen;
    const auto at = written_at(configuration_file_);
    if (at == configured_at_ || at == fs::file_time_type{}) return seen;
    configured_at_ = at;
    try {
        seen.configuration = read_configuration(configuration_file_);
    } catch (const base::InputError& error) {
        seen.configuration_trouble = error.what();
    }
    return seen;
}

std::string apply(const Configuration& changed, Configuration& running) {
    std::string later;
    const auto note = [&](const char* key, bool is_same) {
        if (!is_same) later += (later.empty() ? "" : ", ") + std::string(key);
    };
    const auto& now = running;
    note("screen", changed.screen.display == now.screen.display && changed.screen.size == now.screen.size &&
                       changed.screen.connector == now.screen.connector && changed.screen.mode == now.screen.mode &&
                       changed.screen.rotation_deg == now.screen.rotation_deg &&
                       changed.screen.is_mirrored == now.screen.is_mirrored);
    note("buttons.inputs", changed.inputs == now.inputs);
    note("breeding", changed.breeding.genome == now.breeding.genome &&
                         changed.breeding.breeder == now.breeding.breeder &&
                         changed.breeding.learning_rate == now.breeding.learning_rate &&
                         changed.breeding.mutation == now.breeding.mutation &&
                         changed.breeding.mutation_form == now.breeding.mutation_form &&
                         changed.breeding.locked == now.breeding.locked);
    note("words", changed.words == now.words);
    note("picture.land_samples", changed.picture.land_samples == now.picture.land_samples);
    note("picture.ground", changed.picture.ground == now.picture.ground);
    note("fleet (systemctl restart quadrat-fleet)", changed.fleet == now.fleet);
    running.visit = changed.visit;
    running.picture.alpha = changed.picture.alpha;
    running.picture.samples = changed.picture.samples;
    running.hours = changed.hours;
    running.closing = changed.closing;
    running.texts = changed.texts;
    return later;
}

}  // namespace quadrat::kiosk::staff
