// SPDX-License-Identifier: Apache-2.0
#include "stage/theatre.hpp"

#include <algorithm>

#include "machine/heap.hpp"
#include "stage/easel.hpp"
#include "tempo/governor.hpp"

namespace quadrat::stage {

void Theatre::enter(const display::Canvas& canvas) {
    if (canvas.context == context_) return;
    uploading_.clear();
    ahead_.clear();
    uploaded_ahead_.clear();
    uploaded_.clear();
    glimpse_.reset();
    stage_.reset();
    renderer_.reset();
    is_rehearsed_ = false;
    context_ = canvas.context;
    if (context_ == 0) return;
    renderer_ = std::make_unique<render::Renderer>(render::ground_named(configuration_.picture.ground));
    stage_ = std::make_unique<Stage>(*renderer_, configuration_);
    glimpse_ = std::make_unique<render::Glimpse>();
}

template <typename Upload>
Theatre::Uploading<Upload>::Uploading(std::unique_ptr<Upload> upload_, machine::BackgroundThreads& threads)
    : upload(std::move(upload_)), prepared(std::async(std::launch::async, [preparing = upload.get(), &threads] {
          const machine::BackgroundThreads::Stay stay(threads);
          preparing->prepare();
      })) {}

template <typename Upload>
bool Theatre::Uploading<Upload>::is_prepared() const {
    return !prepared.valid() || prepared.wait_for(std::chrono::seconds{0}) == std::future_status::ready;
}

template <typename Upload>
bool Theatre::Uploading<Upload>::advance(const Haste& haste) {
    if (is_done) return true;
    if (!haste.may_wait && !is_prepared()) return false;
    if (prepared.valid()) prepared.get();
    return is_done = upload->advance(haste.bytes, haste.has_time);
}

void Theatre::begin_uploads(const nursery::Scenes& scenes, bool may_wait) {
    // What is no longer wanted goes when its thread is done: no frame waits for it.
    std::erase_if(uploading_, [&](const SceneUploading& u) {
        if (std::ranges::find(scenes, u.scene) != scenes.end()) return false;
        if (may_wait && u.uploading.prepared.valid()) u.uploading.prepared.wait();
        return u.uploading.is_prepared();
    });
    for (const auto& scene : scenes) {
        if (uploading_.size() >= kMostAhead) return;
        if (uploaded_.contains(scene.get()) || uploaded_ahead_.contains(scene.get()) ||
            std::ranges::find(uploading_, scene, &SceneUploading::scene) != uploading_.end())
            continue;
        uploading_.push_back({scene, Uploading<render::SceneUpload>{renderer_->begin_upload(scene), preparing_}});
    }
}

// What was begun ahead of it is finished first, so that it comes once.
bool Theatre::stands(const scene::Scene& scene, const Haste& haste) {
    return std::ranges::all_of(ahead_, [&](GroundUploading& ahead) {
        return ahead.ground != scene::Ground{scene.flora, scene.land} || ahead.uploading.advance(haste);
    });
}

bool Theatre::prepare(const nursery::Act& act, const Haste& haste) {
    if (!has_gpu()) return true;
    for (const auto& scene : act.scenes)
        if (auto ahead = uploaded_ahead_.extract(scene.get())) uploaded_.insert(std::move(ahead));
    for (const auto& scene : act.scenes)
        if (!uploaded_.contains(scene.get()) && !stands(*scene, haste)) return false;
    int finished = 0;
    for (const auto& scene : act.scenes) {
        if (uploaded_.contains(scene.get())) continue;
        begin_uploads(act.scenes, haste.may_wait);
        if (!bring(scene, uploaded_, haste)) return false;
        if (++finished == haste.scenes) break;
    }
    return std::ranges::all_of(act.scenes, [this](const auto& scene) { return uploaded_.contains(scene.get()); });
}

// Of those whose upload has begun: true when it is there.
bool Theatre::bring(const std::shared_ptr<const scene::Scene>& scene, OnGpu& to, const Haste& haste) {
    const auto found = std::ranges::find(uploading_, scene, &SceneUploading::scene);
    if (found == uploading_.end()) return false;  // others still hold the threads
    if (!found->uploading.advance(haste)) return false;
    to[scene.get()] = {scene, found->uploading.upload->take()};
    uploading_.erase(found);
    return true;
}

void Theatre::prepare_ahead(const nursery::Prospect& prospect, const Haste& haste) {
    if (!has_gpu()) return;
    std::erase_if(uploaded_ahead_, [&](const auto& entry) {
        return std::ranges::find(prospect.lit, entry.second.scene) == prospect.lit.end();
    });
    if (!prepare_grounds(prospect.grounds, haste)) return;
    for (;;) {
        begin_uploads(prospect.lit, haste.may_wait);
        // What was begun first: what is lit meanwhile may come before it in the prospect.
        const auto begun = std::ranges::find_if(uploading_, [&](const SceneUploading& u) {
            return std::ranges::find(prospect.lit, u.scene) != prospect.lit.end();
        });
        if (begun == uploading_.end()) return;
        const std::shared_ptr<const scene::Scene> scene = begun->scene;
        if (!bring(scene, uploaded_ahead_, haste) || !haste.has_time || !haste.has_time()) return;
    }
}

// True when all are there.
bool Theatre::prepare_grounds(const std::vector<scene::Ground>& grounds, const Haste& haste) {
    std::erase_if(ahead_, [&](const GroundUploading& a) {
        return a.uploading.is_prepared() && std::ranges::find(grounds, a.ground) == grounds.end();
    });
    for (GroundUploading& ahead : ahead_)
        if (!ahead.uploading.advance(haste)) return false;  // one after the other: what two share comes once
    for (const scene::Ground& ground : grounds)
        if (std::ranges::find(ahead_, ground, &GroundUploading::ground) == ahead_.end()) {
            ahead_.push_back({ground, Uploading<render::Upload>{renderer_->begin_upload(ground), preparing_}});
            return false;
        }
    return true;
}

void Theatre::keep_only(const std::vector<const nursery::Act*>& acts) {
    std::erase_if(uploaded_, [&](const auto& entry) {
        return std::ranges::none_of(acts, [&](const nursery::Act* act) {
            return act != nullptr &&
                   std::ranges::any_of(act->scenes, [&](const auto& scene) { return scene.get() == entry.first; });
        });
    });
}

Cast Theatre::cast_of(const nursery::Act& act) const {
    Cast cast;
    cast.arrived = act.arrived;
    for (const auto& scene : act.scenes) {
        const auto found = uploaded_.find(scene.get());
        if (found == uploaded_.end()) return {{}, act.arrived};  // not whole yet: the stage stays dark
        cast.scenes.push_back({scene, found->second.gpu});
    }
    return cast;
}

StageView Theatre::view_of(const Moment& moment, const Cast& cast, const Over& over) const {
    StageView view{moment.state, moment.timings, cast, moment.flash, moment.growing_progress,
                   moment.now,   moment.caption};
    view.asked = moment.asked ? &*moment.asked : nullptr;
    view.scanned = moment.scanned ? &*moment.scanned : nullptr;
    view.board = over.board;
    view.backdrop = over.backdrop;
    view.sign = over.sign;
    view.take_home = moment.take_home;
    view.language = moment.language;
    return view;
}

render::Drawn Theatre::draw(const Moment& moment, const display::Canvas& canvas, const Over& over) {
    if (!has_gpu()) return {};
    const Cast cast = cast_of(moment.act);
    render::Frame frame = stage_->frame(view_of(moment, cast, over), canvas);
    frame.is_one_of_many = true;
    if (detail_) frame.detail = *detail_;
    drawn_ = {frame.size, frame.hanging, frame.framebuffer, frame.seconds, {}, {}, frame.detail, {}};
    return renderer_->draw(frame);
}

mesh::Image Theatre::sketch(const Moment& moment, const display::Canvas& canvas, const Over& over,
                            const site::Configuration& configuration) {
    if (!has_gpu()) return {};
    const Cast cast = cast_of(moment.act);
    Stage stage(*renderer_, configuration);  // its words are of no use to anybody else
    render::Frame frame = stage.frame(view_of(moment, cast, over), canvas);
    if (detail_) frame.detail = *detail_;
    renderer_->draw(frame);
    return renderer_->read_pixels(frame);
}

void Theatre::rehearse(const display::Canvas& canvas) {
    if (is_rehearsed_ || !has_gpu() || drawn_.size.x == 0) return;
    drawn_.framebuffer = canvas.framebuffer;
    render::Frame like = drawn_;
    like.detail.samples = most_samples();
    renderer_->rehearse(like);
    machine::let_go_of_compilers();  // before the first landscapes take up as much
    is_rehearsed_ = true;
}

int Theatre::most_samples() const {
    return has_gpu() ? std::min(configuration_.picture.samples, renderer_->most_samples()) : 1;
}

std::optional<tempo::GpuProfile> Theatre::try_out(GpuBenchmark& benchmark, const nursery::Act& act,
                                                  const display::Canvas& canvas) {
    const Cast cast = cast_of(act);
    if (cast.scenes.empty()) return std::nullopt;
    render::Frame frame = frame_of(picture_of(act, canvas, configuration_), cast, canvas);
    frame.is_one_of_many = true;  // as the exhibit's are
    benchmark.step(*renderer_, std::move(frame));
    if (!benchmark.is_over()) return std::nullopt;
    return benchmark.profile(*renderer_, static_cast<double>(canvas.size.width) * canvas.size.height);
}

mesh::Image Theatre::read_back() {
    if (!has_gpu() || drawn_.size.x == 0) return {};
    return renderer_->read_pixels(drawn_);
}

bool Theatre::begin_glimpse(int most_width) {
    return has_gpu() && drawn_.size.x > 0 && glimpse_->begin(drawn_, most_width);
}

std::optional<mesh::Image> Theatre::take_glimpse() { return has_gpu() ? glimpse_->take() : std::nullopt; }

mesh::Image Theatre::photograph(const nursery::Act& act, const pictures::Picture& picture,
                                const display::Canvas& canvas) {
    return draw_picture(*renderer_, stage_->writer(), picture, cast_of(act), canvas);
}

pictures::Picture picture_of(const nursery::Act& act, const display::Canvas& canvas,
                             const site::Configuration& configuration) {
    pictures::Picture picture;
    picture.scenes = act.recipes;
    picture.width = canvas.size.width;
    picture.height = canvas.size.height;
    picture.alpha = static_cast<float>(configuration.picture.alpha);
    picture.land_samples = configuration.picture.land_samples;
    picture.ground = render::ground_named(configuration.picture.ground);
    return picture;
}

}  // namespace quadrat::stage
