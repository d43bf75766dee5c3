// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "breeding/session.hpp"
#include "exhibit/archive.hpp"
#include "exhibit/visit.hpp"
#include "kiosk/act.hpp"
#include "kiosk/asked.hpp"
#include "kiosk/clock.hpp"
#include "kiosk/configuration.hpp"
#include "kiosk/gallery.hpp"
#include "kiosk/growing.hpp"
#include "kiosk/keeper.hpp"
#include "kiosk/school.hpp"

namespace quadrat::kiosk {

exhibit::Timings timings_of(const Configuration& configuration);
breeding::BreederOptions breeder_options_of(const Configuration& configuration);

struct ShowOptions {
    base::Seed seed;  // names all chance of this run
    GrowerOptions growing;
    std::function<exhibit::WallTime()> wall_time;   // for the archive's rows
    std::function<exhibit::WallTime()> local_time;  // on the site's own clock: when it is night
    std::filesystem::path state;                    // the folder of the word map, beside the archive's file
};

// Landscapes on their way to the screen.
struct Waiting {
    int generation = 0;
    Keeper::Ticket kept = 0;
    std::vector<genome::Recipe> recipes;
    bool is_finale = false;
    std::unique_ptr<Act> act;  // once it has grown
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
    Show(const Configuration& configuration, ShowOptions options, std::unique_ptr<Keeper> keeper);
    Show(const Configuration& configuration, ShowOptions options, exhibit::Archive archive);

    // Takes up the visit that a pulled plug interrupted, or opens with Attract. Where the disk has not told yet whether
    // there is one, Attract too, and the visit is taken up as long as nobody has come meanwhile.
    void open(Instant now);

    void happen(const exhibit::Event& event, Instant now);

    // Landscapes that are grown but not yet on the GPU. Once they are, and are kept too, say uploaded().
    const Act* waiting_for_upload();
    bool is_kept_within(std::chrono::nanoseconds patience);  // or the disk had time enough
    void uploaded(Instant now);

    // The act that was uploaded last, in its own light instead of a first, coarse one, where it has not grown so
    // already; or what comes back to the gallery. Once it is on the GPU too, say refined().
    const Act* waiting_to_refine();
    void refined();
    bool is_refined() { return !refined_ && !grower_.is_refining(); }  // nothing is shown in a first light

    // What has grown of the landscapes that may come: may be brought to the GPU already.
    Prospect ahead() { return grower_.ahead(); }

    // Blocks until nothing grows and everything is kept: for simulated clocks.
    void finish_growing();

    const exhibit::State& state() const { return state_; }
    const exhibit::Timings& timings() const { return timings_; }
    const Act& on_stage() const;             // may be empty, before the very first four have grown
    std::vector<const Act*> in_use() const;  // whose landscapes must stay on the GPU
    bool is_growing() { return grower_.stock().is_busy; }
    float growing_progress() { return waiting_ ? grower_.progress() : 0.0F; }
    std::optional<exhibit::Choice> last_press() const { return last_press_; }
    Instant last_press_at() const { return last_press_at_; }
    int visits_ended() const { return visits_ended_; }
    // In words, "" where the genome has none: after a round what the next four lean toward, at the end what was bred.
    const std::string& caption() const { return caption_; }
    bool can_go_back() const;
    // In Describe and Slide.
    std::optional<Asked> asked() const;

    // What the site has changed while we run: timings, rounds and language.
    void follow(const Configuration& configuration);
    // Keeps a short text for the next run, in place of the one under the same name.
    void remember(const std::string& name, std::string text);
    std::string state_trouble() const;  // why what visitors do is not being kept, or ""

  private:
    void step(exhibit::Step step, Instant now);
    void carry_out(const exhibit::Acknowledge& wish, Instant now);
    void carry_out(const exhibit::PrepareVisit& wish, Instant now);
    void carry_out(const exhibit::BeginVisit& wish, Instant now);
    void carry_out(const exhibit::KeepAnswers& wish, Instant now);
    void carry_out(const exhibit::GrowNext& wish, Instant now);
    void carry_out(const exhibit::UndoRound& wish, Instant now);
    void carry_out(const exhibit::GrowFinale& wish, Instant now);
    void carry_out(const exhibit::TurnSlider& wish, Instant now);
    void carry_out(const exhibit::UndoTurn& wish, Instant now);
    void carry_out(const exhibit::KeepWord& wish, Instant now);
    void carry_out(const exhibit::EndVisit& wish, Instant now);

    std::string heredity(const genome::Candidate& before, const genome::Candidate& now,
                         const genome::Pick& answers) const;
    bool take_up(Instant now);
    bool resume(const exhibit::Generation& kept, Instant now);
    std::string why_not_resumed(const exhibit::Generation& kept, const breeding::WordMap& map);
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
    exhibit::Generation generation_of(const genome::Pick& answers) const;

    exhibit::Timings timings_;
    breeding::BreederOptions breeder_options_;
    std::vector<genome::Aspect> locked_;
    ShowOptions options_;
    exhibit::State state_;
    bool has_asked_keeper_ = false;  // what the last run left
    std::optional<breeding::Session> session_;
    std::vector<exhibit::Deed> deeds_;  // of the session, from its first four to those of now
    std::uint64_t sessions_ = 0;
    std::shared_ptr<std::int64_t> visit_;  // its number in the archive, written and read by the keeper's thread
    std::optional<Waiting> waiting_;
    float progress_ = 0;  // of what is waited for, as the visit was last told
    std::optional<Act> refined_;
    Act offered_;  // the four of this round, or of the visit to come
    Act finale_;
    Gallery gallery_;
    bool is_regrowing_ = false;  // what is missing in it; nothing else grows then
    int acts_ = 0;
    int visits_ended_ = 0;
    std::optional<exhibit::Choice> last_press_;
    Instant last_press_at_{0};
    Bred bred_;
    std::shared_ptr<School> school_;
    std::int64_t studied_night_ = 0;
    Keeper::Ticket study_ = 0;
    std::unique_ptr<Keeper> keeper_;
    Grower grower_;
    bool is_in_fleet_;  // visits are kept for whoever publishes them
    std::string language_;
    std::string caption_;
};

}  // namespace quadrat::kiosk
