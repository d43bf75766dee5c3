// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <memory>

#include "display/display.hpp"
#include "kiosk/album.hpp"
#include "kiosk/show.hpp"
#include "kiosk/stage.hpp"
#include "render/renderer.hpp"

namespace quadrat::kiosk {

// The show on a GPU: owns everything that dies with a GL context, and makes it again when the context changes.
class Theatre {
  public:
    explicit Theatre(const Configuration& configuration) : configuration_(configuration) {}

    // Call first in a frame. A canvas without a context has no GPU: the rest then does nothing.
    void enter(const display::Canvas& canvas);
    bool has_gpu() const { return renderer_ != nullptr; }

    // Uploads about so many bytes of what is missing of this act; true when all of it is there, or there is no GPU.
    bool prepare(const Act& act, std::size_t budget_bytes);
    // Frees what no act needs.
    void keep_only(const std::vector<const Act*>& acts);

    render::Drawn draw(const Show& show, float growing_progress, Instant now, const display::Canvas& canvas);
    // The act as a picture, grown, without words: drawn over the canvas, before the frame itself is.
    mesh::Image photograph(const Act& act, const Picture& picture, const display::Canvas& canvas);

  private:
    Cast cast_of(const Act& act) const;

    const Configuration& configuration_;
    std::uint32_t context_ = 0;
    std::unique_ptr<render::Renderer> renderer_;
    std::unique_ptr<Stage> stage_;
    std::map<const scene::Scene*, std::shared_ptr<const render::GpuScene>> uploaded_;
    const scene::Scene* uploading_scene_ = nullptr;
    std::unique_ptr<render::Upload> uploading_;
};

// What the exhibit shows of an act: the picture that an album keeps.
Picture picture_of(const Act& act, const display::Canvas& canvas, const Configuration& configuration);

}  // namespace quadrat::kiosk
