// SPDX-License-Identifier: Apache-2.0
#include "hearing/hearing.hpp"

#include <utility>
#include <vector>

#include "base/log.hpp"
#include "scene/parameters.hpp"

namespace quadrat::hearing {
namespace {

constexpr std::array kSignals{"press", "back", "mark", "choice", "round", "finale", "still there"};
constexpr const char* kPlaces[] = {"A", "B", "C", "D", "Back"};

std::string in_words(const sound::Sounds& cue) {
    const std::string signal = kSignals[static_cast<std::size_t>(cue.signal)];
    const bool is_of_a_place = cue.signal <= sound::Signal::Choice && cue.signal != sound::Signal::Back;
    return is_of_a_place ? signal + " " + kPlaces[cue.place] : signal;
}

std::string in_words(const sound::Surroundings& heard) {
    std::string words;
    for (std::size_t i = 0; i < sound::kVoices; ++i)
        if (const auto voice = static_cast<sound::Voice>(i); heard[voice] >= 0.1F)
            words += (words.empty() ? "" : ", ") + std::string(sound::name_of(voice));
    return words.empty() ? "nothing" : words;
}

}  // namespace

Hearing::Hearing(const site::Configuration& configuration, base::Seed seed, Aloud aloud)
    : configuration_(configuration), is_on_(configuration.sound.is_on), aloud_(aloud), narrator_(configuration) {
    if (is_on_ && aloud == Aloud::Played)
        concert_ = std::make_unique<Concert>(configuration.sound, seed.child("sound"));
}

Hearing::Passes Hearing::hear_back(bool is_down, base::Instant now) {
    if (!speaks()) return Passes::AsItIs;
    if (is_down) {
        handset_.press(now);
        return Passes::Nothing;
    }
    if (!handset_.is_held()) return Passes::AsItIs;
    return handset_.release(now) ? Passes::WholePress : Passes::Nothing;
}

void Hearing::carry_out(const std::vector<Cue>& cues) {
    std::vector<Cue> heard;
    for (const Cue& cue : cues) {
        const auto* says = std::get_if<Says>(&cue);
        if (says != nullptr && !speaks()) continue;
        heard.push_back(cue);
        if (aloud_ == Aloud::Played) continue;
        if (says != nullptr)
            base::log::info("says ({}): {}", says->utterance.language, sound::readable(says->utterance.text));
        else if (const auto* sounds = std::get_if<sound::Sounds>(&cue))
            base::log::info("sounds: {}", in_words(*sounds));
    }
    if (concert_) concert_->play(heard);
}

void Hearing::carry_out_wish(const Subject& subject) {
    const auto wish = handset_.look(subject.now);
    if (!wish) return;
    if (*wish == Handset::Wish::Repeat) {
        const bool was_speaking = is_speaking(subject.now);
        return carry_out(was_speaking ? narrator_.hush(subject.now) : narrator_.repeat(subject));
    }
    if (aloud_ == Aloud::Told) base::log::info("sounds: louder");
    if (concert_) concert_->louder();
    carry_out({sound::Sounds{sound::Signal::Choice, 0}});  // as loud as it is now
}

void Hearing::surround(const Subject& subject, std::span<const genome::Recipe> on_show, int act) {
    std::optional<std::size_t> which = narrator_.described(subject.now);
    if (!which && subject.marked && *subject.marked != exhibit::Choice::Back)
        which = static_cast<std::size_t>(*subject.marked);
    if (which && *which >= on_show.size()) which.reset();
    const Shown shown{act, on_show.size(), which};
    if (shown == std::exchange(shown_, shown)) return;
    std::vector<sound::Surroundings> each;
    for (std::size_t i = 0; i < on_show.size(); ++i)
        if (!which || *which == i) each.push_back(sound::surroundings_of(scene::realise(on_show[i].values)));
    const sound::Surroundings heard = sound::blend(each);
    if (aloud_ == Aloud::Told) base::log::info("surrounds: {}", in_words(heard));
    if (concert_) concert_->surround(heard);
}

void Hearing::look(const Subject& subject, std::span<const genome::Recipe> on_show, int act) {
    if (!is_on_) return;
    carry_out_wish(subject);
    carry_out(narrator_.look(subject));
    surround(subject, on_show, act);
    const bool has_ended = subject.visit.screen == exhibit::Screen::Attract && screen_ != exhibit::Screen::Attract;
    screen_ = subject.visit.screen;
    if (has_ended && concert_) concert_->end_visit();
}

void Hearing::be_silent(base::Instant now) {
    if (!is_on_) return;
    handset_.let_go();
    carry_out(narrator_.hush(now));
    if (std::exchange(shown_, Shown{}) == Shown{}) return;
    if (aloud_ == Aloud::Told) base::log::info("surrounds: nothing");
    if (concert_) concert_->surround({});
}

void Hearing::follow() {
    if (concert_) concert_->follow(configuration_.sound);
}

bool Hearing::has_spoken(base::Instant now) {
    const bool is_speaking_now = is_speaking(now);
    return std::exchange(was_speaking_, is_speaking_now) || is_speaking_now;
}

std::optional<base::Instant> Hearing::next_deadline(base::Instant now) const {
    if (!is_on_) return std::nullopt;
    std::optional<base::Instant> next = handset_.next_deadline();
    if (is_speaking(now)) next = std::min(next.value_or(speaks_until()), speaks_until());
    return next;
}

Health Hearing::health() const { return concert_ ? concert_->health() : Health{}; }

}  // namespace quadrat::hearing
