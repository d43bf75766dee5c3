// SPDX-License-Identifier: Apache-2.0
#include "kiosk/show.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/log.hpp"
#include "genome/scene_code.hpp"
#include "genome/speech.hpp"
#include "nursery/head_start.hpp"
#include "switches/switches.hpp"

namespace quadrat::kiosk {
namespace {

using exhibit::Screen;
using Urgency = Keeper::Urgency;
// So long a generation waits to be kept before it is shown. A healthy disk takes milliseconds, a bad card seconds; one
// that hangs must not end the visit.
constexpr std::chrono::seconds kDiskPatience{4};
constexpr std::size_t kMostWordsAsked = 10;  // that the configuration allows

constexpr const char* kButtonNames[] = {"A", "B", "C", "D", "Back"};

}  // namespace

Show::Show(const site::Configuration& configuration, ShowOptions options, std::unique_ptr<Keeper> keeper)
    : usual_timings_(timings_of(configuration)),
      timings_(usual_timings_),
      breeder_options_(breeder_options_of(configuration)),
      control_every_(configuration.breeding.control_every),
      locked_(locked_in(configuration)),
      options_(std::move(options)),
      visit_(std::make_shared<std::int64_t>(0)),
      school_(std::make_shared<School>(
          options_.state, configuration.breeding.learns_taste ? School::OfTaste::Learn : School::OfTaste::Ignore)),
      keeper_(std::move(keeper)),
      grower_(options_.growing),
      is_in_fleet_(!configuration.fleet.broker.empty()),
      spoken_(configuration),
      take_home_url_(configuration.take_home.url),
      is_collected_(!configuration.desk.listen.empty()) {
    breeder_options_.map = school_->map();
    breeder_options_.taste = school_->taste();
    gallery_.choose(chosen_by(configuration));
}

Show::Show(const site::Configuration& configuration, ShowOptions options, archive::Archive archive)
    : Show(configuration, std::move(options), std::make_unique<Keeper>(std::move(archive))) {}

void Show::open(base::Instant now) {
    study();
    if (!take_up(now)) step(exhibit::opening(now), now);
}

// Beside the first visit, which has the map of before.
void Show::study() {
    studied_night_ = night_of(options_.local_time());
    study_ = keeper_->post(
        [school = school_](const archive::Archive& archive) -> archive::Trouble {
            school->begin(archive.word_answers());
            return std::nullopt;
        },
        Urgency::Written);
}

void Show::study_at_night() {
    if (school_->take()) {
        breeder_options_.map = school_->map();
        breeder_options_.taste = school_->taste();
    }
    if (state_.screen == exhibit::Screen::Attract && night_of(options_.local_time()) != studied_night_) study();
}

void Show::happen(const exhibit::Event& event, base::Instant now) {
    const float progress = growing_progress();
    if (std::exchange(progress_, progress) != progress)
        step(exhibit::next(state_, exhibit::Grew{}, now, timings_), now);
    step(exhibit::next(state_, event, now, timings_), now);
    take_up(now);
    study_at_night();
    regrow_gallery();
}

void Show::step(exhibit::Step step, base::Instant now) {
    const exhibit::Screen before = state_.screen;
    state_ = std::move(step.state);
    for (const exhibit::Wish& wish : step.wishes) std::visit([&](const auto& one) { carry_out(one, now); }, wish);
    if (before != state_.screen && state_.screen == exhibit::Screen::Attract) gallery_.open(now);
}

breeding::Session Show::fresh_session() {
    const base::Seed seed = options_.seed.child("visit").child(sessions_++);
    breeding::Breeder breeder(options_of_visit(breeder_options_, control_every_, seed));
    for (const genome::Aspect aspect : locked_) breeder.set_lock(aspect, breeding::Lock::Locked);
    return {std::move(breeder), seed};
}

void Show::grow_offer(int generation, Keeper::Ticket kept) {
    std::vector<genome::Candidate> candidates;
    if (is_sliding())
        candidates = {session_->favourite()};
    else
        candidates.assign(session_->offer().candidates.begin(), session_->offer().candidates.end());
    stop_regrowing();
    refined_.reset();
    waiting_.emplace();
    waiting_->generation = generation;
    waiting_->kept = kept;
    for (const genome::Candidate& candidate : candidates)
        waiting_->recipes.push_back(genome::recipe_of(candidate, session_->flight()));
    grower_.order({std::move(candidates), session_->flight()});
}

archive::Generation Show::generation_of(const genome::Pick& answers) const {
    archive::Generation generation;
    generation.round = session_->offer().round;
    generation.seed = session_->seed();
    generation.breeder = session_->breeder().name();
    generation.deeds = deeds_;
    generation.digest = archive::digest_of(session_->offer());
    generation.answers = answers;
    return generation;
}

Keeper::Ticket Show::keep_generation(const genome::Pick& answers) {
    const auto keep = [generation = generation_of(answers), visit = visit_](archive::Archive& archive) mutable {
        generation.visit = *visit;
        return archive.append(generation);
    };
    // The first four cost the visitor nothing yet, and many visits end with them.
    return keeper_->post(keep, deeds_.empty() ? Urgency::Written : Urgency::Flushed);
}

void Show::carry_out(const exhibit::Acknowledge& wish, base::Instant now) {
    last_press_ = wish.button;
    last_press_at_ = now;
    base::log::info("press {} at {:.3f} s", kButtonNames[static_cast<std::size_t>(wish.button)],
                    std::chrono::duration<double>(now).count());
}

void Show::carry_out(const exhibit::PrepareVisit& wish, base::Instant /*now*/) {
    session_.emplace(fresh_session());
    deeds_.clear();
    grow_offer(wish.generation, 0);
}

void Show::carry_out(const exhibit::BeginVisit& /*wish*/, base::Instant now) {
    stop_regrowing();
    gallery_.make_room();
    offered_.arrived = now;  // the four grow in before the visitor's eyes
    caption_.clear();        // the last visitor's
    visit_ = std::make_shared<std::int64_t>(0);
    keeper_->post(
        [visit = visit_, at = options_.wall_time()](archive::Archive& archive) {
            const auto begun = archive.begin_visit(at);
            *visit = begun.visit;
            return begun.trouble;
        },
        Urgency::Soon);
    keep_generation({});  // nobody waits for it: what is lost of it cost the visitor one press
    base::log::info("a visit begins");
}

void Show::keep_answers(const genome::Pick& answers) {
    const int round = session_->offer().round;
    keeper_->post([visit = visit_, round, answers, at = options_.wall_time()](
                      archive::Archive& archive) { return archive.keep_answers(*visit, round, answers, at); },
                  Urgency::Soon);
}

void Show::carry_out(const exhibit::KeepAnswers& wish, base::Instant /*now*/) {
    keep_answers(wish.answers);
    const bool is_last_round = state_.rounds + 1 >= timings_.rounds;
    const bool is_last_question = state_.question == genome::kAspects.back();
    grower_.begin([session = *session_, answered = nursery::Answered{wish.answers, is_last_round, is_last_question,
                                                                     !take_home_url_.empty()}] {
        return nursery::head_start(session, answered);
    });
}

// Where the answers moved the wish, aspect by aspect: in words, and one detail that no word tells.
std::string Show::heredity(const genome::Candidate& before, const genome::Candidate& now,
                           const genome::Pick& answers) const {
    const genome::Language& language = spoken_.language();
    const auto moved = breeding::moved_beside_words(session_->breeder().word_map(), before, now);
    std::string text;
    for (const genome::Aspect aspect : genome::kAspects) {
        if (!answers[aspect]) continue;
        const std::string in_words = language.heredity(*before.words, *now.words, aspect);
        const std::string detail = language.detail(moved, aspect);
        const char* between = in_words.empty() || detail.empty() ? "" : ", ";
        const std::string both = fmt::format("{}{}{}", in_words, between, detail);
        if (!both.empty()) text.append(text.empty() ? "→ " : " · ").append(both);
    }
    return text;
}

void Show::carry_out(const exhibit::GrowNext& wish, base::Instant /*now*/) {
    keep_answers(wish.answers);
    const genome::Candidate before = session_->favourite();
    session_->next(wish.answers);
    deeds_.push_back({wish.answers, std::nullopt});
    caption_ = before.words ? heredity(before, session_->favourite(), wish.answers) : "";
    grow_offer(wish.generation, keep_generation({}));
}

void Show::undo() {
    if (session_->undo() && !deeds_.empty()) deeds_.pop_back();
}

void Show::carry_out(const exhibit::UndoRound& wish, base::Instant /*now*/) {
    undo();
    caption_.clear();
    grow_offer(wish.generation, keep_generation(wish.answers));
}

void Show::carry_out(const exhibit::GrowFinale& wish, base::Instant /*now*/) {
    const bool is_judged =
        std::ranges::any_of(wish.answers.each, [](const auto& answer) { return answer.has_value(); });
    const base::Seed flight = session_->flight();
    if (is_judged) {
        keep_answers(wish.answers);
        session_->next(wish.answers);
    }
    genome::Candidate favourite = session_->favourite();
    if (!take_home_url_.empty() || is_collected_) favourite.values = genome::rounded_for_code(favourite.values);
    bred_ = {genome::recipe_of(favourite, flight), favourite.words, words_to_ask()};
    caption_ = favourite.words ? spoken_.language().describe(*favourite.words) : "";
    if (!caption_.empty()) base::log::info("the landscape they bred: {}", caption_);
    take_home_ = take_home_url_.empty() ? "" : take_home_url_ + genome::code_of(bred_.recipe);
    refined_.reset();
    waiting_.emplace();
    waiting_->generation = wish.generation;
    waiting_->is_finale = true;
    waiting_->recipes.push_back(genome::recipe_of(favourite, flight));
    grower_.order({{favourite}, flight});
}

// One of each aspect in turn, by the chance of this visit; none twice. More than are asked now: the settings may change
// while they are.
std::vector<genome::WordId> Show::words_to_ask() const {
    base::RandomStream chance(session_->seed().child("describe"));
    const std::uint32_t first = chance.below(static_cast<std::uint32_t>(genome::kAspects.size()));
    std::vector<genome::WordId> asked;
    while (asked.size() < kMostWordsAsked) {
        const auto words = genome::vocabulary(genome::kAspects[(first + asked.size()) % genome::kAspects.size()]);
        const genome::WordId id = words[chance.below(static_cast<std::uint32_t>(words.size()))].id;
        if (std::ranges::find(asked, id) == asked.end()) asked.push_back(id);
    }
    return asked;
}

void Show::carry_out(const exhibit::TurnSlider& wish, base::Instant /*now*/) {
    session_->slide(static_cast<std::size_t>(wish.slider), wish.direction);
    deeds_.push_back({{}, archive::SliderStep{wish.slider, wish.direction}});
    grow_offer(wish.generation, keep_generation({}));
}

void Show::carry_out(const exhibit::UndoTurn& wish, base::Instant /*now*/) {
    undo();
    grow_offer(wish.generation, keep_generation({}));
}

void Show::carry_out(const exhibit::KeepWord& wish, base::Instant /*now*/) {
    const genome::WordAnswer answer{bred_.recipe, bred_.words, bred_.asked.at(static_cast<std::size_t>(wish.which)),
                                    wish.answer};
    base::log::info("it was called {}", genome::language("en").answers(answer.word).at(answer.step));
    keeper_->post(
        [answer, at = options_.wall_time()](archive::Archive& archive) { return archive.keep_word(answer, at); },
        Urgency::Soon);
}

void Show::carry_out(const exhibit::SpeakLanguage& wish, base::Instant /*now*/) {
    spoken_.choose(wish.which);
    remember("language", spoken_.code());
    base::log::info("a visitor chose the language {}", spoken_.code());
}

void Show::carry_out(const exhibit::EndVisit& wish, base::Instant /*now*/) {
    ++visits_ended_;
    spoken_.end_visit();
    if (is_in_fleet_) {
        constexpr const char* kNames[] = {"finished", "left", "stuck"};
        keeper_->post([text = fmt::format(R"({{"ended_ms":{},"ending":"{}","rounds":{}}})",
                                          options_.wall_time().time_since_epoch().count(),
                                          kNames[static_cast<std::size_t>(wish.ending)], wish.rounds)](
                          archive::Archive& archive) { return archive.post("visits", text); },
                      Urgency::Soon);
    }
    keeper_->post([visit = visit_, wish, at = options_.wall_time()](
                      archive::Archive& archive) { return archive.end_visit(*visit, wish.ending, wish.rounds, at); },
                  Urgency::Soon);
    constexpr const char* kEndings[] = {"with its finale", "unanswered", "because its landscapes did not come"};
    base::log::info("the visit ends {}, after {} rounds", kEndings[static_cast<std::size_t>(wish.ending)], wish.rounds);
}

const nursery::Act* Show::waiting_for_upload() {
    if (!waiting_) return nullptr;
    if (!waiting_->act) {
        auto scenes = grower_.take();
        if (!scenes) return nullptr;
        waiting_->act =
            std::make_unique<nursery::Act>(nursery::Act{std::move(*scenes), waiting_->recipes, ++acts_, {}});
    }
    return waiting_->act.get();
}

bool Show::is_kept_within(std::chrono::nanoseconds patience) {
    return !waiting_ || keeper_->is_done(waiting_->kept, patience) || keeper_->waited_for() >= kDiskPatience;
}

void Show::uploaded(base::Instant now) {
    if (waiting_for_upload() == nullptr || !is_kept_within({})) return;
    Waiting done = std::move(*waiting_);
    waiting_.reset();
    // A landscape that is turned stays where the eye is; four new ones grow in.
    done.act->arrived = state_.screen == exhibit::Screen::Slide ? offered_.arrived : now;
    if (done.is_finale) {
        finale_ = *done.act;
        gallery_.hang(finale_);
    } else {
        offered_ = std::move(*done.act);
        base::log::info("the four of round {} are on the screen", session_->offer().round);
    }
    happen(exhibit::GenerationReady{done.generation}, now);
}

void Show::finish_growing() {
    keeper_->wait(study_);
    school_->wait();
    if (waiting_) keeper_->wait(waiting_->kept);
    if (is_regrowing_ || (waiting_ && !waiting_->act)) grower_.wait();
}

void Show::follow(const site::Configuration& configuration) {
    // The breeder is that of the start, and with it how it is spoken to.
    const exhibit::Asking asking = timings_.asking;
    const int sliders = timings_.sliders;
    usual_timings_ = timings_of(configuration);
    usual_timings_.asking = asking;
    usual_timings_.sliders = sliders;
    if (breeder_options_.genome == genome::Genome::Classic) usual_timings_.describe_words = 0;
    timings_ = switches::patient(usual_timings_, patience_);
    spoken_.follow(configuration);
    take_home_url_ = configuration.take_home.url;
    // Of the visits that are prepared from now on: who has begun goes on as they began.
    breeder_options_.ranges = breeder_options_of(configuration).ranges;
    locked_ = locked_in(configuration);
    gallery_.choose(chosen_by(configuration));
}

void Show::wait_longer(double times) {
    patience_ = times;
    timings_ = switches::patient(usual_timings_, patience_);
}

void Show::remember(const std::string& name, std::string text) {
    keeper_->post([name, text = std::move(text)](archive::Archive& archive) { return archive.remember(name, text); },
                  Urgency::Soon);
}

std::string Show::state_trouble() const {
    const auto waited = keeper_->waited_for();
    if (waited < kDiskPatience) return keeper_->trouble();
    return fmt::format("the disk has not answered for {} s",
                       std::chrono::duration_cast<std::chrono::seconds>(waited).count());
}

const nursery::Act& Show::act_of(exhibit::Screen screen) const {
    if (screen == exhibit::Screen::Finale || screen == exhibit::Screen::Describe) return finale_;
    if (screen == exhibit::Screen::Attract && !gallery_.act().scenes.empty()) return gallery_.act();
    return offered_;
}

const nursery::Act& Show::on_stage() const { return act_of(state_.screen); }

std::span<const genome::Recipe> Show::recipes_on_stage() const {
    return &on_stage() == &gallery_.act() ? gallery_.recipes() : std::span(on_stage().recipes);
}

std::vector<const nursery::Act*> Show::in_use() const {
    return {&offered_, &finale_, &gallery_.act(), refined_ ? &*refined_ : nullptr};
}

bool Show::can_go_back() const {
    switch (state_.screen) {
        case exhibit::Screen::Ask:
            return state_.question != genome::Aspect::Trees || (session_ && session_->can_undo());
        case exhibit::Screen::Slide:
            return state_.turns_to_undo > 0;
        case exhibit::Screen::Describe:
        case exhibit::Screen::Language:
            return true;
        default:
            return false;
    }
}

std::optional<stage::Asked> Show::asked() const {
    if (state_.screen == exhibit::Screen::Language)
        return stage::Asked{"ask.language", spoken_.labels(state_.first_language), std::nullopt};
    const genome::Language& language = spoken_.language();
    if (state_.screen == exhibit::Screen::Describe) {
        const genome::WordId id = bred_.asked.at(static_cast<std::size_t>(state_.described));
        return stage::Asked{fmt::format("describe.{}", name_of(word(id).aspect)), language.answers(id), std::nullopt};
    }
    if (state_.screen != exhibit::Screen::Slide || !session_) return std::nullopt;
    const auto slider = session_->breeder().slider(static_cast<std::size_t>(state_.slider));
    if (!slider) return std::nullopt;
    stage::ShownSlider shown{"", std::string(slider->name), static_cast<float>(slider->share)};
    if (slider->word)
        shown = {std::string(language.end(*slider->word, false)), std::string(language.end(*slider->word, true)),
                 shown.share};
    return stage::Asked{"slide", {"←", "→", "−", "+"}, shown};
}

hearing::Subject Show::heard(base::Instant now) const {
    hearing::Subject subject{state_, now, spoken_.code(), hearing::key_of(exhibit::prompt_of(state_))};
    subject.caption = caption_;
    subject.pressed = last_press_;
    subject.pressed_at = last_press_at_;
    if (const auto asked = this->asked()) {
        subject.prompt = asked->prompt;
        subject.labels = asked->labels;
        if (asked->slider) subject.labels = {"", "", asked->slider->low, asked->slider->high};
    }
    if (state_.screen == Screen::Language) subject.label_languages = spoken_.codes(state_.first_language);
    if (state_.screen == Screen::Ask && session_)
        for (std::size_t i = 0; i < subject.four.size(); ++i) subject.four[i] = session_->offer().candidates[i].words;
    return subject;
}

}  // namespace quadrat::kiosk
