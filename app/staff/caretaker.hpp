// SPDX-License-Identifier: Apache-2.0
// The room `staff`: what the people of the house see and ask for. Health, the service screen, opening and closing, safe
// mode, evidence of faults. Nothing here knows what a visit is about: it is told whether there is one.
#pragma once
#include <deque>
#include <functional>
#include <mutex>
#include <optional>

#include "display/display.hpp"
#include "hearing/health.hpp"
#include "machine/heap.hpp"
#include "mesh/image.hpp"
#include "site/hours.hpp"
#include "staff/errands.hpp"
#include "staff/evidence.hpp"
#include "staff/ladder.hpp"
#include "staff/panel.hpp"
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

// What the caretaker is told about the visit.
struct VisitNow {
    bool has_visitor = false;
    int visits_ended = 0;
    std::string state_trouble = {};  // why what visitors do is not being kept, or ""
    hearing::Health sound = {};
};

// What the caretaker leaves to whoever runs the visit.
struct Orders {
    bool follows_settings = false;              // the configuration has just changed
    std::optional<std::string> buttons_memory;  // to be kept for the next start, see health_memory_from
};

// Everything about the exhibit that is not the visit: opening hours, the service screen, health, requests, a changed
// configuration, pictures of faults. No call waits for a disk.
class Caretaker {
  public:
    explicit Caretaker(const CaretakerParts& parts);

    // Once a frame, after the panel was polled.
    [[nodiscard]] Orders look(Panel& panel, const VisitNow& visit, base::Instant now);
    // A press or a release; true: it was meant for staff, or woke the exhibit, and is no part of a visit.
    bool hear(const firmware_io::ButtonEdge& edge, base::Instant now);
    struct DrawnWith {
        float level;  // the governor's
        float alpha;
        float scale;
        int samples;  // a pixel
        int periods;  // of the screen's, that a frame is meant to take
        std::size_t triangles;
        std::size_t draws;
        std::size_t objects;  // of the GPU's, that there are
    };
    void framed(const display::Presented& presented, base::Instant now, const DrawnWith& drawn);
    // Shows how it draws; then its triangles too; then no longer.
    void step_figures() { figures_ = static_cast<Figures>((static_cast<int>(figures_) + 1) % 3); }

    site::Curtain curtain() const { return curtain_; }
    const stage::Board* board() const { return board_ ? &*board_ : nullptr; }  // what lies over the picture, or null
    std::optional<firmware_io::Lamps> lamps(base::Instant now) const;          // instead of the visit's
    // For staff, in a corner of the picture: that it has not the site's settings; or "".
    std::string sign() const { return settings_.needs_sign() ? site::text(parts_.configuration, "settings") : ""; }
    bool wants_restart() const { return wants_restart_; }

    // Words that staff wish to see, where nobody plays and something is drawn; the picture goes to kPreview.
    std::optional<PreviewWish> take_preview_wish(bool has_visitor);
    // The file that a picture of the screen is wished for in, or "".
    std::string take_picture_wish();
    // What visitors bred, for whoever chooses among it: with its code, among those in the runtime folder.
    void keep_bred(mesh::Image picture, std::string code);
    // A file that is not absolute lies in the runtime folder.
    void keep_picture(mesh::Image picture, const std::filesystem::path& file);

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
    Watch watch_;                // used by the errands' thread alone
    Evidence evidence_;          // likewise
    site::Configuration plain_;  // as the settings say it, without a theme
    std::string theme_;          // that is shown
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
    std::deque<std::string> picture_wishes_;   // names of files
    std::size_t faults_ = 0;                   // warnings seen so far
    std::optional<base::Instant> faulted_at_;  // when a picture of a fault was last kept
    int fault_pictures_ = 0;
    std::optional<base::Instant> looked_at_, shown_since_, reported_at_, remembered_at_, drawn_at_;
    std::optional<base::Instant> told_at_, pictured_at_;  // to who asked from afar
    std::optional<base::Instant> tests_lamps_until_;
    bool has_looked_ = false;
    DrawnWith drawn_{1, 1, 1, 1, 1, 0, 0, 0};  // the last frame
    enum class Figures { None, Shown, WithWires } figures_ = Figures::None;
    bool is_good_ = false;
    bool wants_restart_ = false;
    std::mutex mutex_;
    std::optional<Seen> fresh_;  // from the errands' thread
    machine::TimesToTidy times_to_tidy_;
    Errands errands_;  // last: it ends before what it uses
};

}  // namespace quadrat::staff
