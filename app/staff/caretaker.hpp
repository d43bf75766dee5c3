// SPDX-License-Identifier: Apache-2.0
// The room `staff`: what the people of the house see and ask for. Health, the service screen, opening and closing, safe
// mode, evidence of faults. Nothing here knows what a visit is about: it is told whether there is one.
#pragma once
#include <deque>
#include <functional>
#include <mutex>
#include <optional>

#include "base/worker.hpp"
#include "display/display.hpp"
#include "machine/heap.hpp"
#include "mesh/image.hpp"
#include "site/hours.hpp"
#include "staff/attendant.hpp"
#include "staff/evidence.hpp"
#include "staff/ladder.hpp"
#include "staff/panel.hpp"
#include "staff/postcards.hpp"
#include "staff/service_screen.hpp"
#include "staff/settings_in_use.hpp"
#include "staff/vitals.hpp"
#include "staff/watch.hpp"

namespace quadrat::staff {

struct CaretakerParts {
    site::Configuration& configuration;  // follows its files and the theme of the day, as far as a running exhibit can
    site::Settings settings;             // that it began with, without a theme, and the file it follows
    std::filesystem::path runtime;       // health, requests and pictures; memory, not disk, where there is a service
    std::filesystem::path state;
    Ladder& ladder;
    const display::Display& screen;  // which GPU and mode that is, is asked when it is told: they come and go
    std::function<void(site::Configuration&)> adjust =
        {};                       // to what the command line says, whatever the file does; or null
    std::string theme = {};       // of the day it began on
    bool keeps_settings = false;  // that have proved themselves, for starts with worse ones
};

// Everything about the exhibit that is not the visit: opening hours, the service screen, health, requests, a changed
// configuration, pictures of faults. No call waits for a disk.
class Caretaker : public Attendant {
  public:
    explicit Caretaker(const CaretakerParts& parts);

    [[nodiscard]] Orders look(Panel& panel, const VisitNow& visit, base::Instant now) override;
    bool take_edge(const firmware_io::ButtonEdge& edge, base::Instant now) override;
    void framed(const display::Presented& presented, base::Instant now, const DrawnWith& drawn) override;
    void step_figures() override { figures_ = static_cast<Figures>((static_cast<int>(figures_) + 1) % 3); }

    site::Curtain curtain() const override { return curtain_; }
    const stage::Board* board() const override { return board_ ? &*board_ : nullptr; }
    std::optional<firmware_io::Lamps> lamps(base::Instant now) const override;
    // That it has not the site's settings; or "".
    std::string sign() const override {
        return settings_.needs_sign() ? site::text(parts_.configuration, "settings") : "";
    }
    bool wants_restart() const override { return wants_restart_; }

    std::optional<PreviewWish> take_preview_wish(bool has_visitor) override;
    std::string take_picture_wish() override;
    void keep_bred(mesh::Image&& picture, const std::string& code, const std::string& title) override;
    void keep_picture(mesh::Image&& picture, const std::filesystem::path& file) override;
    void wish_postcard(const std::string& title, const std::string& code, const std::string& language) override {
        postcards_.wish(title, code, language);
    }
    void look_at_postcards(stage::Theatre& theatre, const nursery::Act& finale,
                           const display::Canvas& canvas) override {
        postcards_.look(theatre, finale, canvas);
    }

  private:
    void look_outside(base::Instant now);
    bool take_over(Seen seen);
    void tell_clock(const site::WallClock& wall);
    void answer_picture_wish();
    void answer_glance_wish();
    bool take_over(Seen::Changed changed);
    bool follow_theme();
    std::string put_on_theme();
    void keep_proved_settings(base::Instant now);
    void raise_curtain(bool has_visitor, base::Instant now);
    void watch_faults(base::Instant now);
    void report(base::Instant now);
    void climb(bool has_visitor, base::Instant now);
    Vitals vitals(const Panel& panel, const VisitNow& visit, base::Instant now) const;
    void carry_out(StaffWish wish);
    void ask_for_power(const char* what);
    void keep_evidence(const mesh::Image& picture, base::Instant now);

    CaretakerParts parts_;
    Watch watch_;                      // used by the errands' thread alone
    Evidence evidence_;                // likewise
    site::Configuration plain_;        // as the settings say it, without a theme
    std::string theme_;                // that is shown
    std::vector<std::string> guests_;  // that other exhibits share
    site::Doorkeeper doorkeeper_;
    ServiceScreen service_;
    SettingsInUse settings_;
    FrameCount frames_;
    Seen seen_;
    Vitals vitals_;
    site::Curtain curtain_ = site::Curtain::Open;
    std::optional<stage::Board> board_;
    std::string screen_trouble_;
    std::optional<PreviewWish> preview_wish_;
    std::optional<std::string> preview_waits_;  // why, as was told of it; "": it does not
    std::deque<std::string> picture_wishes_;    // names of files
    std::size_t faults_ = 0;                    // warnings seen so far
    std::optional<base::Instant> faulted_at_;   // when a picture of a fault was last kept
    int fault_pictures_ = 0;
    std::optional<base::Instant> looked_at_, shown_since_, reported_at_, remembered_at_, drawn_at_;
    std::optional<base::Instant> told_at_, pictured_at_;  // to who asked from afar
    std::optional<base::Instant> tests_lamps_until_;
    bool has_looked_ = false;
    DrawnWith drawn_;  // the last frame
    enum class Figures { None, Shown, WithWires } figures_ = Figures::None;
    bool is_good_ = false;
    bool wants_restart_ = false;
    std::mutex mutex_;
    std::optional<Seen> fresh_;  // from the errands' thread
    machine::TimesToTidy times_to_tidy_;
    Postcards postcards_{parts_.configuration};
    // Files, mostly. While the disk hangs, what comes too much is refused.
    base::Worker errands_{{.name = "errands",
                           .bound = 9,
                           .when_full = base::WorkerOptions::WhenFull::Refuse,
                           .at_end = base::WorkerOptions::AtEnd::Drop}};  // last: it ends before what it uses
};

}  // namespace quadrat::staff
