// SPDX-License-Identifier: Apache-2.0
#include "stage/theatre.hpp"

#include <algorithm>
#include <utility>

#include "machine/heap.hpp"
#include "stage/easel.hpp"
#include "tempo/governor.hpp"

namespace quadrat::stage {

void Theatre::enter(const display::Canvas& canvas) {
    if (canvas.context == context_) return;
    on_gpu_.reset();
    glimpse_.reset();
    miniature_.reset();
    portrait_.reset();
    miniature_due_.reset();
    stage_.reset();
    renderer_.reset();
    is_rehearsed_ = false;
    context_ = canvas.context;
    if (context_ == 0) return;
    renderer_ = std::make_unique<render::Renderer>(render::ground_named(configuration_.picture.ground));
    on_gpu_ = std::make_unique<OnGpu>(*renderer_);
    stage_ = std::make_unique<Stage>(*renderer_, configuration_);
    for (auto* glimpse : {&glimpse_, &miniature_, &portrait_}) *glimpse = std::make_unique<render::Glimpse>();
}

Cast Theatre::cast_of(const nursery::Act& act) const {
    Cast cast;
    cast.arrived = act.arrived;
    for (const auto& scene : act.scenes) {
        auto gpu = on_gpu_->find(*scene);
        if (!gpu) return {{}, act.arrived};  // not whole yet: the stage stays dark
        cast.scenes.push_back({scene, std::move(gpu)});
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
    view.miniatures = &miniatures_;
    return view;
}

// As large as there is room for: the picture lies in the canvas's corner until it is drawn over.
bool Theatre::begin_plain(render::Glimpse& glimpse, const Cast& cast, glm::ivec2 size, const display::Canvas& canvas) {
    if (!has_gpu() || cast.scenes.empty() || size.x < 1 || size.y < 1) return false;
    const float room = std::min(static_cast<float>(canvas.size.width) / static_cast<float>(size.x),
                                static_cast<float>(canvas.size.height) / static_cast<float>(size.y));
    pictures::Picture picture;
    picture.alpha = detail().alpha;
    picture.samples = 1;
    display::Canvas corner = canvas;
    corner.size = {static_cast<int>(std::min(1.0F, room) * static_cast<float>(size.x)),
                   static_cast<int>(std::min(1.0F, room) * static_cast<float>(size.y))};
    const render::Frame frame = frame_of(picture, cast, corner);
    renderer_->draw(frame);
    return glimpse.begin(frame, corner.size.width);
}

bool Theatre::begin_portrait(const nursery::Act& act, glm::ivec2 size, const display::Canvas& canvas) {
    return has_gpu() && begin_plain(*portrait_, cast_of(act), size, canvas);
}

std::optional<mesh::Image> Theatre::take_portrait() { return has_gpu() ? portrait_->take() : std::nullopt; }

void Theatre::keep_miniature(const Moment& moment, const Cast& cast, const display::Canvas& canvas) {
    const auto take = [this] {
        auto picture = miniature_->take();
        if (picture) miniatures_.keep(*std::exchange(miniature_due_, std::nullopt), std::move(*picture));
    };
    if (miniature_due_) take();
    const auto due = miniatures_.due(moment.state, moment.now - moment.act.arrived);
    if (!due || miniature_due_ || !moment.timings.finale_asks) return;
    const render::Hanging hanging{static_cast<int>(canvas.rotation), false};
    const glm::vec2 upright(render::turned_size({canvas.size.width, canvas.size.height}, hanging));
    const float scale = static_cast<float>(Miniatures::kWidth) / std::max(upright.x, upright.y);
    if (!begin_plain(*miniature_, cast, glm::ivec2(scale * upright), canvas)) return;
    miniature_due_ = due;
    while (frames_ == Frames::AtAnyTime && miniature_due_) take();
}

render::Drawn Theatre::draw(const Moment& moment, const display::Canvas& canvas, const Over& over) {
    if (!has_gpu()) return {};
    const Cast cast = cast_of(moment.act);
    keep_miniature(moment, cast, canvas);
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
