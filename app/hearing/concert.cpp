// SPDX-License-Identifier: Apache-2.0
#include "hearing/concert.hpp"

#include <array>
#include <utility>

#include "base/log.hpp"

namespace quadrat::hearing {
namespace {

constexpr std::size_t kMostToSay = 12;  // a question, its choices and what came before them

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
      room_(opens(settings.device), soundscape_, room_levels(settings, listened_level_)) {
    if (has_handset(settings))
        handset_ = std::make_unique<sound::Player>(opens(settings.private_device), soundscape_,
                                                   handset_levels(settings, listened_level_));
    speaker_ = std::thread([this] { speak(); });
}

Concert::~Concert() {
    {
        const std::scoped_lock lock(mutex_);
        is_over_ = true;
    }
    has_work_.notify_all();
    speaker_.join();
}

void Concert::tell_all(const sound::Order& order) {
    room_.tell(order);
    if (handset_) handset_->tell(order);
}

void Concert::carry_out(const sound::Sounds& cue) { tell_all(cue); }

void Concert::carry_out(const Says& cue) {
    {
        const std::scoped_lock lock(mutex_);
        to_say_.push_back({++numbered_, cue.utterance});
        // Who is told faster than anybody can speak hears the newest.
        if (to_say_.size() > kMostToSay) to_say_.pop_front();
    }
    has_work_.notify_all();
}

void Concert::carry_out(const Hushes& /*cue*/) {
    {
        const std::scoped_lock lock(mutex_);
        to_say_.clear();
        hushed_before_ = numbered_ + 1;
    }
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

void Concert::speak() {
    sound::Speaker speaker(settings_.speech_folder);
    for (;;) {
        ToSay next;
        {
            std::unique_lock lock(mutex_);
            has_work_.wait(lock, [this] { return is_over_ || !to_say_.empty(); });
            if (is_over_) return;
            next = std::move(to_say_.front());
            to_say_.pop_front();
        }
        auto samples = std::make_shared<const std::vector<float>>(speaker.say(next.utterance));
        bool is_hushed = false;
        {
            const std::scoped_lock lock(mutex_);
            is_hushed = next.number < hushed_before_;
            if (trouble_ != speaker.trouble() && !speaker.trouble().empty())
                base::log::warn("speech: {}", speaker.trouble());
            trouble_ = speaker.trouble();
        }
        if (is_hushed) continue;
        sound::Player& listener = handset_ ? *handset_ : room_;
        listener.say({next.number, std::move(samples)});
    }
}

}  // namespace quadrat::hearing
