// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <memory>
#include <optional>

#include "display/display.hpp"
#include "nursery/act.hpp"
#include "nursery/growing.hpp"
#include "pictures/album.hpp"
#include "render/glimpse.hpp"
#include "render/renderer.hpp"
#include "stage/gpu_benchmark.hpp"
#include "stage/miniatures.hpp"
#include "stage/on_gpu.hpp"
#include "stage/stage.hpp"

namespace quadrat::stage {

// What the visit shows at a moment.
struct Moment {
    const exhibit::State& state;
    const exhibit::Timings& timings;
    const nursery::Act& act;
    std::optional<Flash> flash;  // of the last press
    std::optional<Asked> asked;  // in Describe and Slide
    std::optional<Scanned> scanned = {};
    float growing_progress = 0;  // of what Breed waits for, 0 to 1
    std::string caption = {};    // may be empty
    std::string take_home = {};
    std::string_view language = {};  // that is spoken now; "": the site's
    base::Instant now{0};
};

// The show on a GPU: owns everything that dies with a GL context, and makes it again when the context changes.
class Theatre {
  public:
    enum class Frames { InTime, AtAnyTime };  // none waits for a small picture; or none can come late
    explicit Theatre(const site::Configuration& configuration, Frames frames = Frames::InTime)
        : configuration_(configuration), frames_(frames) {}

    // Call first in a frame. A canvas without a context has no GPU: the rest then does nothing.
    void enter(const display::Canvas& canvas);
    bool has_gpu() const { return renderer_ != nullptr; }

    // What of the landscapes lies on the GPU; where there is one.
    OnGpu& on_gpu() { return *on_gpu_; }
    // Whether all of an act can be drawn; where there is no GPU, it is as if it could.
    bool has(const nursery::Act& act) const { return !has_gpu() || on_gpu_->has(act.scenes); }

    // What lies over the show, and what is shown in place of landscapes that are not there; both may be null.
    struct Over {
        const Board* board = nullptr;
        const mesh::Image* backdrop = nullptr;
        std::string sign = {};  // for staff, in a corner; may be empty
    };
    render::Drawn draw(const Moment& moment, const display::Canvas& canvas, const Over& over);
    // What was drawn last, as the panel has it; an empty image where nothing was.
    mesh::Image read_back();
    // The same at most so wide, without waiting for it: asked for here, it comes some frames later. False: nothing was
    // begun.
    bool begin_glimpse(int most_width);
    std::optional<mesh::Image> take_glimpse();  // once a frame
    // To draw with; what is configured, until somebody governs. Pictures that are kept have what is configured.
    void set_detail(const render::Detail& detail) { detail_ = detail; }
    render::Detail detail() const { return detail_.value_or(render::Detail{}); }
    // Waits so long at most for the last frame to be drawn; true when it is.
    bool is_drawn_within(std::chrono::nanoseconds patience) {
        return !has_gpu() || renderer_->is_done_within(patience);
    }
    // Of a pixel: what the GPU and the site allow.
    int most_samples() const;
    // Draws the act, to be drawn over, in the next way of a benchmark that is not over; the profile when it is. Nothing
    // is drawn until the whole act is on the GPU, which is there.
    std::optional<tempo::GpuProfile> try_out(GpuBenchmark& benchmark, const nursery::Act& act,
                                             const display::Canvas& canvas);
    // What the canvas's context has not drawn yet it draws once, to be drawn over. Not before there was a frame: the
    // first one is not to wait for it.
    void rehearse(const display::Canvas& canvas);
    // The act as a picture, grown, without words: drawn over the canvas, before the frame itself is.
    mesh::Image photograph(const nursery::Act& act, const pictures::Picture& picture, const display::Canvas& canvas);

    // One landscape for paper, without words, without waiting for it: asked for here, drawn over the canvas before the
    // frame itself is, it comes some frames later. As large as that, or as the canvas has room for. False: nothing was
    // begun.
    bool begin_portrait(const nursery::Act& act, glm::ivec2 size, const display::Canvas& canvas);
    std::optional<mesh::Image> take_portrait();  // once a frame

    // A moment as it would be with other settings, drawn over the canvas before the frame itself is.
    mesh::Image sketch(const Moment& moment, const display::Canvas& canvas, const Over& over,
                       const site::Configuration& configuration);

  private:
    StageView view_of(const Moment& moment, const Cast& cast, const Over& over) const;
    Cast cast_of(const nursery::Act& act) const;
    bool begin_plain(render::Glimpse& glimpse, const Cast& cast, glm::ivec2 size, const display::Canvas& canvas);
    void keep_miniature(const Moment& moment, const Cast& cast, const display::Canvas& canvas);

    const site::Configuration& configuration_;
    Frames frames_;
    std::uint32_t context_ = 0;
    std::unique_ptr<render::Renderer> renderer_;
    std::unique_ptr<OnGpu> on_gpu_;
    std::unique_ptr<Stage> stage_;
    // Of the screen, of what a visit has seen, of what goes on paper.
    std::unique_ptr<render::Glimpse> glimpse_, miniature_, portrait_;
    Miniatures miniatures_;
    std::optional<Miniatures::Due> miniature_due_;  // on its way
    bool is_rehearsed_ = false;
    std::optional<render::Detail> detail_;
    render::Frame drawn_;  // last, without its views and signs
};

// What the exhibit shows of an act: the picture that an album keeps.
pictures::Picture picture_of(const nursery::Act& act, const display::Canvas& canvas,
                             const site::Configuration& configuration);

}  // namespace quadrat::stage
