// SPDX-License-Identifier: Apache-2.0
#include "kiosk/show.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/log.hpp"
#include "breeding/agreement.hpp"
#include "breeding/words/heredity.hpp"
#include "breeding/words/questions.hpp"
#include "genome/scene_code.hpp"
#include "nursery/foreseen.hpp"

namespace quadrat::kiosk {
namespace {

using exhibit::Screen;

constexpr const char* kButtonNames[] = {"A", "B", "C", "D", "Back"};
constexpr std::size_t kMostWordsAsked = 10;  // that the configuration allows, which may change while they are

learning::Rules rules_of(const site::Configuration& configuration) {
    return {breeder_options_of(configuration), configuration.breeding.control_every, locked_in(configuration)};
}

std::size_t number_in(const std::string& text) {  // 0: none
    std::size_t number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

Wanted wanted_by(const site::Configuration& configuration) {
    return {configuration.take_home.url, configuration.visit.describe_others};
}

}  // namespace

Show::Show(const site::Configuration& configuration, ShowOptions options, std::unique_ptr<learning::Keeper> keeper)
    : pace_(timings_of(configuration)),
      school_(
          options.state,
          configuration.breeding.learns_taste ? learning::School::OfTaste::Learn : learning::School::OfTaste::Ignore,
          std::move(options.local_time)),
      founder_(rules_of(configuration), options.seed),
      diary_(std::move(keeper), std::move(options.wall_time),
             configuration.fleet.broker.empty() ? learning::Diary::ToldTo::Nobody : learning::Diary::ToldTo::Fleet),
      programme_(options.growing, options.works),
      spoken_(configuration),
      wanted_(wanted_by(configuration)) {
    founder_.learn(school_.school());
    programme_.choose(chosen_by(configuration));
}

Show::Show(const site::Configuration& configuration, ShowOptions options, archive::Archive archive)
    : Show(configuration, std::move(options), std::make_unique<learning::Keeper>(std::move(archive))) {}

void Show::open(base::Instant now) {
    school_.begin(diary_.keeper());
    if (!take_up(now)) step(exhibit::opening(now), now);
}

void Show::happen(const exhibit::Event& event, base::Instant now) {
    pace_.allow_breeding_on(!programme_.gallery().scenes.empty());
    programme_.look_at_wall(now);
    if (programme_.has_progressed()) step(exhibit::next(state_, exhibit::Grew{}, now, timings()), now);
    step(exhibit::next(state_, event, now, timings()), now);
    programme_.look();
    take_up(now);
    const bool is_free = state_.screen == Screen::Attract;
    if (school_.look(diary_.keeper(), !is_free)) founder_.learn(school_.school());
    if (is_free) programme_.regrow_gallery();
}

void Show::step(exhibit::Step step, base::Instant now) {
    const Screen before = state_.screen;
    state_ = std::move(step.state);
    if (before == Screen::Attract && state_.screen != Screen::Attract) programme_.leave_gallery(state_.breeds_on, now);
    for (const exhibit::Wish& wish : step.wishes) std::visit([&](const auto& one) { carry_out(one, now); }, wish);
    if (before == state_.screen) return;
    if (state_.screen == Screen::Attract) programme_.open_gallery(now);
    if (state_.screen == Screen::Describe) begin_to_describe(now);
}

// A visit that a pulled plug interrupted: its deeds lead to the same four again, or it is left alone.
bool Show::take_up(base::Instant now) {
    const auto kept = diary_.take_left_behind();
    if (kept) {
        programme_.recall(nursery::Collection::from_json(kept->collection));
        others_described_ = number_in(kept->described);
    }
    const bool is_free = state_.screen == Screen::Attract && visits_ended() == 0;
    if (!kept || !kept->interrupted || !is_free) return false;
    auto lineage = founder_.resume(*kept->interrupted, school_.school());
    if (!lineage) return false;
    lineages_.now = std::move(lineage);
    resume(*kept->interrupted, now);
    spoken_.resume(kept->language);
    return true;
}

void Show::resume(const archive::Generation& kept, base::Instant now) {
    diary_.go_on_with_visit(kept.visit);
    base::log::info("taking up visit {} at round {}, which was interrupted", kept.visit, kept.round);
    step({is_sliding() ? exhibit::resumed_sliding(kept.round - 1, now)
                       : exhibit::resumed(archive::picks_of(kept.deeds), kept.answers, now),
          {}},
         now);
    grow_offer(state_.generation, 0);
}

void Show::grow_offer(int generation, learning::Keeper::Ticket kept) {
    const breeding::Session& session = lineages_.now->session();
    std::vector<genome::Candidate> candidates;
    if (is_sliding())
        candidates = {session.favourite()};
    else
        candidates.assign(session.offer().candidates.begin(), session.offer().candidates.end());
    programme_.order({generation, kept}, candidates, session.flight());
}

void Show::carry_out(const exhibit::Acknowledge& wish, base::Instant now) {
    last_press_ = {wish.button, now};
    base::log::info("press {} at {:.3f} s", kButtonNames[static_cast<std::size_t>(wish.button)],
                    std::chrono::duration<double>(now).count());
}

void Show::carry_out(const exhibit::PrepareVisit& wish, base::Instant /*now*/) {
    lineages_.prepare(founder_.found());
    grow_offer(wish.generation, 0);
}

void Show::carry_out(const exhibit::BeginVisit& /*wish*/, base::Instant now) {
    programme_.begin_visit(now);  // the four grow in before the visitor's eyes
    caption_.clear();             // the last visitor's
    lineages_.left.reset();
    diary_.begin_visit();
    diary_.keep(lineages_.now->generation({}));  // nobody waits for it: what is lost of it cost the visitor one press
    base::log::info("a visit begins");
}

void Show::keep_answers(const genome::Pick& answers) {
    diary_.keep_answers(lineages_.now->session().offer().round, answers);
}

void Show::carry_out(const exhibit::KeepAnswers& wish, base::Instant /*now*/) {
    keep_answers(wish.answers);
    const bool is_last_round = state_.rounds + 1 >= timings().rounds;  // or nearly always
    const bool is_last_question = state_.question == genome::kAspects.back();
    programme_.foresee([session = lineages_.now->session(),
                        answered = nursery::Answered{wish.answers, is_last_round, is_last_question, true}] {
        return nursery::foreseen(session, answered);
    });
}

void Show::carry_out(const exhibit::GrowNext& wish, base::Instant now) {
    keep_answers(wish.answers);
    const genome::Candidate before = lineages_.now->session().favourite();
    lineages_.now->next(wish.answers);
    const breeding::Session& session = lineages_.now->session();
    const auto agreed = breeding::agreement(session.breeder_before(), session.breeder());
    step(exhibit::next(state_, exhibit::Believed{agreed.is_narrow, agreed.is_changing}, now, timings()), now);
    if (state_.generation != wish.generation) return;  // the finale comes in their place
    caption_ =
        breeding::heredity(spoken_.language(), session.breeder().word_map(), before, session.favourite(), wish.answers);
    grow_offer(wish.generation, diary_.keep(lineages_.now->generation({})));
}

void Show::carry_out(const exhibit::UndoRound& wish, base::Instant /*now*/) {
    lineages_.now->undo();
    caption_.clear();
    grow_offer(wish.generation, diary_.keep(lineages_.now->generation(wish.answers)));
}

void Show::carry_out(const exhibit::GrowFinale& wish, base::Instant /*now*/) {
    const bool is_judged =
        std::ranges::any_of(wish.answers.each, [](const auto& answer) { return answer.has_value(); });
    const base::Seed flight = lineages_.now->session().flight();
    if (is_judged) {
        keep_answers(wish.answers);
        lineages_.now->finish(wish.answers);
    }
    genome::Candidate favourite = lineages_.now->session().favourite();
    favourite.values = genome::rounded_for_code(favourite.values);  // as whoever has its code grows it
    bred_ = {.own = {genome::recipe_of(favourite, flight), favourite.words},
             .asked = breeding::words_to_ask(lineages_.now->session().seed().child("describe"), kMostWordsAsked)};
    if (!wanted_.take_home_url.empty()) bred_.take_home = wanted_.take_home_url + genome::code_of(bred_.own.recipe);
    caption_ = favourite.words ? spoken_.language().describe(*favourite.words) : "";
    if (!caption_.empty()) base::log::info("the landscape they bred: {}", caption_);
    programme_.order({wish.generation, 0, true}, {favourite}, flight);
}

void Show::carry_out(const exhibit::TurnSlider& wish, base::Instant /*now*/) {
    lineages_.now->slide(wish.slider, wish.direction);
    grow_offer(wish.generation, diary_.keep(lineages_.now->generation({})));
}

void Show::carry_out(const exhibit::UndoTurn& wish, base::Instant /*now*/) {
    lineages_.now->undo();
    grow_offer(wish.generation, diary_.keep(lineages_.now->generation({})));
}

void Show::carry_out(const exhibit::KeepWord& wish, base::Instant /*now*/) {
    const genome::WordAnswer answer{bred_.described().recipe, bred_.described().words,
                                    bred_.asked.at(static_cast<std::size_t>(wish.which)), wish.answer};
    base::log::info("it was called {}", genome::language("en").answers(answer.word).at(answer.step));
    diary_.keep_word(answer);
}

void Show::carry_out(const exhibit::SpeakLanguage& wish, base::Instant /*now*/) {
    spoken_.choose(wish.which);
    remember("language", spoken_.code());
    base::log::info("a visitor chose the language {}", spoken_.code());
}

void Show::carry_out(const exhibit::ReturnTo& wish, base::Instant /*now*/) {
    lineages_.go_on_with_left();
    lineages_.now->return_to(wish.node, state_.past_answers);
    caption_.clear();
    grow_offer(wish.generation, diary_.keep(lineages_.now->generation({})));
}

void Show::carry_out(const exhibit::BreedOn& wish, base::Instant /*now*/) {
    if (!programme_.liked().empty()) lineages_.now->begin_with(programme_.liked());
    grow_offer(wish.generation, diary_.keep(lineages_.now->generation({})));
}

void Show::carry_out(const exhibit::PrintPostcard& /*wish*/, base::Instant /*now*/) { bred_.wants_postcard = true; }

void Show::carry_out(const exhibit::EndVisit& wish, base::Instant /*now*/) {
    spoken_.end_visit();
    diary_.end_visit(wish);
    constexpr const char* kEndings[] = {"with its finale", "unanswered", "because its landscapes did not come"};
    base::log::info("the visit ends {}, after {} rounds", kEndings[static_cast<std::size_t>(wish.ending)], wish.rounds);
}

bool Show::is_kept_within(std::chrono::nanoseconds patience) {
    const auto& coming = programme_.coming();
    return !coming || diary_.is_kept(coming->kept, patience);
}

void Show::uploaded(base::Instant now) {
    if (programme_.waiting_for_upload() == nullptr || !is_kept_within({})) return;
    // A landscape that is turned stays where the eye is; four new ones grow in.
    const Coming done = programme_.uploaded(state_.screen == Screen::Slide ? programme_.offered().arrived : now,
                                            {bred_.own.words, diary_.today(), lineages_.now->liked()});
    if (done.is_finale)
        remember("collection", programme_.collection().to_json());
    else
        base::log::info("the four of round {} are on the screen", lineages_.now->session().offer().round);
    happen(exhibit::GenerationReady{done.generation}, now);
    if (done.is_finale) ask_about_another();
}

// Where the site has it so, and words will be asked for: while the finale is looked at, what they are asked about
// grows.
void Show::ask_about_another() {
    const bool asks = timings().describe_words > 0 && state_.finales % std::max(1, timings().describe_every) == 0;
    if (!wanted_.describes_others || !asks) return;
    const breeding::Session& session = lineages_.now->session();
    genome::Candidate other =
        breeding::landscape_to_describe(school_.school().map(), others_described_, session.seed().child("described"));
    other.values = genome::rounded_for_code(other.values);
    programme_.ask_about(nursery::landscape_of(std::move(other), session.flight()));
}

void Show::begin_to_describe(base::Instant now) {
    const nursery::Landscape* other = programme_.begin_asking(now);
    if (other == nullptr) return;
    bred_.other = {genome::recipe_of(other->candidate, other->flight), other->candidate.words};
    remember("described", std::to_string(++others_described_));
}

void Show::finish_growing() {
    school_.wait(diary_.keeper());
    if (programme_.coming()) diary_.keeper().wait(programme_.coming()->kept);
    programme_.wait();
}

void Show::follow(const site::Configuration& configuration) {
    const breeding::BreederOptions breeder = breeder_options_of(configuration);
    pace_.follow(timings_of(configuration), founder_.rules().breeder.genome != genome::Genome::Classic);
    spoken_.follow(configuration);
    wanted_ = wanted_by(configuration);
    founder_.follow(breeder.ranges, locked_in(configuration));
    programme_.choose(chosen_by(configuration));
}

std::string Show::caption() const {
    if (const auto* wall = programme_.wall()) return wall->caption(spoken_.language());
    const learning::Lineage* bred = lineages_.bred();
    if (state_.screen != Screen::Family || bred == nullptr) return caption_;
    const genome::Candidate then = bred->session().favourite_of(state_.walked);
    return then.words ? spoken_.language().describe(*then.words) : "";
}

std::string Show::take_home() const {
    const auto* wall = programme_.wall();
    return wall != nullptr ? wall->address(wanted_.take_home_url) : bred_.take_home;
}

const nursery::Act& Show::on_stage() const { return programme_.act_of(state_.screen); }

bool Show::can_go_back() const {
    switch (state_.screen) {
        case Screen::Ask:
            return state_.question != genome::Aspect::Trees || (lineages_.now && lineages_.now->session().can_undo());
        case Screen::Slide:
            return state_.turns_to_undo > 0;
        case Screen::Describe:
        case Screen::Language:
        case Screen::Family:
            return true;
        default:
            return false;
    }
}

std::optional<stage::Asked> Show::asked() const {
    if (state_.screen == Screen::Slide && lineages_.now)
        if (const auto slider = lineages_.now->session().breeder().slider(static_cast<std::size_t>(state_.slider)))
            return stage::asked_to_slide(spoken_, slider->name, slider->word, slider->share);
    std::optional<genome::WordId> word;
    if (state_.screen == Screen::Describe) word = bred_.asked.at(static_cast<std::size_t>(state_.described));
    return stage::asked_of(state_, timings(), spoken_, word);
}

hearing::Subject Show::heard(base::Instant now) const {
    hearing::Subject subject{state_, now, spoken_.code(), hearing::key_of(exhibit::prompt_of(state_))};
    subject.caption = caption();
    if (last_press_) {
        subject.pressed = last_press_->button;
        subject.pressed_at = last_press_->at;
    }
    if (const auto asked = this->asked()) {
        subject.prompt = asked->prompt;
        subject.labels = asked->labels;
        if (asked->slider) subject.labels = {"", "", asked->slider->low, asked->slider->high};
    }
    if (state_.screen == Screen::Language) subject.label_languages = spoken_.codes(state_.first_language);
    if (state_.screen == Screen::Ask && lineages_.now)
        for (std::size_t i = 0; i < subject.four.size(); ++i)
            subject.four[i] = lineages_.now->session().offer().candidates[i].words;
    return subject;
}

}  // namespace quadrat::kiosk
