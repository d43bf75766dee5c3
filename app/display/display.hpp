// SPDX-License-Identifier: Apache-2.0
// The room `display`: something to present frames on. The screen itself (KMS), a window, or none (headless). It gives a
// context to draw with and says when each frame was shown. Nothing here draws or decides when a frame is due (tempo).
#pragma once
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/display_time.hpp"
#include "tempo/frame_record.hpp"

namespace quadrat::display {

struct Size {
    int width = 0;
    int height = 0;
    friend bool operator==(Size, Size) = default;
};
inline constexpr int kLargestSide = 4096;  // the largest texture and scan-out buffer of a Raspberry Pi
inline constexpr int kSmallestSide = 16;

enum class Kind { Auto, Kms, Window, Headless };
enum class Rotation { None, Quarter, Half, ThreeQuarters };  // how the panel hangs, clockwise
enum class Mirroring { None, Mirrored };                     // Mirrored: rear projection
enum class Power { On, Off };

struct Pace {
    double hz = 60;
    std::chrono::nanoseconds from{0};  // after the display was opened
};

struct DisplayOptions {
    Kind kind = Kind::Auto;
    // Pixels to draw. 0x0: the screen's own (kms), the whole monitor (window), 1280x720 (headless).
    // On kms a size other than the mode's is scaled by the display plane, when the plane can, with black bars where its
    // shape is another.
    Size size;
    std::string connector;  // kms: "HDMI-A-1"; empty: the first that has a screen
    std::string mode;       // kms: "1920x1080@60" or "1920x1080"; empty: the screen's own, up to 4096x2160 at 60 Hz
    Rotation rotation = Rotation::None;  // handed on in the Canvas; the projection turns the picture, never the plane
    Mirroring mirroring = Mirroring::None;
    std::string title = "Quadrat";
    // headless: frames reach nobody at these rates, each when it is drawn, as a screen (kms) would take them. None: at
    // once.
    std::vector<Pace> paces;  // in the order of time
};

// "1280x720". Throws InputError naming `what` (an option, a key), the text and the range of what would be right.
Size size_from(std::string_view text, std::string_view what);
// "auto", "kms", "window", "headless". Throws InputError as above.
Kind kind_from(std::string_view text, std::string_view what);
std::string_view name_of(Kind kind);

// What this frame is drawn into. Valid until present().
struct Canvas {
    // A GL context's number, never used twice; it is current on the calling thread. 0: there is no GPU yet (kms before
    // a card appeared), so make and draw nothing. When the number changes, every GL object made before is gone.
    std::uint32_t context = 0;
    std::uint32_t framebuffer = 0;  // to bind before drawing; it has 8 bit RGB(A), depth 24, stencil 8, one sample
    Size size;                      // of that framebuffer
    Rotation rotation = Rotation::None;
    Mirroring mirroring = Mirroring::None;
    bool is_seen = false;  // false: drawing is allowed and lands where nobody sees it (no screen, or switched off)
};

enum class Outcome {
    Shown,     // handed to the screen; nothing is wrong
    NoScreen,  // no card, or no screen on it: the show goes on unseen, and the screen is looked for
    Off,       // switched off by set_power
    Lost,      // the screen did not take the frame; it is being set up again
    Fault      // set up again and again without a picture: ending the process, so that it is restarted, is what is left
};

struct Presented {
    Outcome outcome = Outcome::Shown;
    // The latest frame known to have reached the screen, counting calls of present() from 1, and when it did, on
    // CLOCK_MONOTONIC. A screen that reports nothing (window, headless) counts as reached on return.
    std::uint64_t shown_frame = 0;
    base::DisplayTime shown_at{};
    std::chrono::nanoseconds period{0};  // from one frame of the screen to the next; 0: as fast as the caller draws
    std::string reason{};                // why it was not shown; empty when it was
    // The frames that reached the screen since the last call, in order: what everybody judges frames by.
    std::vector<tempo::FrameRecord> finished{};
    std::optional<base::DisplayTime> in_flight_since{};  // a frame was handed over then and is not shown yet
};

// Keys of a window, for developers and desktops. The exhibit's buttons never come this way.
enum class Key {
    A,
    B,
    C,
    D,
    F,
    H,
    P,
    Q,
    R,
    S,
    One,
    Two,
    Three,
    Four,
    Space,
    Enter,
    Escape,
    Backspace,
    Tab,
    Left,
    Right,
    Up,
    Down,
    F1,
    F2,
    F5,
    F11,
    F12
};
enum class KeyMove { Down, Up };
struct KeyMotion {
    Key key;
    KeyMove move;
    std::chrono::nanoseconds at;  // CLOCK_MONOTONIC, when the window system told us
    friend bool operator==(const KeyMotion&, const KeyMotion&) = default;
};

// Something to present on. One thread opens, uses and destroys it. After it was opened nothing here throws: a screen
// that goes away is an Outcome.
class Display {
  public:
    explicit Display(std::string why) : why_(std::move(why)) {}
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;
    virtual ~Display() = default;

    virtual std::string_view kind() const = 0;  // "kms", "window", "headless"
    // One line for people: GPU, driver and mode.
    virtual std::string description() const = 0;
    // The GPU alone, as its driver calls it: the same whatever its card's number is and whatever is plugged in. ""
    // before there is one.
    virtual std::string renderer() const = 0;
    // One line for people: what Auto chose and why not the others.
    const std::string& why() const { return why_; }

    // The canvas that begin_frame will give, as far as is known now; its context is current on this thread.
    virtual Canvas canvas() const = 0;
    // Call before any GL of the frame. Takes what the window system or the kernel has to tell.
    virtual Canvas begin_frame() = 0;
    // Hands the frame over, not before `how` says, and waits on a screen for this frame or the one before it to be
    // shown (tempo::HandOver::Then). Headless waits where it has paces.
    virtual Presented present(const tempo::HandOver& how) = 0;
    // The same, as soon as it can be.
    Presented present() { return present(tempo::HandOver{}); }
    // What time it is on the clock that frames are timed by.
    virtual base::DisplayTime now() const;

    // Off: the screen is switched off for real (kms) or no longer drawn on.
    virtual void set_power(Power power) = 0;
    // Keys that moved since the last call, in order. Empty where keys are not ours to read (kms, headless).
    virtual std::vector<KeyMotion> take_keys() { return {}; }
    virtual bool wants_to_close() const { return false; }

    std::uint32_t framebuffer() const { return canvas().framebuffer; }
    Size size() const { return canvas().size; }

  private:
    std::string why_;
};

// Auto takes the first that works: kms, when a card with a screen can be mastered; a window, when DISPLAY or
// WAYLAND_DISPLAY leads to a desktop; headless. Kms asked for by name may start without card or screen and waits for
// them. Throws InputError, naming the remedy, for options out of range and for a kind that cannot work here.
std::unique_ptr<Display> open_display(const DisplayOptions& options);

}  // namespace quadrat::display
