// SPDX-License-Identifier: Apache-2.0
#include "hearing/concert.hpp"

#include <array>
#include <utility>

#include "base/log.hpp"

namespace quadrat::hearing {
namespace {

sound::OpenOutput opens(const std::string& device) {
    return [name = device.empty() ? std::string("default") : device](std::string& trouble) {
        return sound::open_alsa(name, trouble);
    };
}

bool has_handset(const site::Configuration::Sound& settings) {
    return settings.speaks && !settings.private_device.empty();
}

// Speech is for one of both alone.
sound::Levels room_levels(const site::Configuration::Sound& settings, double listened) {
    sound::Levels levels;
    levels.all = static_cast<float>(has_handset(settings) ? settings.level : listened);
    levels.soundscape = static_cast<float>(settings.soundscape);
    levels.signals = static_cast<float>(settings.signals);
    levels.speech = has_handset(settings) ? 0.0F : 1.0F;
    return levels;
}

sound::Levels handset_levels(const site::Configuration::Sound& settings, double listened) {
    sound::Levels levels;
    levels.all = static_cast<float>(listened);
    levels.soundscape = static_cast<float>(settings.soundscape);
    return levels;
}

double listened_level_of(const site::Configuration::Sound& settings) {
    return has_handset(settings) ? settings.private_level : settings.level;
}

}  // namespace

Concert::Concert(const site::Configuration::Sound& settings, base::Seed seed)
    : settings_(settings),
      listened_level_(listened_level_of(settings)),
      soundscape_(seed),
      room_(opens(settings.device), soundscape_, room_levels(settings, listened_level_)),
      speaker_(settings.speech_folder) {
    if (has_handset(settings))
        handset_ = std::make_unique<sound::Player>(opens(settings.private_device), soundscape_,
                                                   handset_levels(settings, listened_level_));
}

void Concert::tell_all(const sound::Order& order) {
    room_.tell(order);
    if (handset_) handset_->tell(order);
}

void Concert::carry_out(const sound::Sounds& cue) { tell_all(cue); }

void Concert::carry_out(const Says& cue) {
    speaking_.send([this, number = ++numbered_, utterance = cue.utterance] { say(number, utterance); });
}

void Concert::carry_out(const Hushes& /*cue*/) {
    {
        const std::scoped_lock lock(mutex_);
        hushed_before_ = numbered_ + 1;
    }
    speaking_.drop_waiting();
    tell_all(sound::Hushes{numbered_ + 1});
}

void Concert::play(const std::vector<Cue>& cues) {
    for (const Cue& cue : cues) std::visit([this](const auto& one) { carry_out(one); }, cue);
}

void Concert::surround(const sound::Surroundings& surroundings) { tell_all(sound::Surrounds{surroundings}); }

void Concert::set_levels() {
    room_.tell(sound::SetsLevels{room_levels(settings_, listened_level_)});
    if (handset_) handset_->tell(sound::SetsLevels{handset_levels(settings_, listened_level_)});
}

void Concert::follow(const site::Configuration::Sound& settings) {
    settings_.level = settings.level;
    settings_.soundscape = settings.soundscape;
    settings_.signals = settings.signals;
    settings_.private_level = settings.private_level;
    listened_level_ = listened_level_of(settings_);
    set_levels();
}

void Concert::louder() {
    constexpr std::array kSteps{0.25, 0.5, 0.75, 1.0};
    const double before = std::exchange(listened_level_, kSteps.front());
    for (const double step : kSteps)
        if (step > before + 0.01) {
            listened_level_ = step;
            break;
        }
    set_levels();
}

void Concert::end_visit() {
    if (listened_level_ == listened_level_of(settings_)) return;
    listened_level_ = listened_level_of(settings_);
    set_levels();
}

Health Concert::health() const {
    Health health;
    health.is_wanted = true;
    health.is_playing = true;
    for (const sound::Player* player : {&room_, static_cast<const sound::Player*>(handset_.get())}) {
        if (player == nullptr) continue;
        const sound::PlayerHealth one = player->health();
        health.is_playing = health.is_playing && one.is_playing;
        health.underruns += one.underruns;
        health.dropped += one.dropped;
        if (health.trouble.empty()) health.trouble = one.trouble;
    }
    const std::scoped_lock lock(mutex_);
    if (health.trouble.empty()) health.trouble = trouble_;
    return health;
}

void Concert::say(std::int64_t number, const sound::Utterance& utterance) {
    auto samples = std::make_shared<const std::vector<float>>(speaker_.say(utterance));
    {
        const std::scoped_lock lock(mutex_);
        if (trouble_ != speaker_.trouble() && !speaker_.trouble().empty())
            base::log::warn("speech: {}", speaker_.trouble());
        trouble_ = speaker_.trouble();
        if (number < hushed_before_) return;
    }
    sound::Player& listener = handset_ ? *handset_ : room_;
    listener.say({number, std::move(samples)});
}

}  // namespace quadrat::hearing
