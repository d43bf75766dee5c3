// SPDX-License-Identifier: Apache-2.0
#include "benches/four_views.hpp"

#include <tbb/parallel_for_each.h>

#include <thread>

#include "machine/heap.hpp"
#include "stage/detail_within.hpp"

namespace quadrat::benches {
namespace {

// Asked once a millisecond, as frames ask.
nursery::Graph::AllLit awaited(const nursery::Nursery& nursery, const nursery::Landscapes& four, bool is_full) {
    for (;;) {
        if (auto lit = nursery.find(four); lit && (lit->is_full || !is_full)) return *lit;
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
}

}  // namespace

FourViews::FourViews(const Options& options, std::uint64_t seed)
    : growing_(begin(seed)),
      easel(display::size_from(options.size, "--size").width, display::size_from(options.size, "--size").height,
            render::ground_named(options.ground)) {
    const display::Size size = display::size_from(options.size, "--size");
    picture.size = {size.width, size.height};
    picture.detail.alpha = options.alpha;
    picture.is_one_of_many = true;  // as the exhibit's are
    easel.renderer().rehearse(picture);
    machine::let_go_of_compilers();  // as the theatre does
    show_what_grows();
    keep_within(options);
}

void FourViews::grow(std::uint64_t seed) {
    growing_ = begin(seed);
    show_what_grows();
}

void FourViews::show(const nursery::Scenes& four) {
    bring(four);
    look(0);
}

std::unique_ptr<nursery::Nursery> FourViews::begin(std::uint64_t seed) {
    auto nursery = std::make_unique<nursery::Nursery>();
    four_ = nursery::landscapes_of(random_candidates(seed), base::Seed{seed});
    nursery->want(nursery::wants_for(four_, nursery::Stage::FirstLight, nursery::Urgency::Awaited));
    return nursery;
}

void FourViews::show_what_grows() {
    const nursery::Graph::AllLit first = awaited(*growing_, four_, false);
    bring(first.scenes);
    look(0);
    draw();
    first_seen = std::chrono::steady_clock::now();
    growing_->want(nursery::wants_for(four_, nursery::Stage::FullLight, nursery::Urgency::Shown));
    if (!first.is_full) bring(awaited(*growing_, four_, true).scenes);
    growing_.reset();
    machine::give_memory_back();  // as quadrat run does, here
    look(0);
}

void FourViews::bring(const nursery::Scenes& grown) {
    scenes = grown;
    picture.views.clear();
    const auto places = stage::quarters(picture.size.x, picture.size.y);
    std::vector<std::unique_ptr<render::SceneUpload>> uploads;
    for (const auto& scene : scenes) uploads.push_back(easel.renderer().begin_upload(scene));
    tbb::parallel_for_each(uploads, [](const auto& upload) { upload->prepare(); });
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        while (!uploads[i]->advance(static_cast<std::size_t>(-1))) continue;
        render::View view;
        view.scene = uploads[i]->take();
        view.viewport = places[i];
        picture.views.push_back(view);
    }
}

void FourViews::look(float seconds) {
    picture.seconds = seconds;
    for (std::size_t i = 0; i < scenes.size(); ++i)
        picture.views[i].camera = scene::camera_at(scenes[i]->track, seconds);
}

render::Drawn FourViews::draw() {
    const display::Canvas canvas = easel.display().begin_frame();
    picture.framebuffer = canvas.framebuffer;
    const render::Drawn drawn = easel.renderer().draw(picture);
    easel.renderer().finish();
    easel.display().present();
    return drawn;
}

void FourViews::keep_within(const Options& options) {
    picture.holds_distance = false;  // of whole landscapes, however much of them will be held
    picture.detail = stage::detail_within({options.triangles, options.pixels}, picture.size, picture.detail,
                                          [this](const render::Detail& detail) {
                                              picture.detail = detail;
                                              return draw().triangles;
                                          });
    picture.holds_distance = true;
}

}  // namespace quadrat::benches
