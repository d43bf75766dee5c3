// SPDX-License-Identifier: Apache-2.0
#include "render/renderer.hpp"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "render/gl/fence.hpp"
#include "render/gl/multisampled_target.hpp"
#include "render/gl/picture_upload.hpp"
#include "render/gl/rasteriser_threads.hpp"
#include "render/gl/reduced_target.hpp"
#include "render/gl/wires.hpp"
#include "render/gpu_scene.hpp"
#include "render/held_distance.hpp"
#include "render/held_sky.hpp"
#include "render/passes/signs.hpp"
#include "render/rehearsal.hpp"
#include "render/selection.hpp"
#include "render/upload.hpp"
#include "render/view.hpp"
#include "render/view_painter.hpp"

namespace quadrat::render {
namespace {

constexpr float kSmallViews = 0.65F;  // of the sides: half of their pixels, their sky, are fewer than a held one's

void require_gles_31() {
    const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    if (!version) throw base::InputError("no OpenGL context is current: open a display before the renderer");
    const bool is_es = !epoxy_is_desktop_gl();
    if (is_es && epoxy_gl_version() >= 31) return;
    throw base::InputError(fmt::format("{}: this GPU offers {}; the exhibit needs OpenGL ES 3.1",
                                       reinterpret_cast<const char*>(glGetString(GL_RENDERER)), version));
}

bool is_software() {
    const std::string_view driver{reinterpret_cast<const char*>(glGetString(GL_RENDERER))};
    return driver.find("llvmpipe") != driver.npos || driver.find("softpipe") != driver.npos;
}

// Opaque shaders write an alpha of one: each pixel of theirs adds a step.
void count_fragments() {
    glEnable(GL_BLEND);
    glBlendColor(0, 0, 0, 1.0F / 255);
    glBlendFuncSeparate(GL_ZERO, GL_ONE, GL_CONSTANT_ALPHA, GL_ONE);
}

int scaled(int pixels, float scale) { return static_cast<int>(std::lround(static_cast<float>(pixels) * scale)); }

glm::ivec2 scaled(glm::ivec2 size, float scale) { return {scaled(size.x, scale), scaled(size.y, scale)}; }

// Neighbours stay neighbours.
Rect scaled(const Rect& r, float scale) {
    const glm::ivec2 low = {scaled(r.x, scale), scaled(r.y, scale)};
    return {low.x, low.y, scaled(r.x + r.width, scale) - low.x, scaled(r.y + r.height, scale) - low.y};
}

}  // namespace

struct Renderer::Parts {
    ViewPainter painter;
    passes::SignsPass signs;
    gl::StreamBuffer blocks{GL_UNIFORM_BUFFER};
    std::vector<Stock> stocks;   // one a view
    std::vector<HeldSky> skies;  // likewise, where frames follow each other
    HeldDistances distances;
    std::optional<int> step;  // of the plants' fineness, in the frame before
    HeldSky::Canvas sky_canvas;
    std::optional<std::size_t> sky_drawn_for;  // of which view the canvas has one that was not taken yet
    std::size_t frames = 0;
    std::shared_ptr<Shelves> shelves = std::make_shared<Shelves>();
    bool is_on_processor = is_software();
    gl::ReducedTarget reduced{is_on_processor ? gl::ReducedTarget::SpreadBy::Processor
                                              : gl::ReducedTarget::SpreadBy::Shader};
    gl::MultisampledTarget smooth;
    gl::RasteriserThreads threads;  // known from the second frame on
    gl::Fence last_drawn;

    void fill(const std::vector<Selection>& selections);
    void look_at_all(const Frame& frame, std::vector<Selection>& selections, Drawn& drawn);
    gl::Work hold_skies(const Frame& frame, std::vector<Selection>& selections);
    gl::Work draw_sky_in_turn(const Frame& frame);
    void draw_views(const Frame& frame, std::vector<Selection>& selections, float scale, Drawn& drawn);
    void draw_signs(const Frame& frame);
    GLuint smooth_target(const Frame& frame, glm::ivec2 size);
};

void Renderer::Parts::fill(const std::vector<Selection>& selections) {
    std::vector<std::byte> bytes(selections.size() * choose::kViewBlockBytes);
    for (std::size_t i = 0; i < selections.size(); ++i)
        std::memcpy(bytes.data() + i * choose::kViewBlockBytes, &selections[i].block, sizeof(choose::ViewBlock));
    blocks.fill<std::byte>(bytes);
}

// What of each view is drawn, and how closely.
void Renderer::Parts::look_at_all(const Frame& frame, std::vector<Selection>& selections, Drawn& drawn) {
    HeldTriangles held;
    for (std::size_t i = 0; i < frame.views.size(); ++i) {
        Selection& s = selections[i];
        look(frame, frame.views[i], stocks[i].ground, s);
        stocks[i].cover.fill<choose::CoverInstance>(s.cover.instances);
        drawn.sent_bytes += choose::kViewBlockBytes + stocks[i].ground.sent_bytes() +
                            s.cover.instances.size() * sizeof(choose::CoverInstance);
        if (!s.held_distance) continue;
        const HeldDistance::Sight& sight = distances.of(i).sight();
        held.others += sight.other_triangles;
        drawn.held_from_m += (sight.split_m - drawn.held_from_m) / static_cast<float>(++drawn.held_views);
        for (std::size_t strip = 0; strip < sight.plants.size(); ++strip)
            held.plants.push_back({frame.views[i].scene->flora->kinds, &sight.gatherings[strip], &sight.plants[strip]});
    }
    // A part is drawn as closely as in the whole before it.
    if (draws_plants(frame) && (frame.measured.part == choose::Reach::Part::Whole || !step))
        step = affordable_step(frame, selections, std::move(held), step);
}

// Of every view that has one which serves; one that no longer does is drawn and shown at once, as all of a new
// generation's. Where views are drawn so small that it costs less, it waits for its turn, and is drawn where it is
// seen.
gl::Work Renderer::Parts::hold_skies(const Frame& frame, std::vector<Selection>& selections) {
    gl::Work work;
    skies.resize(frame.views.size());
    if (sky_drawn_for && *sky_drawn_for < skies.size()) skies[*sky_drawn_for].take(sky_canvas);
    sky_drawn_for.reset();
    for (std::size_t slot = 0; slot < skies.size(); ++slot) {
        const View& view = frame.views[slot];
        std::optional<glm::mat3>& from_view = selections[slot].held_sky_from_view;
        from_view = skies[slot].from_view(view, selections[slot].block);
        if (from_view || scale_of(frame) < kSmallViews) continue;
        work += sky_canvas.draw(view, frame.seconds, painter.sky());
        skies[slot].take(sky_canvas);
        from_view = skies[slot].from_view(view, selections[slot].block);
    }
    return work;
}

// Every few frames a view's sky has its turn: it is drawn while what else the frame shows is chosen, and shown from the
// next frame on.
gl::Work Renderer::Parts::draw_sky_in_turn(const Frame& frame) {
    const std::size_t slot = frames % HeldSky::kFrames;
    if (slot >= frame.views.size()) return {};
    sky_drawn_for = slot;
    return sky_canvas.draw(frame.views[slot], frame.seconds, painter.sky());
}

// On the framebuffer that is bound, from its lower left corner. Adds to drawn, and sums it.
void Renderer::Parts::draw_views(const Frame& frame, std::vector<Selection>& selections, float scale, Drawn& drawn) {
    glDisable(GL_SCISSOR_TEST);
    const bool is_counted = frame.measured.is_counted;
    begin_drawing({0.05F, 0.055F, 0.06F, is_counted ? 0.0F : 1.0F}, frame.hanging.is_mirrored);
    glEnable(GL_SCISSOR_TEST);
    if (is_counted) count_fragments();
    const auto draw_one = [&](std::size_t i, Drawn& to) {
        const Rect place = scaled(on_panel(frame.views[i].viewport, frame.size, frame.hanging), scale);
        glScissor(place.x, place.y, place.width, place.height);
        gl::bind_uniforms(blocks, choose::kViewBinding, i * choose::kViewBlockBytes, choose::kViewBlockBytes);
        ViewPainter::Held held;
        if (selections[i].held_sky_from_view) held.sky = &skies[i];
        if (selections[i].held_distance) held.distance = &distances.of(i).picture();
        painter.draw(frame, frame.views[i], selections[i], stocks[i], held, place, to);
    };
    if (frame.is_wired) {
        glEnable(GL_POLYGON_OFFSET_FILL);  // so that edges lie before what they are the edges of
        glPolygonOffset(1, 2);
    }
    look_at_all(frame, selections, drawn);
    for (std::size_t i = 0; i < frame.views.size(); ++i) {
        if (step) painter.send_plants(frame, frame.views[i], *step, selections[i], stocks[i], drawn);
        draw_one(i, drawn);
        // Its other threads draw this view while the next one is chosen; the last two, which leave them enough to do,
        // go together. A tiler would write its tiles out for it, and fetch them again.
        if (is_on_processor && i + 2 < frame.views.size()) glFlush();
    }
    if (frame.is_wired) {
        glDisable(GL_POLYGON_OFFSET_FILL);
        const gl::Wires wires;
        Drawn not_counted;
        for (std::size_t i = 0; i < frame.views.size(); ++i) {
            stocks[i].ground.sort_by_level(*frame.views[i].scene);
            draw_one(i, not_counted);
        }
    }
    for (const gl::Work& work : drawn.of) {
        drawn.triangles += work.triangles;
        drawn.draws += work.draws;
    }
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
}

void Renderer::Parts::draw_signs(const Frame& frame) {
    std::vector<passes::FlatSign> flat;
    for (const Sign& sign : frame.signs) {
        flat.push_back({{sign.place.x, sign.place.y},
                        {sign.place.width, sign.place.height},
                        sign.texture ? &sign.texture->picture : nullptr,
                        sign.colour,
                        sign.corner_radius_px,
                        sign.border_px});
    }
    const glm::ivec2 target = turned_size(frame.size, frame.hanging);
    glViewport(0, 0, target.x, target.y);
    signs.draw(flat, frame.size, panel_from_upright(frame.hanging));
}

// 0 where a frame has one sample a pixel. What is counted is counted once a pixel.
GLuint Renderer::Parts::smooth_target(const Frame& frame, glm::ivec2 size) {
    if (frame.detail.samples > 1 && !frame.measured.is_counted)
        return smooth.of(size, frame.detail.samples, frame.framebuffer);
    if (frame.is_one_of_many) smooth.let_go();
    return 0;
}

Renderer::Renderer(GroundBy ground) {
    require_gles_31();
    parts_ = std::make_unique<Parts>();
    parts_->shelves->ground = ground;
    // Some megabytes; whatever is compiled later, wires, calls for it again.
    glReleaseShaderCompiler();
}

Renderer::~Renderer() = default;

std::unique_ptr<SceneUpload> Renderer::begin_upload(std::shared_ptr<const scene::Scene> scene) {
    return make_upload(std::move(scene), parts_->shelves);
}

std::unique_ptr<Upload> Renderer::begin_upload(const scene::Ground& ground) {
    return make_upload(ground, parts_->shelves);
}

std::shared_ptr<const Texture> Renderer::texture(const mesh::Image& premultiplied_rgba) {
    auto texture = std::make_shared<Texture>();
    gl::Slices slices;
    gl::TextureShape shape;
    shape.sampling = gl::Sampling::Smooth;
    gl::add_picture(slices, texture->picture, std::make_shared<mesh::Image>(premultiplied_rgba), shape);
    while (!slices.advance(std::size_t{1} << 22U)) continue;
    return texture;
}

Drawn Renderer::draw(const Frame& frame) {
    Parts& parts = *parts_;
    if (parts.stocks.size() != frame.views.size()) parts.stocks.resize(frame.views.size());
    std::vector<Selection> selections;
    for (std::size_t slot = 0; slot < frame.views.size(); ++slot) selections.push_back(outline(frame, slot));
    Drawn drawn;
    gl::Work& skies = drawn.of[static_cast<std::size_t>(DrawnKind::Sky)];
    if (++parts.frames == 2 && parts.is_on_processor)
        parts.threads = gl::RasteriserThreads::of_this_process("llvmpipe-");
    const bool holds_skies =
        frame.is_one_of_many && frame.measured.sky && !frame.measured.is_counted && !frame.is_wired;
    if (holds_skies) skies += parts.hold_skies(frame, selections);
    const bool holds_distances = holds_skies && frame.holds_distance && frame.measured == Measured{};
    if (holds_distances) parts.distances.serve(frame, parts.skies, selections);
    std::optional<gl::RasteriserThreads::Feeding> feeding(std::in_place, parts.threads);
    if (holds_skies) skies += parts.draw_sky_in_turn(frame);
    if (holds_distances) {
        parts.distances.draw_in_turn(frame, parts.painter, parts.step, drawn);
        parts.distances.show_at_once(frame, parts.skies, selections);
    }
    parts.fill(selections);

    const glm::ivec2 size = turned_size(frame.size, frame.hanging);
    const glm::ivec2 drawn_size = scaled(size, scale_of(frame));
    const GLuint smaller = drawn_size == size ? 0 : parts.reduced.of(size);
    const GLuint smooth = smaller == 0 ? parts.smooth_target(frame, size) : 0;
    const GLuint target = smooth != 0 ? smooth : frame.framebuffer;
    glBindFramebuffer(GL_FRAMEBUFFER, smaller != 0 ? smaller : target);
    parts.draw_views(frame, selections, smaller != 0 ? scale_of(frame) : 1, drawn);
    feeding.reset();
    if (smaller != 0) parts.reduced.show(drawn_size, frame.framebuffer, size);
    parts.draw_signs(frame);
    if (smooth != 0) parts.smooth.resolve(frame.framebuffer);
    drawn.samples = smooth != 0 ? frame.detail.samples : 1;
    const bool is_window = frame.framebuffer == 0;
    const GLenum unneeded[2] = {static_cast<GLenum>(is_window ? GL_DEPTH : GL_DEPTH_ATTACHMENT),
                                static_cast<GLenum>(is_window ? GL_STENCIL : GL_STENCIL_ATTACHMENT)};
    glInvalidateFramebuffer(GL_FRAMEBUFFER, 2, unneeded);
    glBindVertexArray(0);
    parts.last_drawn.set();
    drawn.objects = gl::LiveObjects::count();
    return drawn;
}

Drawn Renderer::rehearse(const Frame& like) {
    const auto upload = begin_upload(std::make_shared<scene::Scene>(rehearsal_scene()));
    while (!upload->advance(std::size_t{1} << 22U)) continue;
    Frame frame;
    frame.framebuffer = like.framebuffer;
    frame.hanging = like.hanging;
    frame.size = glm::min(like.size, glm::ivec2{480, 270});
    View view;
    view.scene = upload->take();
    view.camera = rehearsal_camera();
    view.viewport = {0, 0, frame.size.x, frame.size.y};
    frame.views.push_back(std::move(view));
    frame.is_one_of_many = true;
    const Drawn drawn = draw(frame);
    // So many that what is far has been held and shown.
    for (std::size_t n = 0; n < 2 * HeldDistances::kFrames; ++n) draw(frame);
    // Drivers compile what is drawn once more for several samples.
    frame.detail.samples = like.detail.samples;
    if (frame.detail.samples > 1) draw(frame);
    frame.detail = {1, 0.5F, 1};
    draw(frame);
    parts_->stocks.clear();    // another scene may get the address of this one
    parts_->distances.drop();  // likewise
    parts_->skies.clear();     // of this size they are not needed again
    parts_->sky_drawn_for.reset();
    frame.views.clear();
    parts_->shelves->grain_textures.trim(0);
    parts_->shelves->cloud_textures.trim(0);
    parts_->shelves->ground_pictures.trim(0);
    parts_->shelves->mirror_pictures.trim(0);
    parts_->shelves->buffers.trim(0);
    return drawn;
}

int Renderer::most_samples() const { return gl::most_samples(parts_->is_on_processor); }

bool Renderer::is_done_within(std::chrono::nanoseconds patience) { return parts_->last_drawn.is_done_within(patience); }

}  // namespace quadrat::render
