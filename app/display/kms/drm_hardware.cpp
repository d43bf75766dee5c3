// SPDX-License-Identifier: Apache-2.0
#include "display/kms/drm_hardware.hpp"

#include <epoxy/gl.h>
#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <utility>

#include "base/log.hpp"
#include "display/kms/edid.hpp"
#include "display/monotonic.hpp"
#include "display/options.hpp"

namespace quadrat::display {
namespace {

constexpr Size kUnseenSize{1280, 720};

void clear_to_black() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

DrmHardware::DrmHardware(const DisplayOptions& options)
    : options_(options), wanted_mode_(mode_from(options.mode, "display mode")) {}

Canvas DrmHardware::canvas() {
    Canvas canvas;
    if (!target_) return canvas;
    canvas.context = target_->context_number();
    canvas.framebuffer = target_->make_current();
    canvas.size = target_->size();
    canvas.is_seen = is_lit_;
    return canvas;
}

std::string DrmHardware::description() const {
    if (!card_) return "no graphics card yet";
    const std::string screen = is_lit_ ? fmt::format("{} {}", connector_name_, mode_name_) : "no screen";
    return fmt::format("{}, {} ({}), {}", target_ ? target_->renderer() : "no GPU", card_->description().driver,
                       card_->description().path, screen);
}

Instant DrmHardware::now() { return monotonic_now(); }

std::vector<News> DrmHardware::wait(Instant at_most) {
    std::array<pollfd, 2> waiting{pollfd{uevents_.descriptor(), POLLIN, 0},
                                  pollfd{card_ ? card_->descriptor() : -1, POLLIN, 0}};
    const timespec timeout{static_cast<time_t>(at_most.count() / 1'000'000'000),
                           static_cast<long>(at_most.count() % 1'000'000'000)};
    std::vector<News> news;
    if (ppoll(waiting.data(), waiting.size(), &timeout, nullptr) <= 0) return news;
    if ((waiting[1].revents & POLLIN) != 0) take_flips(news);
    if ((waiting[0].revents & POLLIN) != 0) take_plugs(news);
    if ((waiting[1].revents & (POLLERR | POLLHUP)) != 0) news.push_back(event::CardRemoved{});
    return news;
}

// The kernel's own format: libdrm's reader wants a callback with a pointer that every commit must have carried.
void DrmHardware::take_flips(std::vector<News>& news) {
    std::array<char, 1024> buffer{};
    const ssize_t size = ::read(card_->descriptor(), buffer.data(), buffer.size());
    for (ssize_t at = 0; at + static_cast<ssize_t>(sizeof(drm_event)) <= size;) {
        drm_event head{};
        std::copy_n(buffer.data() + at, sizeof head, reinterpret_cast<char*>(&head));
        if (head.length < sizeof head) return;
        drm_event_vblank flip{};
        if (head.type == DRM_EVENT_FLIP_COMPLETE && at + static_cast<ssize_t>(sizeof flip) <= size) {
            std::copy_n(buffer.data() + at, sizeof flip, reinterpret_cast<char*>(&flip));
            news.push_back(FlipShown{std::chrono::seconds{flip.tv_sec} + std::chrono::microseconds{flip.tv_usec}});
            if (in_flight_) shown_ = std::exchange(in_flight_, std::nullopt);
        }
        at += head.length;
    }
}

void DrmHardware::take_plugs(std::vector<News>& news) {
    for (const Uevent& uevent : uevents_.take()) {
        const bool is_ours = card_ && card_->description().path == "/dev/" + uevent.node;
        if (uevent.what == CardEvent::Appeared) {
            news.push_back(event::CardAppeared{});
        } else if (uevent.what == CardEvent::Removed && is_ours) {
            news.push_back(event::CardRemoved{});
        } else if (uevent.what == CardEvent::PlugMoved) {
            if (card_) card_->look(Asking::FromMemory);
            const Connector* connector = present_connector();
            news.push_back(event::PlugMoved{is_ours && connector && connector->plug == Plug::Disconnected});
        }
    }
}

const Connector* DrmHardware::present_connector() const {
    if (!card_) return nullptr;
    const auto& connectors = card_->description().connectors;
    const auto found = std::find_if(connectors.begin(), connectors.end(),
                                    [this](const Connector& connector) { return connector.id == connector_; });
    return found == connectors.end() ? nullptr : &*found;
}

std::optional<event::PlugMoved> DrmHardware::glance() {
    if (!card_) return std::nullopt;
    card_->look(Asking::FromMemory);
    const Connector* connector = present_connector();
    if (!connector || connector->plug == Plug::Disconnected) return event::PlugMoved{true};
    if (connector->is_link_bad || fingerprint_of(connector->edid) != edid_) return event::PlugMoved{false};
    return std::nullopt;
}

ProbeResult DrmHardware::probe() {
    is_denied_ = false;
    if (card_) {
        card_->look(Asking::InFull);
        const CardChoice choice = choose_card({&card_->description(), 1}, options_.connector);
        // What this card lacks another may have.
        if (const auto* chosen = std::get_if<ChosenConnector>(&choice); chosen != nullptr && chosen->warning.empty())
            return remember(card_->description().connectors[chosen->connector]);
    }
    return probe_every_card();
}

// Every card but ours is opened for the length of the question; ours stays open, and with it all that lives on its GPU.
ProbeResult DrmHardware::probe_every_card() {
    std::vector<std::unique_ptr<DrmCard>> opened;
    std::vector<Card> cards;
    for (const std::string& path : card_paths()) {
        const bool is_ours = card_ && card_->description().path == path;
        opened.push_back(is_ours ? nullptr : std::make_unique<DrmCard>(path));
        cards.push_back(is_ours ? card_->description() : opened.back()->description());
        Card& card = cards.back();
        if (!is_ours && card.problem.empty() && !card.connectors.empty() && !opened.back()->take_master())
            card.problem = "is drawn on by another program (a desktop? a second exhibit?)";
        is_denied_ = is_denied_ || !card.problem.empty();
    }
    const CardChoice choice = choose_card(cards, options_.connector);
    if (const auto* none = std::get_if<NoCard>(&choice)) return NothingFound{none->reason, is_denied_};
    const auto* dark = std::get_if<NoScreen>(&choice);
    const std::size_t index = dark ? dark->card : std::get<ChosenConnector>(choice).card;
    const bool is_another = opened[index] != nullptr;
    if (is_another && (!card_ || !dark)) {  // a card is left only for one that has a screen
        close_card();
        card_ = std::move(opened[index]);
    }
    std::string why;
    if (!open_target(why)) {
        const std::string reason = fmt::format("{} ({}): {}", cards[index].path, cards[index].driver, why);
        close_card();
        return NothingFound{reason, false};
    }
    if (dark) return CardFound{dark->reason};
    const auto& chosen = std::get<ChosenConnector>(choice);
    if (!chosen.warning.empty() && warned_ != chosen.warning) base::log::warn("screen: {}", chosen.warning);
    warned_ = chosen.warning;
    return remember(cards[index].connectors[chosen.connector]);
}

bool DrmHardware::open_target(std::string& why) {
    if (!target_)
        target_ = GbmTarget::open(card_->descriptor(), options_.size == Size{} ? kUnseenSize : options_.size, why);
    return target_ != nullptr;
}

ScreenFound DrmHardware::remember(const Connector& connector) {
    const std::uint64_t edid = fingerprint_of(connector.edid);
    const bool is_news = connector_ != connector.id || edid != edid_;
    const auto read = read_edid(connector.edid);
    ladder_ = mode_ladder(connector.modes, wanted_mode_, options_.size);
    if (is_news && !ladder_.warning.empty()) base::log::warn("screen: {}", ladder_.warning);
    for (const std::string& fault : read&& is_news ? read->faults : std::vector<std::string>{})
        base::log::warn("screen: in its EDID, {}", fault);
    connector_ = connector.id;
    edid_ = edid;
    connector_name_ = connector.name;
    return {connector.id, fmt::format("{}, {}", connector.name, identity_of(read)), edid, connector.is_link_bad,
            static_cast<int>(ladder_.rungs.size())};
}

// With the layouts the plane knows the GPU can compress what it draws; a driver that promises one and then refuses it
// gets a plain buffer instead.
Refusal DrmHardware::modeset(int rung) {
    if (!card_ || !target_) return Refusal::NoDevice;
    if (!card_->take_master()) return Refusal::NoAccess;
    const auto modes = card_->modes_of(connector_);
    const Rung& step = ladder_.rungs.at(static_cast<std::size_t>(rung));
    output_ = AtomicOutput::choose(card_->descriptor(), connector_);
    if (!output_ || step.mode >= modes.size()) return Refusal::Invalid;
    const drmModeModeInfo& mode = modes[step.mode];
    Refusal refusal = Refusal::Invalid;
    if (!output_->modifiers().empty()) refusal = show_first(mode, step.draw, output_->modifiers());
    if (refusal == Refusal::Invalid || refusal == Refusal::NoRoom) refusal = show_first(mode, step.draw, {});
    if (refusal != Refusal::None) return refusal;
    const double hz = refresh_hz_of(mode);
    period_ = Instant{hz > 0.0 ? static_cast<Instant::rep>(1e9 / hz) : 0};
    mode_name_ = fmt::format("{}x{}@{:.2f}", mode.hdisplay, mode.vdisplay, hz);
    if (step.draw != Size{mode.hdisplay, mode.vdisplay})
        mode_name_ += fmt::format(", drawn at {}x{}", step.draw.width, step.draw.height);
    is_lit_ = true;
    base::log::info("screen: {} {}", connector_name_, mode_name_);
    return Refusal::None;
}

Refusal DrmHardware::show_first(const drmModeModeInfo& mode, Size draw, const std::vector<std::uint64_t>& modifiers) {
    drop_frames();
    if (!target_->make_surface(draw, modifiers)) return Refusal::NoRoom;
    clear_to_black();
    int error_number = 0;
    auto first = target_->take_frame(error_number);
    if (first) error_number = output_->set_mode(mode, draw, first->framebuffer());
    if (error_number == 0) {
        shown_ = std::move(first);
        return Refusal::None;
    }
    first.reset();
    target_->drop_surface();
    return refusal_of(error_number);
}

std::optional<Refusal> DrmHardware::flip() {
    if (!target_ || !target_->has_surface() || !output_) return Refusal::Invalid;
    if (!drawn_) {
        int error_number = 0;
        drawn_ = target_->take_frame(error_number);
        if (!drawn_ && error_number == EIO) return std::nullopt;
        if (!drawn_) return refusal_of(error_number);
    }
    const Refusal refusal = refusal_of(output_->flip(drawn_->framebuffer()));
    if (refusal == Refusal::None) in_flight_ = std::exchange(drawn_, std::nullopt);
    return refusal;
}

// What the card still has to say about frames in flight is read and dropped, so that it is never taken for a later one.
void DrmHardware::disable() {
    if (output_ && card_) {
        const int refusal = output_->disable();
        if (refusal != 0) base::log::warn("screen: it cannot be switched off ({})", std::strerror(refusal));
        std::vector<News> dropped;
        pollfd waiting{card_->descriptor(), POLLIN, 0};
        while (poll(&waiting, 1, 0) == 1 && (waiting.revents & POLLIN) != 0) take_flips(dropped);
    }
    drop_frames();
    if (target_) target_->drop_surface();
    output_.reset();
    is_lit_ = false;
}

void DrmHardware::drop_frames() {
    drawn_.reset();
    in_flight_.reset();
    shown_.reset();
}

void DrmHardware::close_card() {
    drop_frames();
    output_.reset();
    target_.reset();
    card_.reset();
    is_lit_ = false;
    connector_ = 0;
    edid_ = 0;
}

}  // namespace quadrat::display
