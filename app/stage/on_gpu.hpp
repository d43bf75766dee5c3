// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "base/worker.hpp"
#include "nursery/act.hpp"
#include "nursery/graph.hpp"
#include "render/renderer.hpp"

namespace quadrat::stage {

// The landscapes on the GPU, and the uploads under way. Each scene is found by its address. bring() is told what is
// wanted, the most urgent first, uploads a slice of it, and frees what is not wanted any more. Use it on the thread of
// the renderer's context, and destroy it before that.
class OnGpu {
  public:
    explicit OnGpu(render::Renderer& renderer) : renderer_(renderer) {}  // borrowed

    // What belongs together. One scene a frame is finished, or all where somebody waits for them.
    struct Batch {
        nursery::Scenes scenes;
        bool is_awaited = false;
    };
    struct Wanted {
        std::vector<Batch> batches;    // each whole before the next begins
        nursery::Scenes held = {};     // stay, if they are there
        nursery::Prospect ahead = {};  // after all batches; their scenes stay too
    };
    // How much is brought in a frame.
    struct Haste {
        std::size_t bytes;               // about
        std::function<bool()> has_time;  // asked before each piece; none: always
        bool may_wait = false;           // for what is still worked out beside the frames

        static Haste everything() { return {static_cast<std::size_t>(-1), {}, true}; }
    };
    // Some of what is missing.
    void bring(const Wanted& wanted, const Haste& haste);
    // Whether somebody waits for what is brought: what is worked out for it beside the frames else runs when nothing
    // else would.
    void set_awaited(bool is_awaited) { preparing_.set_awaited(is_awaited); }

    bool has(const nursery::Scenes& scenes) const;
    std::shared_ptr<const render::GpuScene> find(const scene::Scene& scene) const;  // null where it is not there
    std::size_t size() const { return uploaded_.size(); }                           // scenes

  private:
    // What needs no GPU is worked out beside the frames; at most so many scenes and grounds at once, for their memory.
    static constexpr std::size_t kMostAtOnce = 4;
    template <typename Upload>
    struct Uploading {
        std::unique_ptr<Upload> upload;
        base::Begun<void> prepared;  // last: it waits for its thread
        bool is_done = false;

        Uploading(std::unique_ptr<Upload> upload_, base::Worker& worker);
        bool is_prepared() const { return prepared.is_over(); }
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
    // A scene is held as long as what was made of it: its address stays its own.
    struct Uploaded {
        std::shared_ptr<const scene::Scene> scene;
        std::shared_ptr<const render::GpuScene> gpu;
    };
    bool has(const std::shared_ptr<const scene::Scene>& scene) const { return uploaded_.contains(scene.get()); }
    void free_unwanted(const Wanted& wanted);
    bool bring_batch(const Batch& batch, const Haste& haste);
    bool bring_grounds(const std::vector<scene::Ground>& grounds, const Haste& haste);
    void bring_ahead(const nursery::Prospect& prospect, const Haste& haste);
    void begin_uploads(const nursery::Scenes& scenes, bool may_wait);
    bool bring_one(const std::shared_ptr<const scene::Scene>& scene, const Haste& haste);
    bool stands(const scene::Scene& scene, const Haste& haste);

    render::Renderer& renderer_;
    std::map<const scene::Scene*, Uploaded> uploaded_;
    base::Worker preparing_{{.name = "uploads",
                             .bound = 2 * kMostAtOnce,
                             .priority = base::WorkerOptions::Priority::Background,
                             .threads = 2 * kMostAtOnce}};  // before what it prepares
    std::vector<SceneUploading> uploading_;
    std::vector<GroundUploading> grounds_;  // as long as they are asked for
};

}  // namespace quadrat::stage
