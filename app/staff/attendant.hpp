// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "display/display.hpp"
#include "firmware-io/lamps.hpp"
#include "hearing/health.hpp"
#include "mesh/image.hpp"
#include "site/hours.hpp"
#include "staff/panel.hpp"
#include "staff/preview_wish.hpp"
#include "stage/board.hpp"

namespace quadrat::nursery {
struct Act;
}
namespace quadrat::stage {
class Theatre;
}

namespace quadrat::staff {

// What is told about the visit to whoever looks after it.
struct VisitNow {
    bool has_visitor = false;
    int visits_ended = 0;
    std::string state_trouble = {};               // why what visitors do is not being kept, or ""
    std::function<hearing::Health()> sound = {};  // asked when it is told; none: nothing is heard
};

// What is left to whoever runs the visit.
struct Orders {
    bool follows_settings = false;              // the configuration has just changed
    std::optional<std::string> buttons_memory;  // to be kept for the next start, see health_memory_from
};

struct DrawnWith {
    float level = 1;  // the governor's
    float alpha = 1;
    float scale = 1;
    int samples = 1;  // a pixel
    int periods = 1;  // of the screen's, that a frame is meant to take
    std::size_t triangles = 0;
    std::size_t draws = 0;
    std::size_t objects = 0;  // of the GPU's, that there are
};

// Looks after the exhibit beside the visit: opening hours, the service screen, health, requests of staff. The methods
// of this class do nothing: the exhibit is always open, and nobody asks for anything. That suits tests and simulated
// clocks; staff::Caretaker does the work.
class Attendant {
  public:
    virtual ~Attendant() = default;

    // Once a frame, after the panel was polled.
    [[nodiscard]] virtual Orders look(Panel&, const VisitNow&, base::Instant) { return {}; }
    // A press or a release; true: it was meant for staff, or woke the exhibit, and is no part of a visit.
    virtual bool take_edge(const firmware_io::ButtonEdge&, base::Instant) { return false; }
    virtual void framed(const display::Presented&, base::Instant, const DrawnWith&) {}
    // Shows how it draws; then its triangles too; then no longer.
    virtual void step_figures() {}

    virtual site::Curtain curtain() const { return site::Curtain::Open; }
    virtual const stage::Board* board() const { return nullptr; }  // what lies over the picture, or null
    virtual std::optional<firmware_io::Lamps> lamps(base::Instant) const { return std::nullopt; }  // not the visit's
    virtual std::string sign() const { return ""; }  // for staff, in a corner of the picture; or ""
    virtual bool wants_restart() const { return false; }

    // Words that staff wish to see, where nobody plays and something is drawn; the picture goes to kPreview.
    virtual std::optional<PreviewWish> take_preview_wish(bool /*has_visitor*/) { return std::nullopt; }
    // The file that a picture of the screen is wished for in, or "".
    virtual std::string take_picture_wish() { return ""; }
    // What visitors bred, for whoever chooses among it: with its code, among those in the runtime folder.
    // And a postcard of it, with these words.
    virtual void keep_bred(mesh::Image&&, const std::string& /*code*/, const std::string& /*title*/) {}
    // A file that is not absolute lies in the runtime folder.
    virtual void keep_picture(mesh::Image&&, const std::filesystem::path&) {}
    // The Finale's landscape on the site's printer: these words, this code, as that language is written.
    virtual void wish_postcard(const std::string& /*title*/, const std::string& /*code*/,
                               const std::string& /*language*/) {}
    // Once a frame, before it is drawn: draws over the canvas once where a postcard was wished for.
    virtual void look_at_postcards(stage::Theatre&, const nursery::Act& /*finale*/, const display::Canvas&) {}
};

}  // namespace quadrat::staff
