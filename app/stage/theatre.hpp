// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "display/display.hpp"
#include "machine/low_priority.hpp"
#include "nursery/act.hpp"
#include "nursery/growing.hpp"
#include "pictures/album.hpp"
#include "render/glimpse.hpp"
#include "render/renderer.hpp"
#include "stage/gpu_benchmark.hpp"
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
    float growing_progress = 0;     // of what Breed waits for, 0 to 1
    std::string_view caption = {};  // may be empty
    std::string_view take_home = {};
    std::string_view language = {};  // that is spoken now; "": the site's
    base::Instant now{0};
};

// The show on a GPU: owns everything that dies with a GL context, and makes it again when the context changes.
class Theatre {
  public:
    explicit Theatre(const site::Configuration& configuration) : configuration_(configuration) {}

    // Call first in a frame. A canvas without a context has no GPU: the rest then does nothing.
    void enter(const display::Canvas& canvas);
    bool has_gpu() const { return renderer_ != nullptr; }

    // How much is brought to the GPU in a frame.
    struct Haste {
        std::size_t bytes;               // about
        std::function<bool()> has_time;  // asked before each piece; none: always
        int scenes = 1;                  // are finished, at most
        bool may_wait = false;           // for what is still worked out beside the frames

        static Haste everything() { return {static_cast<std::size_t>(-1), {}, 1000, true}; }
    };
    // Whether somebody waits for what is brought: what is worked out for it beside the frames else runs when nothing
    // else would.
    void set_awaited(bool is_awaited) { preparing_.set_awaited(is_awaited); }
    // Uploads some of what is missing of this act; true when all of it is there, or there is no GPU.
    bool prepare(const nursery::Act& act, const Haste& haste);
    // The same for what may be needed of an act to come; held as long as it is asked for.
    void prepare_ahead(const nursery::Prospect& prospect, const Haste& haste);
    std::size_t scenes_ahead() const { return uploaded_ahead_.size(); }  // that are there
    // Frees what no act needs.
    void keep_only(const std::vector<const nursery::Act*>& acts);

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

    // A moment as it would be with other settings, drawn over the canvas before the frame itself is.
    mesh::Image sketch(const Moment& moment, const display::Canvas& canvas, const Over& over,
                       const site::Configuration& configuration);

  private:
    StageView view_of(const Moment& moment, const Cast& cast, const Over& over) const;
    Cast cast_of(const nursery::Act& act) const;

    const site::Configuration& configuration_;
    std::uint32_t context_ = 0;
    std::unique_ptr<render::Renderer> renderer_;
    std::unique_ptr<Stage> stage_;
    std::unique_ptr<render::Glimpse> glimpse_;
    bool is_rehearsed_ = false;
    std::optional<render::Detail> detail_;
    render::Frame drawn_;  // last, without its views and signs
    // A scene is held as long as what was made of it: its address stays its own.
    struct Uploaded {
        std::shared_ptr<const scene::Scene> scene;
        std::shared_ptr<const render::GpuScene> gpu;
    };
    using OnGpu = std::map<const scene::Scene*, Uploaded>;
    OnGpu uploaded_;
    OnGpu uploaded_ahead_;
    // What needs no GPU is worked out beside the frames; at most so many at once, for their memory.
    static constexpr std::size_t kMostAhead = 4;
    template <typename Upload>
    struct Uploading {
        std::unique_ptr<Upload> upload;
        std::future<void> prepared;  // last: it waits for its thread
        bool is_done = false;

        Uploading(std::unique_ptr<Upload> upload_, machine::BackgroundThreads& threads);
        bool is_prepared() const;
        // True when all of it is there.
        bool advance(const Haste& haste);
    };
    struct SceneUploading {
        std::shared_ptr<const scene::Scene> scene;
        Uploading<render::SceneUpload> uploading;
    };
    struct GroundUploading {
        scene::Ground ground;
        Uploading<render::Upload> uploading;
    };
    void begin_uploads(const nursery::Scenes& scenes, bool may_wait);
    bool bring(const std::shared_ptr<const scene::Scene>& scene, OnGpu& to, const Haste& haste);
    bool prepare_grounds(const std::vector<scene::Ground>& grounds, const Haste& haste);
    bool stands(const scene::Scene& scene, const Haste& haste);
    machine::BackgroundThreads preparing_;  // before those whose threads are in it
    std::vector<SceneUploading> uploading_;
    std::vector<GroundUploading> ahead_;
};

// What the exhibit shows of an act: the picture that an album keeps.
pictures::Picture picture_of(const nursery::Act& act, const display::Canvas& canvas,
                             const site::Configuration& configuration);

}  // namespace quadrat::stage
