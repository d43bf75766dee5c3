// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "archive/archive.hpp"
#include "base/clock.hpp"
#include "exhibit/visit.hpp"
#include "hearing/narrator.hpp"
#include "kiosk/bred.hpp"
#include "kiosk/pace.hpp"
#include "kiosk/programme.hpp"
#include "kiosk/show_settings.hpp"
#include "learning/diary.hpp"
#include "learning/lineage.hpp"
#include "learning/night_school.hpp"
#include "site/configuration.hpp"
#include "stage/asked.hpp"
#include "stage/spoken.hpp"
#include "stage/stage.hpp"

namespace quadrat::kiosk {

struct ShowOptions {
    base::Seed seed;  // names all chance of this run
    nursery::NurseryOptions growing;
    std::function<archive::WallTime()> wall_time;   // for the archive's rows
    std::function<archive::WallTime()> local_time;  // on the site's own clock: when it is night
    std::filesystem::path state;                    // the folder of the word map, beside the archive's file
    nursery::Wall::Read works = {};                 // nobody plays, and these are shown; or null
};

// Carries out what the exhibit wishes: breeds, keeps, grows; at its start and every night, has the word map trained on
// what visitors said, for the visits to come. Knows nothing of GL, of displays and of where presses
// come from. One thread; no call waits, but finish_growing().
class Show {
  public:
    Show(const site::Configuration& configuration, ShowOptions options, std::unique_ptr<learning::Keeper> keeper);
    Show(const site::Configuration& configuration, ShowOptions options, archive::Archive archive);

    // Takes up the visit that a pulled plug interrupted, or opens with Attract. Where the disk has not told yet whether
    // there is one, Attract too, and the visit is taken up as long as nobody has come meanwhile.
    void open(base::Instant now);

    void happen(const exhibit::Event& event, base::Instant now);

    // Which landscapes are shown and which are on their way. Once what waits for it is on the GPU, and is kept too, say
    // uploaded() here.
    Programme& programme() { return programme_; }
    const Programme& programme() const { return programme_; }
    bool is_kept_within(std::chrono::nanoseconds patience);  // or the disk had time enough
    void uploaded(base::Instant now);

    // Blocks until nothing grows and everything is kept: for simulated clocks.
    void finish_growing();

    const exhibit::State& state() const { return state_; }
    const exhibit::Timings& timings() const { return pace_.now(); }
    const nursery::Act& on_stage() const;  // may be empty, before the very first four have grown
    std::span<const genome::Recipe> recipes_on_stage() const { return programme_.recipes_of(state_.screen); }
    const std::optional<stage::Flash>& last_press() const { return last_press_; }
    int visits_ended() const { return diary_.visits_ended(); }
    // In words, "" where the genome has none: after a round what the next four lean toward, at the end what was bred.
    std::string caption() const;
    // Where the landscape that was bred can be had, as the site says; "" where it says nothing.
    std::string take_home() const;
    bool take_postcard_wish() { return std::exchange(bred_.wants_postcard, false); }
    // The language that the screen speaks.
    const std::string& shown_language(base::Instant now) const { return spoken_.shown(state_.screen, now); }
    bool can_go_back() const;
    // As stage::asked_of, and in Slide.
    std::optional<stage::Asked> asked() const;
    // What is to be heard of it, but for how it is pressed.
    hearing::Subject heard(base::Instant now) const;

    // From now on everything waits so many times as long as the site says.
    void wait_longer(double times) { pace_.wait_longer(times); }
    // What the site has changed while we run: timings, rounds and language.
    void follow(const site::Configuration& configuration);
    // Keeps a short text for the next run, in place of the one under the same name.
    void remember(const std::string& name, std::string text) { diary_.remember(name, std::move(text)); }
    std::string state_trouble() { return diary_.trouble(); }  // why what visitors do is not being kept, or ""

  private:
    void step(exhibit::Step step, base::Instant now);
    void carry_out(const exhibit::Acknowledge& wish, base::Instant now);
    void carry_out(const exhibit::PrepareVisit& wish, base::Instant now);
    void carry_out(const exhibit::BeginVisit& wish, base::Instant now);
    void carry_out(const exhibit::KeepAnswers& wish, base::Instant now);
    void carry_out(const exhibit::GrowNext& wish, base::Instant now);
    void carry_out(const exhibit::UndoRound& wish, base::Instant now);
    void carry_out(const exhibit::GrowFinale& wish, base::Instant now);
    void carry_out(const exhibit::TurnSlider& wish, base::Instant now);
    void carry_out(const exhibit::UndoTurn& wish, base::Instant now);
    void carry_out(const exhibit::KeepWord& wish, base::Instant now);
    void carry_out(const exhibit::EndVisit& wish, base::Instant now);
    void carry_out(const exhibit::SpeakLanguage& wish, base::Instant now);
    void carry_out(const exhibit::ReturnTo& wish, base::Instant now);
    void carry_out(const exhibit::BreedOn& wish, base::Instant now);
    void carry_out(const exhibit::PrintPostcard& wish, base::Instant now);

    bool take_up(base::Instant now);
    void resume(const archive::Generation& kept, base::Instant now);
    bool is_sliding() const { return timings().asking == exhibit::Asking::Sliders; }
    void grow_offer(int generation, learning::Keeper::Ticket kept);
    void keep_answers(const genome::Pick& answers);
    void ask_about_another();
    void begin_to_describe(base::Instant now);

    exhibit::State state_;
    Pace pace_;
    learning::NightSchool school_;
    learning::Founder founder_;
    learning::Lineages lineages_;
    learning::Diary diary_;
    Programme programme_;
    stage::Spoken spoken_;
    std::optional<stage::Flash> last_press_;
    std::string caption_;
    Bred bred_;
    std::size_t others_described_ = 0;  // instead of what was bred, ever
    Wanted wanted_;
};

}  // namespace quadrat::kiosk
