// SPDX-License-Identifier: Apache-2.0
#include "staff/caretaker.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "machine/heap.hpp"
#include "machine/version.hpp"
#include "pictures/picture.hpp"
#include "pictures/png_picture.hpp"
#include "staff/landscapes.hpp"
#include "staff/postcards.hpp"

namespace quadrat::staff {
namespace {

using namespace std::chrono_literals;

constexpr base::Instant kLookEvery = 500ms;
constexpr base::Instant kReportEvery = 60s;
constexpr base::Instant kAnswerEvery = 900ms;  // whoever asks for a picture or for health, and however often
constexpr base::Instant kLampTest = 12s;
constexpr base::Instant kFirstReport = 3s;  // after the first frame: then there is something to tell
constexpr base::Instant kRememberEvery = 1h;
constexpr base::Instant kServiceEvery = 250ms;  // the service screen's figures
constexpr base::Instant kFaultPictureEvery = 600s;
constexpr int kFaultPictures = 4;
constexpr std::string_view kFaultPicture = "fault-";

bool is_of_a_fault(const std::filesystem::path& file) { return file.string().starts_with(kFaultPicture); }

bool is_due(std::optional<base::Instant>& last, base::Instant every, base::Instant now) {
    if (last && now - *last < every) return false;
    last = now;
    return true;
}

// Health that cannot be written is no reason to say so every minute: whoever collects it notices that it is old.
void write_quietly(const std::filesystem::path& file, const std::string& text) {
    try {
        base::write_file(file, text);
    } catch (const base::InputError& error) {
        base::log::debug("health: {}", error.what());
    }
}

}  // namespace

Caretaker::Caretaker(const CaretakerParts& parts)
    : parts_(parts),
      watch_(parts.settings.file, parts.settings.held, parts.runtime, parts.state),
      evidence_(parts.state),
      plain_(parts.settings.configuration),
      theme_(parts.theme),
      settings_(parts.settings) {
    doorkeeper_.follow(parts_.configuration.hours, parts_.configuration.closing);
    seen_.wall.is_trusted = false;  // until it was looked at
    faults_ = base::recent_warnings().count;
}

Orders Caretaker::look(Panel& panel, const VisitNow& visit, base::Instant now) {
    Orders orders;
    look_outside(now);
    if (auto fresh = [&] {
            const std::scoped_lock lock(mutex_);
            return std::exchange(fresh_, std::nullopt);
        }())
        orders.follows_settings = take_over(std::move(*fresh));
    if (panel.take_chord()) {
        base::log::info("staff: the service screen is opened");
        service_.open(now);
    }
    raise_curtain(visit.has_visitor, now);
    watch_faults(now);
    keep_proved_settings(now);
    const bool has_news = has_looked_ && shown_since_ && now >= *shown_since_ + kFirstReport;
    const bool is_asked = std::exchange(seen_.is_health_asked, false) && is_due(told_at_, kAnswerEvery, now);
    const bool is_reporting = has_news && (is_due(reported_at_, kReportEvery, now) || is_asked);
    const bool is_drawing =
        (service_.is_open(now) || figures_ != Figures::None) && is_due(drawn_at_, kServiceEvery, now);
    if (is_reporting || is_drawing) vitals_ = vitals(panel, visit, now);
    if (is_reporting) report(now);
    if (times_to_tidy_.is_due(visit.visits_ended, now)) errands_.send([] { machine::tidy_memory(); });
    if (!remembered_at_) remembered_at_ = now;  // what was read at the start is on the disk already
    if (is_due(remembered_at_, kRememberEvery, now)) orders.buttons_memory = to_text(panel.health().memory());
    if (service_.is_open(now))
        board_ = service_.board(vitals_, now);
    else if (curtain_ == site::Curtain::Card)
        board_ =
            stage::Board{site::text(parts_.configuration, "closed"), {}, stage::Board::Cover::Tint, false, "closed"};
    else if (figures_ != Figures::None)
        board_ = figures_board(vitals_, figures_ == Figures::WithWires);
    else
        board_.reset();
    climb(visit.has_visitor, now);
    return orders;
}

void Caretaker::look_outside(base::Instant now) {
    if (!is_due(looked_at_, kLookEvery, now)) return;
    errands_.send([this, now] {
        Seen seen = watch_.look();
        evidence_.look(base::recent_warnings(), now);
        seen.earlier_faults = evidence_.earlier();
        const std::scoped_lock lock(mutex_);
        // A look that nobody has taken up yet may have seen what this one does not see any more.
        if (fresh_ && !seen.settings) seen.settings = std::move(fresh_->settings);
        if (fresh_ && !seen.guests) seen.guests = std::move(fresh_->guests);
        if (fresh_ && !seen.preview) seen.preview = std::move(fresh_->preview);
        if (fresh_ && fresh_->is_restart_asked) seen.is_restart_asked = true;
        if (fresh_ && fresh_->is_lamp_test_asked) seen.is_lamp_test_asked = true;
        fresh_ = std::move(seen);
    });
}

// True: the configuration is another.
bool Caretaker::take_over(Seen seen) {
    tell_clock(seen.wall);
    if (seen.stands_by != seen_.stands_by) {
        base::log::info("staff: {}", seen.stands_by ? "stand-by" : "no longer on stand-by");
        reported_at_.reset();
    }
    if (seen.projector != seen_.projector) reported_at_.reset();
    seen_ = std::move(seen);
    has_looked_ = true;
    if (seen_.preview) {
        preview_wish_ = std::exchange(seen_.preview, std::nullopt);
        preview_waits_.reset();
    }
    if (seen_.is_picture_asked) answer_picture_wish();
    if (seen_.is_glance_asked) answer_glance_wish();
    if (seen_.is_restart_asked) carry_out(StaffWish::Restart);
    if (seen_.is_lamp_test_asked) {
        base::log::info("staff: the lamps are tested");
        tests_lamps_until_ = looked_at_.value_or(base::Instant{0}) + kLampTest;
    }
    auto changed = std::exchange(seen_.settings, std::nullopt);
    const bool has_guests = seen_.guests.has_value();
    if (has_guests) guests_ = *std::exchange(seen_.guests, std::nullopt);
    if (changed) return take_over(std::move(*changed));
    if (!has_guests) return follow_theme();
    if (plain_.fleet.takes == "all")
        base::log::info("attract: shows {} landscapes that other exhibits share", guests_.size());
    put_on_theme();
    return true;
}

// True: the day, or the clock that tells it, leads to another theme.
bool Caretaker::follow_theme() {
    if (plain_.themes.empty() || site::theme_on(plain_, site::day_on(seen_.wall)) == theme_) return false;
    put_on_theme();
    return true;
}

// The keys that only a restart takes over.
std::string Caretaker::put_on_theme() {
    const std::string before = std::exchange(theme_, site::theme_on(plain_, site::day_on(seen_.wall)));
    if (before != theme_) {
        base::log::info("theme: {}", theme_.empty() ? "none" : theme_);
        reported_at_.reset();
    }
    site::Configuration shown = site::with_theme(plain_, theme_);
    if (plain_.fleet.takes == "all") shown.attract.guests = guests_;
    return apply(shown, parts_.configuration);
}

bool Caretaker::take_over(Seen::Changed changed) {
    if (!changed.checked.is_usable()) {
        for (const site::Mistake& mistake : changed.checked.mistakes)
            base::log::error("configuration: {}; the exhibit goes on as it was", to_text(mistake));
        settings_.refuse(std::move(changed.checked.mistakes));
        return false;
    }
    if (parts_.adjust) parts_.adjust(changed.checked.configuration);
    plain_ = std::move(changed.checked.configuration);
    const std::string later = put_on_theme();
    settings_.follow(std::move(changed.toml), later);
    doorkeeper_.follow(parts_.configuration.hours, parts_.configuration.closing);
    base::log::info("configuration: read anew{}", later.empty() ? "" : "; after a restart also: " + later);
    reported_at_.reset();
    return true;
}

void Caretaker::keep_proved_settings(base::Instant now) {
    const bool is_shown = shown_since_ && screen_trouble_.empty() && curtain_ != site::Curtain::Dark;
    auto proved = settings_.take_proved(now, is_shown);
    if (!proved || !parts_.keeps_settings) return;
    errands_.send([state = parts_.state, toml = std::move(*proved)] {
        try {
            site::keep_last_good(state, toml);
            base::log::info("configuration: kept as the last that worked");
        } catch (const base::InputError& error) {
            base::log::warn("configuration: it cannot be kept as the last that worked: {}", error.what());
        }
    });
}

// Staff ask for the log when an exhibit was dark, or was not: what it took for the time is there.
void Caretaker::tell_clock(const site::WallClock& wall) {
    const bool is_news = !has_looked_ || wall.source != seen_.wall.source || wall.zone != seen_.wall.zone ||
                         wall.is_trusted != seen_.wall.is_trusted;
    if (!is_news) return;
    reported_at_.reset();
    if (wall.is_trusted)
        base::log::info("clock: {}, {}", site::time_text(wall), wall.source);
    else
        base::log::info("clock: {}, not trusted: {}; {}", site::time_text(wall), wall.doubt, wall.remedy);
}

// A dark screen draws nothing that a picture could be taken of.
void Caretaker::answer_picture_wish() {
    if (!is_due(pictured_at_, kAnswerEvery, *looked_at_)) return;  // the next look finds it again
    if (curtain_ != site::Curtain::Dark || board_) {
        if (picture_wishes_.empty()) picture_wishes_.emplace_back(kPicture);
        return;
    }
    errands_.send([runtime = parts_.runtime, why = site::opening_text(parts_.configuration.hours, seen_.wall)] {
        write_quietly(runtime / kNoPicture, why + "\n");
        std::error_code ignored;
        std::filesystem::remove(runtime / kPictureAsked, ignored);
    });
}

void Caretaker::answer_glance_wish() {
    if (!is_due(pictured_at_, kAnswerEvery, *looked_at_)) return;
    if (curtain_ != site::Curtain::Dark || board_) {
        if (picture_wishes_.empty()) picture_wishes_.emplace_back(kGlance);
        return;
    }
    errands_.send([runtime = parts_.runtime] {
        std::error_code ignored;
        std::filesystem::remove(runtime / kGlance, ignored);
        std::filesystem::remove(runtime / kGlanceAsked, ignored);
    });
}

void Caretaker::raise_curtain(bool has_visitor, base::Instant now) {
    const site::Curtain before =
        std::exchange(curtain_, doorkeeper_.look(now, seen_.wall, has_visitor, seen_.stands_by));
    if (before == curtain_) return;
    reported_at_.reset();
    constexpr const char* kWords[] = {"open", "closing: the card is shown", "closed: the screen is switched off"};
    base::log::info("hours: {}", kWords[static_cast<std::size_t>(curtain_)]);
}

bool Caretaker::take_edge(const firmware_io::ButtonEdge& edge, base::Instant now) {
    if (edge.motion == firmware_io::Motion::Down) doorkeeper_.pressed(now);
    if (service_.is_open(now)) {
        if (edge.motion == firmware_io::Motion::Down)
            if (const auto wish = service_.press(edge.button, now)) carry_out(*wish);
        drawn_at_.reset();
        return true;
    }
    return curtain_ != site::Curtain::Open;
}

void Caretaker::carry_out(StaffWish wish) {
    switch (wish) {
        case StaffWish::Picture:
            picture_wishes_.emplace_back("staff.png");
            break;
        case StaffWish::Restart:
            base::log::info("staff: restart");
            wants_restart_ = true;
            break;
        case StaffWish::ShutDown:
            base::log::info("staff: shut down");
            ask_for_power("poweroff");
            break;
    }
}

void Caretaker::ask_for_power(const char* what) {
    errands_.send(
        [file = parts_.runtime / kPowerAsked, word = std::string(what)] { write_quietly(file, word + "\n"); });
}

void Caretaker::framed(const display::Presented& presented, base::Instant now, const DrawnWith& drawn) {
    drawn_ = drawn;
    for (const tempo::FrameRecord& record : presented.finished) frames_.frame(record);
    if (!shown_since_) shown_since_ = now;
    const bool is_fine = presented.outcome == display::Outcome::Shown || presented.outcome == display::Outcome::Off;
    screen_trouble_ = is_fine ? "" : presented.reason;
}

std::optional<firmware_io::Lamps> Caretaker::lamps(base::Instant now) const {
    if (tests_lamps_until_ && now < *tests_lamps_until_) return lamp_test(now);
    if (board_ && board_->cover == stage::Board::Cover::All) return service_.lamps(now);
    if (curtain_ != site::Curtain::Open) return firmware_io::Lamps{};
    return std::nullopt;
}

void Caretaker::watch_faults(base::Instant now) {
    const std::size_t faults = base::recent_warnings().count;
    if (faults == std::exchange(faults_, faults)) return;
    reported_at_.reset();
    if (faulted_at_ && now - *faulted_at_ < kFaultPictureEvery) return;
    faulted_at_ = now;
    picture_wishes_.push_back(fmt::format("{}{}.png", kFaultPicture, fault_pictures_++ % kFaultPictures + 1));
}

std::optional<PreviewWish> Caretaker::take_preview_wish(bool has_visitor) {
    const bool is_dark = curtain_ == site::Curtain::Dark;
    const std::string why = !preview_wish_ ? "" : is_dark ? "dark" : has_visitor ? "visitor" : "";
    if (why != std::exchange(preview_waits_, why))
        errands_.send([file = parts_.runtime / kPreviewWaits, why] {
            std::error_code ignored;
            try {
                why.empty() ? void(std::filesystem::remove(file, ignored)) : base::write_file(file, why);
            } catch (const base::InputError& error) {
                base::log::debug("preview: {}", error.what());
            }
        });
    if (!why.empty()) return std::nullopt;
    return std::exchange(preview_wish_, std::nullopt);
}

std::string Caretaker::take_picture_wish() {
    if (picture_wishes_.empty()) return {};
    std::string wish = std::move(picture_wishes_.front());
    picture_wishes_.pop_front();
    return wish;
}

void Caretaker::keep_picture(mesh::Image&& picture, const std::filesystem::path& file) {
    errands_.send([this, at = looked_at_.value_or(base::Instant{0}), runtime = parts_.runtime, file,
                   picture = std::move(picture)] {
        try {
            std::error_code exists;
            std::filesystem::create_directories((runtime / file).parent_path(), exists);
            const bool is_small = (file == kGlance || file == kPreview) && picture.width > kGlanceWidth;
            pictures::write_png_quickly(runtime / file,
                                        is_small ? pictures::scaled_to(picture, kGlanceWidth) : picture);
            if (is_of_a_fault(file)) keep_evidence(picture, at);
        } catch (const base::InputError& error) {
            base::log::info("picture: {}", error.what());
        }
        std::error_code ignored;
        if (file == kPicture) std::filesystem::remove(runtime / kPictureAsked, ignored);
        if (file == kGlance) std::filesystem::remove(runtime / kGlanceAsked, ignored);
    });
}

void Caretaker::keep_bred(mesh::Image&& picture, const std::string& code, const std::string& title) {
    const site::Configuration& site = parts_.configuration;
    pictures::Postcard card = blank_card(site, title, site.take_home.url + code, site.visit.language);
    errands_.send([folder = parts_.runtime / kBredLately, picture = std::move(picture), code,
                   card = std::move(card)]() mutable {
        try {
            keep_landscape(folder, picture, code, kMostBredLately);
            card.landscape = pictures::filling_postcard(picture);
            pictures::write_png_quickly(folder / (id_of_landscape(code) + kPostcard), pictures::draw_postcard(card));
        } catch (const base::InputError& error) {
            base::log::info("picture: {}", error.what());
        }
    });
}

void Caretaker::keep_evidence(const mesh::Image& picture, base::Instant now) {
    evidence_.look(base::recent_warnings(), now);  // it is a picture of a fault that is listed
    evidence_.keep_picture(picture, std::chrono::system_clock::now());
}

Vitals Caretaker::vitals(const Panel& panel, const VisitNow& visit, base::Instant now) const {
    Vitals vitals;
    vitals.version = machine::version();
    vitals.mode = parts_.ladder.rung().mode;
    vitals.is_safe_as_wished = parts_.ladder.rung().is_wished;
    vitals.failures = parts_.ladder.rung().failures;
    vitals.running = std::chrono::duration_cast<std::chrono::seconds>(now);
    vitals.machine = seen_.machine;
    vitals.display = parts_.screen.description();
    vitals.screen_trouble = screen_trouble_;
    vitals.curtain = curtain_;
    vitals.wall = seen_.wall;
    const site::Hours& hours = parts_.configuration.hours;
    vitals.has_hours = !hours.is_always_open;
    vitals.stands_by = seen_.stands_by;
    vitals.is_open = !seen_.stands_by && (!seen_.wall.is_trusted || site::is_open(hours, seen_.wall));
    vitals.opening = seen_.stands_by ? "on stand-by, as staff asked" : site::opening_text(hours, seen_.wall);
    vitals.frames = frames_;
    vitals.level = drawn_.level;
    vitals.alpha = drawn_.alpha;
    vitals.scale = drawn_.scale;
    vitals.samples = drawn_.samples;
    vitals.triangles = drawn_.triangles;
    vitals.draws = drawn_.draws;
    vitals.gpu_objects = drawn_.objects;
    vitals.buttons = panel.status();
    vitals.presses = panel.presses();
    vitals.findings = panel.health().findings();
    vitals.ailments = panel.health().counts();
    for (std::size_t i = 0; i < vitals.is_closed.size(); ++i) vitals.is_closed[i] = panel.contacts()[i].is_closed;
    vitals.presses_of = panel.presses_of();
    vitals.tests_lamps = (tests_lamps_until_ && now < *tests_lamps_until_) || service_.is_testing_lamps();
    vitals.visits = visit.visits_ended;
    vitals.state_trouble = visit.state_trouble;
    if (visit.sound) vitals.sound = visit.sound();
    vitals.postcard_trouble = postcards_.trouble();
    vitals.projector = seen_.projector;
    vitals.free_mb = seen_.free_mb;
    vitals.faults = base::recent_warnings().lines;
    vitals.settings = settings_.news();
    vitals.theme = theme_;
    vitals.earlier_faults = seen_.earlier_faults;
    return vitals;
}

void Caretaker::report(base::Instant) {
    errands_.send([runtime = parts_.runtime, json = to_json(vitals_), metrics = to_prometheus(vitals_)] {
        write_quietly(runtime / "health.json", json);
        std::error_code ignored;
        std::filesystem::remove(runtime / kHealthAsked, ignored);
        write_quietly(runtime / "quadrat.prom", metrics);
        machine::let_go_of_compilers();
    });
}

// A good hour forgets the reboots; out of safe mode leads a restart, when nobody is there to see it.
void Caretaker::climb(bool has_visitor, base::Instant now) {
    if (is_good_ || now < kGoodRun) return;
    if (parts_.ladder.rung().mode == Mode::Safe && has_visitor) return;
    is_good_ = true;
    errands_.send([&ladder = parts_.ladder] { ladder.note_good_run(); });
    if (parts_.ladder.rung().mode == Mode::Safe && !parts_.ladder.rung().is_wished) {
        base::log::info("safe mode: an hour went well; starting again as usual");
        wants_restart_ = true;
    }
}

}  // namespace quadrat::staff
