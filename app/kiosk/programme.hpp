// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exhibit/visit.hpp"
#include "learning/keeper.hpp"
#include "nursery/act.hpp"
#include "nursery/gallery.hpp"
#include "nursery/growing.hpp"
#include "nursery/wall.hpp"

namespace quadrat::kiosk {

// Landscapes on their way to the screen.
struct Coming {
    int generation = 0;
    learning::Keeper::Ticket kept = 0;
    bool is_finale = false;
    nursery::Landscapes landscapes = {};
    std::optional<nursery::Act> act = {};  // once it has grown
    bool is_full = false;                  // and that in full light
};

// Which landscapes are shown, which are on their way, and which come back to the gallery when nobody waits: what the
// nursery is asked for. One thread; no call waits, but wait().
class Programme {
  public:
    // works: nobody plays, and these hang; or null.
    Programme(const nursery::NurseryOptions& options, const nursery::Wall::Read& works);

    // In place of what is on its way.
    void order(Coming coming, const std::vector<genome::Candidate>& candidates, base::Seed flight);
    // What may be ordered next, as nursery::Nursery::foresee.
    void foresee(std::function<std::vector<nursery::Want>()> work_out) { nursery_.foresee(std::move(work_out)); }

    // Once a frame: takes over what has grown.
    void look();
    void wait();  // until nothing grows that is on its way; and takes it over

    const std::optional<Coming>& coming() const { return coming_; }
    float progress() const { return coming_ ? nursery_.progress() : 0.0F; }  // of it, 0 to 1; 0 where nothing is
    bool has_progressed();                                                   // since this was asked last
    bool is_growing() const { return nursery_.stock().is_busy; }

    // What is on its way and has grown, but is not on the GPU; or null. Once it is there, say uploaded(): it is shown
    // then, and grows in from `arrived`. A finale hangs from then on, with its birth.
    const nursery::Act* waiting_for_upload() const { return coming_ && coming_->act ? &*coming_->act : nullptr; }
    Coming uploaded(base::Instant arrived, const nursery::Birth& birth);
    // Has grown in full light and is not on the GPU: what is shown in first light, or what comes back to the gallery,
    // or what will be asked about; or null. Once it is there, say note_refined().
    const nursery::Act* waiting_to_refine() const { return refined_ ? &*refined_ : nullptr; }
    void note_refined();
    // Nothing is shown in first light that will be replaced by full light.
    bool has_nothing_to_refine() const { return !refined_ && (coming_ || is_full_); }
    // What has grown of the landscapes that may come: may be brought to the GPU already.
    nursery::Prospect ahead() const { return nursery_.ahead(); }

    // When all else stands a landscape grows that the visitor will be asked about instead of their own; null: none
    // does.
    void ask_about(std::shared_ptr<const nursery::Landscape> other);
    // They are asked now. What this gives is shown in Describe from now on: what has grown so far, or null: the finale.
    const nursery::Landscape* begin_asking(base::Instant now);

    // A visit begins, and needs the room of all but the newest of the gallery; its four grow in.
    void begin_visit(base::Instant now);
    void choose(nursery::Chosen chosen);  // of no effect on a wall, which has its works
    void open_gallery(base::Instant now);
    // Somebody has come, to breed on from what is shown now or not.
    void leave_gallery(bool breeds_on, base::Instant now);
    const std::string& liked() const { return liked_; }  // the code of what they breed on from; "": of nothing
    void recall(nursery::Collection collection) { gallery_.recall(std::move(collection)); }
    const nursery::Collection& collection() const { return gallery_.collection(); }
    const nursery::Wall* wall() const { return wall_ ? &*wall_ : nullptr; }
    void look_at_wall(base::Instant now);  // once a frame
    // Nobody is there: what a visit had no room for grows again, when all else stands.
    void regrow_gallery();

    const nursery::Act& offered() const { return offered_; }  // the four of this round, or of the visit to come
    const nursery::Act& act_of(exhibit::Screen screen) const;
    std::span<const genome::Recipe> recipes_of(exhibit::Screen screen) const;
    const nursery::Act& gallery() const { return gallery_.act(); }
    nursery::Scenes in_use() const;  // must stay on the GPU

  private:
    // Instead of the finale.
    struct AskedAbout {
        std::shared_ptr<const nursery::Landscape> landscape = {};  // null: the finale is
        std::optional<nursery::Act> act = {};                      // once it has grown
        bool is_shown = false;                                     // in Describe; it has grown then
        bool is_growing() const { return landscape && !act; }
    };

    void want();
    void stop_regrowing();
    // What grows when all else stands; or null.
    std::shared_ptr<const nursery::Landscape> spare() const {
        return asked_about_.is_growing() ? asked_about_.landscape : regrowing_;
    }

    nursery::Nursery nursery_;
    std::optional<Coming> coming_;
    float told_progress_ = 0;
    nursery::Landscapes newest_;  // of the act that was shown last
    bool is_full_ = true;         // it is shown in full light
    std::optional<nursery::Act> refined_;
    nursery::Act offered_;
    nursery::Act finale_;
    nursery::Gallery gallery_;
    std::optional<nursery::Wall> wall_;
    std::string liked_;
    std::shared_ptr<const nursery::Landscape> regrowing_;  // that is missing in the gallery; or null
    AskedAbout asked_about_;
    int acts_ = 0;
};

}  // namespace quadrat::kiosk
