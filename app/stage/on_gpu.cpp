// SPDX-License-Identifier: Apache-2.0
#include "stage/on_gpu.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::stage {
namespace {

bool is_among(const nursery::Scenes& scenes, const std::shared_ptr<const scene::Scene>& scene) {
    return std::ranges::find(scenes, scene) != scenes.end();
}

}  // namespace

template <typename Upload>
OnGpu::Uploading<Upload>::Uploading(std::unique_ptr<Upload> upload_, base::Worker& worker)
    : upload(std::move(upload_)), prepared(worker.begin([preparing = upload.get()] { preparing->prepare(); })) {}

template <typename Upload>
bool OnGpu::Uploading<Upload>::advance(const Haste& haste) {
    if (is_done) return true;
    if (!haste.may_wait && !is_prepared()) return false;
    if (prepared.is_something()) prepared.get();
    return is_done = upload->advance(haste.bytes, haste.has_time);
}

bool OnGpu::has(const nursery::Scenes& scenes) const {
    return std::ranges::all_of(scenes, [this](const auto& scene) { return has(scene); });
}

std::shared_ptr<const render::GpuScene> OnGpu::find(const scene::Scene& scene) const {
    const auto found = uploaded_.find(&scene);
    return found == uploaded_.end() ? nullptr : found->second.gpu;
}

void OnGpu::bring(const Wanted& wanted, const Haste& haste) {
    free_unwanted(wanted);
    for (const Batch& batch : wanted.batches)
        if (!bring_batch(batch, haste)) return;
    bring_ahead(wanted.ahead, haste);
}

void OnGpu::free_unwanted(const Wanted& wanted) {
    std::erase_if(uploaded_, [&](const auto& entry) {
        const auto& scene = entry.second.scene;
        return !is_among(wanted.held, scene) && !is_among(wanted.ahead.lit, scene) &&
               std::ranges::none_of(wanted.batches, [&](const Batch& b) { return is_among(b.scenes, scene); });
    });
}

void OnGpu::begin_uploads(const nursery::Scenes& scenes, bool may_wait) {
    // What is no longer wanted goes when its thread is done: no frame waits for it.
    std::erase_if(uploading_, [&](const SceneUploading& u) {
        if (is_among(scenes, u.scene)) return false;
        if (may_wait) u.uploading.prepared.wait();
        return u.uploading.is_prepared();
    });
    for (const auto& scene : scenes) {
        if (uploading_.size() >= kMostAtOnce) return;
        if (has(scene) || std::ranges::find(uploading_, scene, &SceneUploading::scene) != uploading_.end()) continue;
        uploading_.push_back({scene, Uploading<render::SceneUpload>{renderer_.begin_upload(scene), preparing_}});
    }
}

// What was begun ahead of it is finished first, so that it comes once.
bool OnGpu::stands(const scene::Scene& scene, const Haste& haste) {
    return std::ranges::all_of(grounds_, [&](GroundUploading& begun) {
        return begun.ground != scene::Ground{scene.flora, scene.land} || begun.uploading.advance(haste);
    });
}

// True when all of it is there.
bool OnGpu::bring_batch(const Batch& batch, const Haste& haste) {
    for (const auto& scene : batch.scenes)
        if (!has(scene) && !stands(*scene, haste)) return false;
    for (const auto& scene : batch.scenes) {
        if (has(scene)) continue;
        begin_uploads(batch.scenes, haste.may_wait);
        if (!bring_one(scene, haste)) return false;
        if (!batch.is_awaited && !haste.may_wait) break;
    }
    return has(batch.scenes);
}

// Of those whose upload has begun: true when it is there.
bool OnGpu::bring_one(const std::shared_ptr<const scene::Scene>& scene, const Haste& haste) {
    const auto found = std::ranges::find(uploading_, scene, &SceneUploading::scene);
    if (found == uploading_.end()) return false;  // others still hold the threads
    if (!found->uploading.advance(haste)) return false;
    uploaded_[scene.get()] = {scene, found->uploading.upload->take()};
    uploading_.erase(found);
    return true;
}

void OnGpu::bring_ahead(const nursery::Prospect& prospect, const Haste& haste) {
    if (!bring_grounds(prospect.grounds, haste)) return;
    for (;;) {
        begin_uploads(prospect.lit, haste.may_wait);
        // What was begun first: what is lit meanwhile may come before it in the prospect.
        const auto begun =
            std::ranges::find_if(uploading_, [&](const SceneUploading& u) { return is_among(prospect.lit, u.scene); });
        if (begun == uploading_.end()) return;
        const std::shared_ptr<const scene::Scene> scene = begun->scene;
        if (!bring_one(scene, haste) || !haste.has_time || !haste.has_time()) return;
    }
}

// True when all are there.
bool OnGpu::bring_grounds(const std::vector<scene::Ground>& grounds, const Haste& haste) {
    std::erase_if(grounds_, [&](const GroundUploading& g) {
        return g.uploading.is_prepared() && std::ranges::find(grounds, g.ground) == grounds.end();
    });
    for (GroundUploading& begun : grounds_)
        if (!begun.uploading.advance(haste)) return false;  // one after the other: what two share comes once
    const auto under_way = std::ranges::count_if(grounds_, [](const auto& g) { return !g.uploading.is_prepared(); });
    if (under_way >= static_cast<std::ptrdiff_t>(kMostAtOnce)) return false;
    for (const scene::Ground& ground : grounds)
        if (std::ranges::find(grounds_, ground, &GroundUploading::ground) == grounds_.end()) {
            grounds_.push_back({ground, Uploading<render::Upload>{renderer_.begin_upload(ground), preparing_}});
            return false;
        }
    return true;
}

}  // namespace quadrat::stage
