// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "archive/archive.hpp"
#include "base/clock.hpp"
#include "breeding/session.hpp"
#include "exhibit/visit.hpp"
#include "hearing/narrator.hpp"
#include "kiosk/keeper.hpp"
#include "kiosk/school.hpp"
#include "kiosk/show_settings.hpp"
#include "nursery/act.hpp"
#include "nursery/gallery.hpp"
#include "nursery/growing.hpp"
#include "site/configuration.hpp"
#include "stage/asked.hpp"
#include "stage/spoken.hpp"

namespace quadrat::kiosk {

struct ShowOptions {
    base::Seed seed;  // names all chance of this run
    nursery::GrowerOptions growing;
    std::function<archive::WallTime()> wall_time;   // for the archive's rows
    std::function<archive::WallTime()> local_time;  // on the site's own clock: when it is night
    std::filesystem::path state;                    // the folder of the word map, beside the archive's file
};

// Landscapes on their way to the screen.
struct Waiting {
    int generation = 0;
    Keeper::Ticket kept = 0;
    std::vector<genome::Recipe> recipes;
    bool is_finale = false;
    std::unique_ptr<nursery::Act> act;  // once it has grown
};

// A landscape that was bred, while it is asked about.
struct Bred {
    genome::Recipe recipe;
    std::optional<genome::Description> words;
    std::vector<genome::WordId> asked;  // one after another
};

// Carries out what the exhibit wishes: breeds, keeps, grows; at its start and every night, has the word map trained on
// what visitors said, for the visits to come. Knows nothing of GL, of displays and of where presses
// come from. One thread; no call waits, but finish_growing().
class Show {
  public:
    Show(const site::Configuration& configuration, ShowOptions options, std::unique_ptr<Keeper> keeper);
    Show(const site::Configuration& configuration, ShowOptions options, archive::Archive archive);

    // Takes up the visit that a pulled plug interrupted, or opens with Attract. Where the disk has not told yet whether
    // there is one, Attract too, and the visit is taken up as long as nobody has come meanwhile.
    void open(base::Instant now);

    void happen(const exhibit::Event& event, base::Instant now);

    // Landscapes that are grown but not yet on the GPU. Once they are, and are kept too, say uploaded().
    const nursery::Act* waiting_for_upload();
    bool is_kept_within(std::chrono::nanoseconds patience);  // or the disk had time enough
    void uploaded(base::Instant now);

    // The act that was uploaded last, in its own light instead of a first, coarse one, where it has not grown so
    // already; or what comes back to the gallery. Once it is on the GPU too, say refined().
    const nursery::Act* waiting_to_refine();
    void refined();
    bool is_refined() { return !refined_ && !grower_.is_refining(); }  // nothing is shown in a first light

    // What has grown of the landscapes that may come: may be brought to the GPU already.
    nursery::Prospect ahead() { return grower_.ahead(); }

    // Blocks until nothing grows and everything is kept: for simulated clocks.
    void finish_growing();

    const exhibit::State& state() const { return state_; }
    const exhibit::Timings& timings() const { return timings_; }
    const nursery::Act& act_of(exhibit::Screen screen) const;  // that would be shown on it
    const nursery::Act& on_stage() const;                      // may be empty, before the very first four have grown
    std::span<const genome::Recipe> recipes_on_stage() const;
    std::vector<const nursery::Act*> in_use() const;  // whose landscapes must stay on the GPU
    bool is_growing() { return grower_.stock().is_busy; }
    float growing_progress() { return waiting_ ? grower_.progress() : 0.0F; }
    std::optional<exhibit::Choice> last_press() const { return last_press_; }
    base::Instant last_press_at() const { return last_press_at_; }
    int visits_ended() const { return visits_ended_; }
    // In words, "" where the genome has none: after a round what the next four lean toward, at the end what was bred.
    const std::string& caption() const { return caption_; }
    // Where the landscape that was bred can be had, as the site says; "" where it says nothing.
    const std::string& take_home() const { return take_home_; }
    // The language that the screen speaks.
    const std::string& shown_language(base::Instant now) const { return spoken_.shown(state_.screen, now); }
    bool can_go_back() const;
    // In Describe and Slide.
    std::optional<stage::Asked> asked() const;
    // What is to be heard of it, but for how it is pressed.
    hearing::Subject heard(base::Instant now) const;

    // From now on everything waits so many times as long as the site says.
    void wait_longer(double times);
    // What the site has changed while we run: timings, rounds and language.
    void follow(const site::Configuration& configuration);
    // Keeps a short text for the next run, in place of the one under the same name.
    void remember(const std::string& name, std::string text);
    std::string state_trouble() const;  // why what visitors do is not being kept, or ""

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

    std::string heredity(const genome::Candidate& before, const genome::Candidate& now,
                         const genome::Pick& answers) const;
    bool take_up(base::Instant now);
    bool resume(const archive::Generation& kept, base::Instant now);
    std::string why_not_resumed(const archive::Generation& kept, const breeding::WordMap& map,
                                const breeding::Taste& taste);
    std::vector<genome::WordId> words_to_ask() const;
    void study();
    void study_at_night();
    void regrow_gallery();
    void stop_regrowing();
    bool is_sliding() const { return timings_.asking == exhibit::Asking::Sliders; }
    breeding::Session fresh_session();
    void undo();
    void grow_offer(int generation, Keeper::Ticket kept);
    void keep_answers(const genome::Pick& answers);
    Keeper::Ticket keep_generation(const genome::Pick& answers);
    archive::Generation generation_of(const genome::Pick& answers) const;

    exhibit::Timings usual_timings_;
    exhibit::Timings timings_;  // with the patience of now
    double patience_ = 1;
    breeding::BreederOptions breeder_options_;
    int control_every_;
    std::vector<genome::Aspect> locked_;
    ShowOptions options_;
    exhibit::State state_;
    bool has_asked_keeper_ = false;  // what the last run left
    std::optional<breeding::Session> session_;
    std::vector<archive::Deed> deeds_;  // of the session, from its first four to those of now
    std::uint64_t sessions_ = 0;
    std::shared_ptr<std::int64_t> visit_;  // its number in the archive, written and read by the keeper's thread
    std::optional<Waiting> waiting_;
    float progress_ = 0;  // of what is waited for, as the visit was last told
    std::optional<nursery::Act> refined_;
    nursery::Act offered_;  // the four of this round, or of the visit to come
    nursery::Act finale_;
    nursery::Gallery gallery_;
    bool is_regrowing_ = false;  // what is missing in it; nothing else grows then
    genome::Recipe regrowing_;   // which that is
    int acts_ = 0;
    int visits_ended_ = 0;
    std::optional<exhibit::Choice> last_press_;
    base::Instant last_press_at_{0};
    Bred bred_;
    std::shared_ptr<School> school_;
    std::int64_t studied_night_ = 0;
    Keeper::Ticket study_ = 0;
    std::unique_ptr<Keeper> keeper_;
    nursery::Grower grower_;
    bool is_in_fleet_;  // visits are kept for whoever publishes them
    stage::Spoken spoken_;
    std::string caption_;
    std::string take_home_url_;  // the site's
    bool is_collected_ = false;  // what visitors breed, by its code
    std::string take_home_;
};

}  // namespace quadrat::kiosk
