// SPDX-License-Identifier: Apache-2.0
// The room `tempo`: when frames come and how finely they are drawn. Pure: records of frames go in, a plan for the next
// frame comes out; no clock, no display, no GPU. Other rooms use this header, calibration.hpp, memory.hpp and
// frame_record.hpp; the rest is how it is done:
//   governor         the level of detail that holds the frame, and how many refresh periods a frame takes, 1 to 4
//   full_rate_probe  when a frame may take one period less again
//   draw_ahead       whether the display is waited for, or a frame is drawn ahead
//   cadence          when a frame of several periods is handed over
//   upload_slice     how much of a frame goes to uploads
//   budget           a fixed budget instead of the governor
#pragma once
#include <optional>
#include <span>
#include <string>

#include "tempo/budget.hpp"
#include "tempo/cadence.hpp"
#include "tempo/draw_ahead.hpp"
#include "tempo/frame_record.hpp"
#include "tempo/governor.hpp"
#include "tempo/upload_slice.hpp"

namespace quadrat::tempo {

// How the next frame is drawn and handed over, and what uploads may take of the one after it.
struct Plan {
    float level = 1;  // of detail, the governor's; alpha where nobody governs
    Fineness fineness;
    int samples = 1;  // per pixel
    int periods = 1;  // refresh periods of the display that it is meant to take
    HandOver::Then then = HandOver::Then::Wait;
    std::optional<DisplayTime> hand_over_at{};  // not before
    UploadSlices uploads;
    std::string reason{};  // why the governor changed its mind just now, for the log; else ""
};

// What a frame is drawn in the midst of.
struct Circumstances {
    DisplayTime now{};
    nanoseconds period{0};                         // the display's; 0: it has none
    std::optional<DisplayTime> in_flight_since{};  // a frame that was handed over and is not shown yet
    float most_level = 1;                          // what the site asks for
    int most_samples = 1;                          // what the GPU and the site allow; 0: there is no GPU yet
    double pixels = 0;                             // of the views
    std::size_t triangles = 0;                     // of the last frame
    int act = 0;                                   // the number of the landscapes on stage
    bool is_growing = false;                       // landscapes grow meanwhile, on the same cores
    bool is_waited_for = false;                    // by a visitor, for landscapes
    bool were_uploads_awaited = false;             // in this frame
    bool is_judged = true;                         // false: what was tried out, or nobody sees, took its time
};

enum class Governing {
    ByFrames,  // detail follows whether frames are late
    Fixed,     // the configured detail, however long a frame takes
};

struct TempoOptions {
    Governing governing = Governing::ByFrames;
    GovernorOptions detail;
    std::optional<Budget> budget = std::nullopt;  // instead of the governor's detail
};

class Tempo {
  public:
    explicit Tempo(const TempoOptions& options);

    // Call once per frame, after uploads and before drawing, with the frames that have been shown since the last call.
    const Plan& next(std::span<const FrameRecord> shown, const Circumstances& now);
    const Plan& plan() const { return plan_; }

    // The GPU was measured: goes on from there.
    void begin_anew(const GovernorOptions& detail);
    bool is_governed() const { return governing_ == Governing::ByFrames; }
    const DetailGovernor& governor() const { return governor_; }

  private:
    void judge(FrameRecord record, const Circumstances& now);
    void notice_landscapes(const Circumstances& now);
    void plan_detail(const Circumstances& now);
    void plan_hand_over(const Circumstances& now);

    Governing governing_;
    DetailGovernor governor_;
    std::optional<BudgetKeeper> budget_;
    DrawAhead ahead_;
    UploadSlice uploads_;
    Plan plan_;
    std::optional<FrameRecord> last_shown_;
    bool was_growing_ = false;
    bool was_slowed_ = false;  // landscapes grew, or were waited for, when the last frame was planned
    int act_ = 0;
    int frames_waited_ = 0;
};

}  // namespace quadrat::tempo
