// SPDX-License-Identifier: Apache-2.0
#include "hearing/narrator.hpp"

#include <algorithm>
#include <utility>

#include "genome/speech.hpp"

namespace quadrat::hearing {
namespace {

using exhibit::Choice;
using exhibit::Screen;
using sound::Signal;

int place_of(Choice choice) { return static_cast<int>(choice); }

base::Instant time_for(const sound::Utterance& utterance) {
    return std::chrono::duration_cast<base::Instant>(std::chrono::duration<double>(speaking_time_s(utterance)));
}

// What invites a passer-by is on the screen alone: it would be said all day.
bool is_said(const std::string& hint) { return hint.starts_with("scan.") || hint.starts_with("hold."); }

}  // namespace

std::string key_of(exhibit::Prompt prompt) {
    using exhibit::Prompt;
    switch (prompt) {
        case Prompt::PressAnyButton:
            return "attract";
        case Prompt::BestTrees:
            return "ask.trees";
        case Prompt::BestLand:
            return "ask.land";
        case Prompt::BestSky:
            return "ask.sky";
        case Prompt::Growing:
            return "breed";
        case Prompt::StillThere:
            return "still-there";
        case Prompt::YourLandscape:
            return "finale";
        case Prompt::WhichLanguage:
            return "ask.language";
        case Prompt::WhichAncestor:
            return "family";
        case Prompt::WhichWords:
        case Prompt::TurnWords:
            break;
    }
    return "";
}

void Narrator::forget_visit() {
    rounds_ = 0;
    hint_.clear();
    knows_how_ = false;
}

void Narrator::be_silent(base::Instant now, Cues& cues) {
    if (std::exchange(has_said_, false)) cues.emplace_back(Hushes{});  // it may take longer than was reckoned
    speaks_until_ = now;
    described_.clear();
}

void Narrator::say(Says what, base::Instant now, Cues& cues) {
    if (sound::readable(what.utterance.text).empty()) return;
    const base::Instant from = std::max(speaks_until_, now);
    speaks_until_ = from + time_for(what.utterance);
    has_said_ = true;
    if (what.of) described_.push_back({from, speaks_until_, *what.of});
    cues.emplace_back(std::move(what));
}

void Narrator::say(const std::string& key, const Subject& subject, Cues& cues) {
    say({{subject.language, key, site::text(configuration_, key, subject.language)}, std::nullopt}, subject.now, cues);
}

void Narrator::say_choice(Choice choice, const Subject& subject, Cues& cues) {
    if (choice == Choice::Back) return say("back", subject, cues);
    const auto which = static_cast<std::size_t>(choice);
    std::string words = subject.labels[which];
    if (subject.visit.screen == Screen::Ask && subject.four[which])
        words = genome::language(subject.language).describe_among(subject.four, which, subject.visit.question);
    const bool is_there = subject.visit.screen == Screen::Ask || !words.empty() || choice == subject.marked;
    if (!is_there) return;
    const std::string& own = subject.label_languages[which];
    const std::string letter(1, "ABCD"[which]);
    say({{own.empty() ? subject.language : own, "", words.empty() ? letter : letter + ": " + words}, choice},
        subject.now, cues);
}

void Narrator::say_choices(const Subject& subject, Cues& cues) {
    for (const Choice choice : {Choice::A, Choice::B, Choice::C, Choice::D}) say_choice(choice, subject, cues);
}

void Narrator::ask(const Subject& subject, Cues& cues) {
    say(subject.prompt, subject, cues);
    if (subject.is_marking) return;  // each as it is marked
    say_choices(subject, cues);
    if (subject.visit.screen == Screen::Language || std::exchange(knows_how_, true)) return;
    say("hear.again", subject, cues);
}

void Narrator::tell_screen(const Subject& subject, Cues& cues) {
    const exhibit::State& visit = subject.visit;
    if (screen_ == visit.screen && since_ == visit.since && slider_ == visit.slider) return;
    const bool is_the_next_slider =
        visit.screen == Screen::Slide && screen_ == Screen::Slide && slider_ != visit.slider;
    const Screen before = std::exchange(screen_, visit.screen);
    had_asked_ = exhibit::asks(visit);
    since_ = visit.since;
    slider_ = visit.slider;
    // Whatever is still being said belongs to what is gone.
    be_silent(subject.now, cues);
    if (visit.screen == Screen::Ask && before == Screen::Breed && visit.rounds > std::exchange(rounds_, visit.rounds))
        cues.emplace_back(sound::Sounds{Signal::Round});
    if (visit.screen == Screen::Attract) forget_visit();
    if (is_the_next_slider) return say_choices(subject, cues);
    if (exhibit::asks(visit) && visit.screen != Screen::Finale) {
        const bool walks_on = visit.screen == Screen::Family && before == Screen::Family;
        if (!walks_on) return ask(subject, cues);
        return say({{subject.language, "", subject.caption}, std::nullopt}, subject.now, cues);
    }
    if (visit.screen == Screen::StillThere) {
        cues.emplace_back(sound::Sounds{Signal::StillThere});
        say("still-there", subject, cues);
    } else if (visit.screen == Screen::Finale) {
        cues.emplace_back(sound::Sounds{Signal::Finale});
        say("finale", subject, cues);
    }
    // The finale's is said when it is there to be looked at.
    const bool is_next_four = visit.screen == Screen::Breed && visit.after_breed != Screen::Finale;
    const bool has_caption = visit.screen == Screen::Finale || is_next_four;
    if (has_caption) say({{subject.language, "", subject.caption}, std::nullopt}, subject.now, cues);
    if (exhibit::asks(visit) && !subject.is_marking) say_choices(subject, cues);
}

void Narrator::tell_press(const Subject& subject, Cues& cues) {
    if (!subject.pressed || subject.pressed_at == std::exchange(pressed_at_, subject.pressed_at)) return;
    be_silent(subject.now, cues);  // who presses has heard enough
    const bool is_back = *subject.pressed == Choice::Back;
    cues.emplace_back(sound::Sounds{is_back ? Signal::Back : Signal::Press, place_of(*subject.pressed)});
    const bool is_answered = subject.visit.since == subject.pressed_at || subject.visit.since == subject.now;
    if (is_answered && !is_back && had_asked_)
        cues.emplace_back(sound::Sounds{Signal::Choice, place_of(*subject.pressed)});
}

void Narrator::tell_mark(const Subject& subject, Cues& cues) {
    if (is_said(subject.hint) && subject.hint != hint_) say(subject.hint, subject, cues);
    if (!subject.hint.empty()) hint_ = subject.hint;
    if (marked_ == subject.marked && marked_in_ == subject.visit.since) return;
    const bool had_rested = !std::exchange(marked_, subject.marked);
    marked_in_ = subject.visit.since;
    if (!marked_) return;
    // Who let the mark rest may have come back, or someone else: what was asked is asked again.
    if (had_rested && asked_in_ == subject.visit.since) say(subject.prompt, subject, cues);
    asked_in_ = subject.visit.since;
    cues.emplace_back(sound::Sounds{Signal::Mark, place_of(*marked_)});
    say_choice(*marked_, subject, cues);
}

std::vector<Cue> Narrator::look(const Subject& subject) {
    Cues cues;
    std::erase_if(described_, [&](const Described& one) { return one.until <= subject.now; });
    tell_press(subject, cues);
    tell_screen(subject, cues);
    tell_mark(subject, cues);
    return cues;
}

std::vector<Cue> Narrator::repeat(const Subject& subject) {
    Cues cues;
    be_silent(subject.now, cues);
    if (exhibit::asks(subject.visit) && subject.visit.screen != Screen::Finale) ask(subject, cues);
    if (subject.visit.screen == Screen::StillThere) say("still-there", subject, cues);
    if (subject.visit.screen == Screen::Finale) {
        say("finale", subject, cues);
        say({{subject.language, "", subject.caption}, std::nullopt}, subject.now, cues);
        if (exhibit::asks(subject.visit) && !subject.is_marking) say_choices(subject, cues);
    }
    if (subject.marked) say_choice(*subject.marked, subject, cues);
    return cues;
}

std::vector<Cue> Narrator::hush(base::Instant now) {
    Cues cues;
    be_silent(now, cues);
    return cues;
}

std::optional<std::size_t> Narrator::described(base::Instant now) const {
    for (const Described& one : described_)
        if (one.from <= now && now < one.until && one.choice != Choice::Back)
            return static_cast<std::size_t>(one.choice);
    return std::nullopt;
}

}  // namespace quadrat::hearing
