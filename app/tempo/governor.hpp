// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <array>
#include <bitset>
#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "tempo/full_rate_probe.hpp"

// Detail that holds the frame: watches whether frames reach the screen in time, never how long a GPU says it took (a
// Raspberry Pi's clock follows its load), and turns one knob, the level: alpha, and below 0.3 the size of the views
// too. There is a floor: what has less detail than that is no picture any more, and frames are shown more seldom, but
// evenly, rather than it.
namespace quadrat::tempo {

struct GovernorOptions {
    float most = 1;  // level; what the site asks for
    float start = 1;
    int periods = 1;  // display refresh periods per frame, initially
    int samples = 1;  // a pixel, at the start; more than 1: edges are smooth
    static constexpr float kLeast = 0.12F;
    static constexpr int kMostPeriods = 4;  // a frame: 15 a second of a screen that shows 60
};

// What is drawn with when the governor is at this level: less geometry first, then also smaller views, for trees of a
// handful of leaves are worse than soft ones.
float alpha_for(float level);
float scale_for(float level);  // of a side of each view

class DetailGovernor {
  public:
    using Instant = std::chrono::nanoseconds;

    // A share of the frame time. A frame that is drawn within it leaves room for more detail, unless frames have been
    // late in the last minutes.
    static constexpr float kRoom = 0.7F;

    explicit DetailGovernor(const GovernorOptions& options);

    struct FrameTold {
        Instant now{0};
        Instant took{0};                     // since the frame before it
        Instant period{0};                   // the screen's; above 0
        float share_of_frame_time_used = 1;  // when it was drawn, 0 to 1; over kRoom counts as 1
        bool is_growing = false;             // landscapes grow meanwhile, on the same cores
    };
    void frame(const FrameTold& told);
    void follow(float most);  // the site changed its mind
    // Of a pixel: what the GPU and the site allow. None of its own accord until it is told.
    void allow_samples(int most);
    // The next frame is the first of other landscapes: what could be seen to change may change with it. Edges are
    // smooth from then on where all that is asked for has been drawn in less than half of the time.
    void other_landscapes(Instant now);
    // The next frame is the first of other landscapes, or the first while some grow: less is drawn of it already, not
    // only once it was late.
    void lower_in_advance() { recovered_ = std::min(recovered_, growing_share_); }

    // Somebody waits for landscapes that grow, or are brought to the GPU: the next ones are left more of the machine.
    void kept_waiting();

    // For the next frame. Moves without steps that could be seen; gives way at once while something grows.
    float level() const {
        return std::max(shown_ * (is_growing_ ? growing_share_ : recovered_), std::min(GovernorOptions::kLeast, most_));
    }
    // How many of the screen's periods a frame is meant to take: 1, or up to 4 while the machine cannot do better.
    int periods() const { return periods_; }
    int samples() const { return samples_; }
    // To start with another time.
    float settled() const { return target_; }
    // Why it changed its mind last; once.
    std::optional<std::string> take_reason();

  private:
    static constexpr std::size_t kWindow = 32;      // frames
    static constexpr std::size_t kTooManyLate = 3;  // of them
    static constexpr int kAlone = 8;                // frames: what comes so seldom is not for what is drawn

    bool is_hiccup(const FrameTold& told) const;
    void note_lateness(const FrameTold& told);
    bool is_unsettled(const FrameTold& told) const;
    bool follows_screen(const FrameTold& told);
    void glide(const FrameTold& told);
    void yield_a_little(const FrameTold& told);
    void give_way(const FrameTold& told);
    void try_more(const FrameTold& told);
    void look_back(const FrameTold& told);
    void change_periods(int periods, Instant now);
    void give_up_smooth_edges(const FrameTold& told);
    void say(std::string_view why, float before, const FrameTold& told);
    void begin_anew(Instant now);
    void begin_calm(Instant now);

    float most_;
    float target_;
    float shown_;          // follows target_
    float growing_share_;  // of it, while landscapes grow
    float recovered_ = 1;  // comes back from growing_share_
    bool is_growing_ = false;
    int periods_ = 1;
    Instant period_{0};  // the screen's
    int samples_ = 1;
    int most_samples_ = 1;
    bool has_room_for_smooth_edges_ = false;
    Instant rough_until_{0};                      // at least
    Instant rough_for_{std::chrono::minutes{5}};  // the next time
    FullRateProbe full_rate_probe_;
    std::bitset<kWindow> late_;  // the last frames, the newest first
    // The longest of the late ones, longest first: were the last of these in time, they would not be too many.
    std::array<Instant, kTooManyLate> late_took_{};
    int frames_since_hiccup_ = kAlone;  // at most this
    std::optional<Instant> last_now_;
    Instant calm_since_{0};
    Instant changed_at_{0};
    float room_ = kRoom;         // share of the frame time; a late frame lowers it, and it comes back within minutes
    float least_by_ones_ = 0;    // level: single late frames take no more
    int first_frames_left_ = 0;  // of other landscapes
    int frames_with_room_ = 0;
    int frames_with_much_room_ = 0;
    int frames_calm_ = 0;
    std::optional<Instant> raised_at_;
    float before_raise_ = 1;
    Instant patience_{std::chrono::seconds{4}};
    Instant at_least_since_{0};
    std::string reason_;
};

}  // namespace quadrat::tempo
