// SPDX-License-Identifier: Apache-2.0
#include "kiosk/show.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/log.hpp"
#include "genome/speech.hpp"

namespace quadrat::kiosk {
namespace {

using exhibit::Screen;
constexpr std::size_t kGallery = 3;  // landscapes of former visitors that stay on the GPU

std::chrono::milliseconds milliseconds_of(double seconds) {
    return std::chrono::milliseconds(std::llround(seconds * 1000.0));
}

constexpr const char* kButtonNames[] = {"A", "B", "C", "D", "Back"};

}  // namespace

exhibit::Timings timings_of(const Configuration& configuration) {
    exhibit::Timings timings;
    timings.patience = milliseconds_of(configuration.visit.patience_s);
    timings.countdown = milliseconds_of(configuration.visit.countdown_s);
    timings.finale = milliseconds_of(configuration.visit.finale_s);
    timings.long_press = milliseconds_of(configuration.visit.long_press_s);
    timings.rounds = configuration.visit.rounds;
    return timings;
}

breeding::BreederOptions breeder_options_of(const Configuration& configuration) {
    breeding::BreederOptions options;
    options.kind = breeding::breeder_named(configuration.breeding.breeder);
    options.genome = configuration.breeding.genome == "classic" ? genome::Genome::Classic : genome::Genome::Full;
    for (const auto& [name, ends] : configuration.words)
        options.ranges[static_cast<std::size_t>(genome::word_named(name).value())] = {static_cast<float>(ends[0]),
                                                                                      static_cast<float>(ends[1])};
    options.pbil.learning_rate = configuration.breeding.learning_rate;
    options.pbil.mutation = configuration.breeding.mutation;
    options.pbil.mutation_form = configuration.breeding.mutation_form == "random" ? breeding::MutationForm::Random
                                                                                  : breeding::MutationForm::TowardHalf;
    return options;
}

Show::Show(const Configuration& configuration, ShowOptions options, exhibit::Archive archive)
    : timings_(timings_of(configuration)),
      breeder_options_(breeder_options_of(configuration)),
      options_(std::move(options)),
      visit_(std::make_shared<std::int64_t>(0)),
      keeper_([&]() -> exhibit::Archive {
          if (const auto latest = archive.latest(); latest && archive.is_open(latest->visit)) interrupted_ = latest;
          return std::move(archive);
      }()),
      grower_(options_.growing),
      language_(configuration.visit.language) {
    for (const std::string& name : configuration.breeding.locked) locked_.push_back(genome::aspect_named(name).value());
}

void Show::open(Instant now) {
    if (interrupted_ && resume(*interrupted_, now)) return;
    step(exhibit::opening(now), now);
}

bool Show::resume(const exhibit::Generation& kept, Instant now) {
    try {
        breeding::Breeder breeder(breeder_options_);
        if (breeder.name() != kept.breeder)
            throw base::InputError(fmt::format("the breeder is {} now, and was {}", breeder.name(), kept.breeder));
        breeder.believe(kept.belief, "state");
        session_.emplace(std::move(breeder), kept.seed);
        if (session_->offer() != kept.offer)
            throw base::InputError("the breeding is tuned differently now, so the four would not be the same");
    } catch (const base::InputError& error) {
        base::log::warn("the interrupted visit is not taken up: {}", error.what());
        session_.reset();
        return false;
    }
    *visit_ = kept.visit;
    base::log::info("taking up visit {} at round {}, which was interrupted", kept.visit, kept.offer.round);
    step({exhibit::resumed(kept.offer.round - 1, kept.answers, now), {}}, now);
    grow_offer(state_.generation, 0);
    return true;
}

void Show::happen(const exhibit::Event& event, Instant now) { step(exhibit::next(state_, event, now, timings_), now); }

void Show::step(exhibit::Step step, Instant now) {
    const Screen before = state_.screen;
    state_ = std::move(step.state);
    for (const exhibit::Wish& wish : step.wishes) std::visit([&](const auto& one) { carry_out(one, now); }, wish);
    if (before != state_.screen && state_.screen == Screen::Attract) gallery_.arrived = now;
}

breeding::Session Show::fresh_session() {
    breeding::Breeder breeder(breeder_options_);
    for (const genome::Aspect aspect : locked_) breeder.set_lock(aspect, breeding::Lock::Locked);
    return {std::move(breeder), options_.seed.child("visit").child(sessions_++)};
}

void Show::grow_offer(int generation, Keeper::Ticket kept) {
    const auto& candidates = session_->offer().candidates;
    waiting_.emplace();
    waiting_->generation = generation;
    waiting_->kept = kept;
    for (const genome::Candidate& candidate : candidates)
        waiting_->recipes.push_back(genome::recipe_of(candidate, session_->flight()));
    grower_.order({candidates.begin(), candidates.end()}, session_->flight());
}

exhibit::Generation Show::generation_of(const genome::Pick& answers) const {
    exhibit::Generation generation;
    generation.seed = session_->seed();
    generation.flight = session_->flight();
    generation.breeder = session_->breeder().name();
    generation.belief = session_->breeder().belief_json();
    generation.offer = session_->offer();
    generation.answers = answers;
    return generation;
}

Keeper::Ticket Show::keep_generation(const genome::Pick& answers) {
    return keeper_.post([generation = generation_of(answers), visit = visit_](exhibit::Archive& archive) mutable {
        generation.visit = *visit;
        return archive.append(generation);
    });
}

void Show::carry_out(const exhibit::Acknowledge& wish, Instant now) {
    last_press_ = wish.button;
    last_press_at_ = now;
    base::log::info("press {} at {:.3f} s", kButtonNames[static_cast<std::size_t>(wish.button)],
                    std::chrono::duration<double>(now).count());
}

void Show::carry_out(const exhibit::PrepareVisit& wish, Instant /*now*/) {
    session_.emplace(fresh_session());
    grow_offer(wish.generation, 0);
}

void Show::carry_out(const exhibit::BeginVisit& /*wish*/, Instant now) {
    offered_.arrived = now;  // the four grow in before the visitor's eyes
    visit_ = std::make_shared<std::int64_t>(0);
    keeper_.post([visit = visit_, at = options_.wall_time()](exhibit::Archive& archive) {
        const auto begun = archive.begin_visit(at);
        *visit = begun.visit;
        return begun.trouble;
    });
    const Keeper::Ticket kept = keep_generation({});
    if (waiting_) waiting_->kept = kept;
    base::log::info("a visit begins");
}

void Show::keep_answers(const genome::Pick& answers) {
    const int round = session_->offer().round;
    keeper_.post([visit = visit_, round, answers, at = options_.wall_time()](exhibit::Archive& archive) {
        return archive.keep_answers(*visit, round, answers, at);
    });
}

void Show::carry_out(const exhibit::KeepAnswers& wish, Instant /*now*/) {
    keep_answers(wish.answers);
    // Aspects are independent: what was judged is final for the next four, and can begin to grow.
    const genome::Offer preview = session_->preview(wish.answers);
    for (const genome::Aspect aspect : genome::kAspects)
        if (wish.answers[aspect]) grower_.begin(aspect, preview);
}

// Where the answers moved the wish, aspect by aspect.
std::string Show::heredity(const genome::Description& before, const genome::Description& now,
                           const genome::Pick& answers) const {
    std::string text;
    for (const genome::Aspect aspect : genome::kAspects) {
        if (!answers[aspect]) continue;
        const std::string moved = genome::language(language_).heredity(before, now, aspect);
        if (!moved.empty()) text += (text.empty() ? "→ " : " · ") + moved;
    }
    return text;
}

void Show::carry_out(const exhibit::GrowNext& wish, Instant /*now*/) {
    keep_answers(wish.answers);
    const auto before = session_->favourite().words;
    session_->next(wish.answers);
    caption_ = before ? heredity(*before, *session_->favourite().words, wish.answers) : "";
    grow_offer(wish.generation, keep_generation({}));
}

void Show::carry_out(const exhibit::UndoRound& wish, Instant /*now*/) {
    session_->undo();
    caption_.clear();
    grow_offer(wish.generation, keep_generation(wish.answers));
}

void Show::carry_out(const exhibit::GrowFinale& wish, Instant /*now*/) {
    const bool is_judged =
        std::ranges::any_of(wish.answers.each, [](const auto& answer) { return answer.has_value(); });
    const base::Seed flight = session_->flight();
    if (is_judged) {
        keep_answers(wish.answers);
        session_->next(wish.answers);
    }
    const genome::Candidate favourite = session_->favourite();
    caption_ = favourite.words ? genome::language(language_).describe(*favourite.words) : "";
    if (!caption_.empty()) base::log::info("the landscape they bred: {}", caption_);
    waiting_.emplace();
    waiting_->generation = wish.generation;
    waiting_->is_finale = true;
    waiting_->recipes.push_back(genome::recipe_of(favourite, flight));
    grower_.order({favourite}, flight);
}

void Show::carry_out(const exhibit::EndVisit& wish, Instant /*now*/) {
    ++visits_ended_;
    keeper_.post([visit = visit_, wish, at = options_.wall_time()](exhibit::Archive& archive) {
        return archive.end_visit(*visit, wish.ending, wish.rounds, at);
    });
    constexpr const char* kEndings[] = {"with its finale", "unanswered", "because its landscapes did not come"};
    base::log::info("the visit ends {}, after {} rounds", kEndings[static_cast<std::size_t>(wish.ending)], wish.rounds);
}

const Act* Show::waiting_for_upload() {
    if (!waiting_ || !keeper_.is_done(waiting_->kept)) return nullptr;
    if (!waiting_->act) {
        auto scenes = grower_.take();
        if (!scenes) return nullptr;
        waiting_->act = std::make_unique<Act>(Act{std::move(*scenes), waiting_->recipes, ++acts_, {}});
    }
    return waiting_->act.get();
}

void Show::uploaded(Instant now) {
    if (waiting_for_upload() == nullptr) return;
    Waiting done = std::move(*waiting_);
    waiting_.reset();
    done.act->arrived = now;
    if (done.is_finale) {
        finale_ = *done.act;
        gallery_.scenes.insert(gallery_.scenes.begin(), finale_.scenes.begin(), finale_.scenes.end());
        if (gallery_.scenes.size() > kGallery) gallery_.scenes.resize(kGallery);
        gallery_.number = finale_.number;
    } else {
        offered_ = std::move(*done.act);
    }
    happen(exhibit::GenerationReady{done.generation}, now);
}

void Show::finish_growing() {
    if (!waiting_) return;
    keeper_.wait(waiting_->kept);
    if (!waiting_->act) grower_.wait();
}

const Act& Show::on_stage() const {
    if (state_.screen == Screen::Finale) return finale_;
    if (state_.screen == Screen::Attract && !gallery_.scenes.empty()) return gallery_;
    return offered_;
}

std::vector<const Act*> Show::in_use() const { return {&offered_, &finale_, &gallery_}; }

bool Show::can_go_back() const {
    if (state_.screen != Screen::Ask) return false;
    return state_.question != genome::Aspect::Trees || (session_ && session_->can_undo());
}

}  // namespace quadrat::kiosk
