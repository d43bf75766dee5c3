// SPDX-License-Identifier: Apache-2.0
// The room `render`: brings scenes to the GPU and draws them; letters and signs too. Which scenes are shown, and how
// much a frame may spend, is said by others (stage, tempo). Only this room draws by OpenGL, and nothing here grows.
#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mesh/image.hpp"
#include "render/choose/allowance.hpp"
#include "render/choose/reach.hpp"
#include "render/gl/work.hpp"
#include "render/ground_by.hpp"
#include "render/hanging.hpp"
#include "scene/scene.hpp"

// Draws on the context that is current on the calling thread. Everything here belongs to that thread.
namespace quadrat::render {

using choose::Detail;

class GpuScene;  // a scene's buffers and textures; freed on the context's thread

// An upload that is cut into slices, so that frames keep their deadline.
class Upload {
  public:
    virtual ~Upload() = default;
    // Works out all that needs no GPU: on any one thread, while nothing else is asked of this upload. What is left of
    // it is done by the first advance().
    virtual void prepare() = 0;
    // Does pieces of about 256 KB each, at least one: as many as the budget holds, while has_time() where it is given.
    // True when finished.
    virtual bool advance(std::size_t budget_bytes, const std::function<bool()>& has_time = {}) = 0;
};

class SceneUpload : public Upload {
  public:
    virtual std::shared_ptr<const GpuScene> take() = 0;  // once, when finished
};

struct View {
    std::shared_ptr<const GpuScene> scene;
    scene::Camera camera;
    Rect viewport;
    float growth = 1;  // 0: bare land with seedlings, 1: grown; the arrival of a new generation
    float dim = 0;     // 0 to 1: faded toward the dark, for candidates that were not chosen
};

// Flat things over the views: letters, frames, prompts. Drawn in order, blended.
struct Texture;
struct Sign {
    Rect place;
    std::shared_ptr<const Texture> texture;  // none: a plain rectangle of colour
    glm::vec4 colour{1};                     // multiplies the texture; not premultiplied
    float corner_radius_px = 0;              // of a plain rectangle
    float border_px = 0;                     // more than 0: only this border of it
};

// What of each view is drawn: all of it, unless something is measured.
struct Measured {
    bool leaves = true;  // and crowns
    bool wood = true;
    bool ground = true;  // and its cover, stone, and the surround
    bool water = true;
    bool sky = true;          // and what falls from it
    bool is_counted = false;  // plants and ground leave their picture out and add 1 to alpha for every pixel shaded
    choose::Reach::Part part = choose::Reach::Part::Whole;  // of each view, split about its eye
    float split_m = 0;
    friend bool operator==(const Measured&, const Measured&) = default;
};

// Of the pixels of a frame that is one of many, those of sky that are drawn for frames to come, on average.
extern const float kSkyDrawnAnew;
// Of a frame that holds what is far, those of what is far that are drawn for frames to come.
extern const float kDistanceDrawnAnew;

struct Frame {
    glm::ivec2 size{0};  // of the upright picture, pixels: views and signs are laid out in it
    Hanging hanging;     // the target has turned_size(size, hanging)
    std::uint32_t framebuffer = 0;
    float seconds = 0;        // of the scenes' own time: wind, water, clouds
    std::vector<View> views;  // 1 (full screen) to 4, drawn in one pass on one framebuffer
    std::vector<Sign> signs;
    Detail detail;
    Measured measured;
    bool is_wired = false;  // with the edges of all triangles, coloured by level; slow
    // One of many that follow each other: what hardly changes may come from those before it. A single picture is drawn
    // whole and depends on nothing else.
    bool is_one_of_many = false;
    bool holds_distance = true;  // such a frame; false: to be compared with
};

// What a frame asked of the GPU, signs left out.
enum class DrawnKind : std::size_t { Leaves, Wood, Cover, Ground, Water, Sky, Falling };
inline constexpr std::size_t kDrawnKinds = 7;

struct Drawn {
    std::array<gl::Work, kDrawnKinds> of{};  // a DrawnKind
    std::size_t triangles = 0;               // of all
    std::size_t draws = 0;
    std::size_t sent_bytes = 0;  // that are new every frame: instances, indices, views
    std::size_t objects = 0;     // buffers, textures, programs that there are
    int samples = 1;             // a pixel
    std::size_t held_views = 0;  // that show what is far as it was held
    std::size_t held_anew = 0;   // of what is far, pictures or strips of one drawn for frames to come
    float held_from_m = 0;       // the mean of what splits those views
};

class Renderer {
  public:
    // Compiles every shader. Throws InputError naming the GPU and what it lacks when it is not OpenGL ES 3.1.
    explicit Renderer(GroundBy ground = GroundBy::Blocks);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    std::unique_ptr<SceneUpload> begin_upload(std::shared_ptr<const scene::Scene> scene);
    // Ahead of the scenes that will stand on it. It stays on the GPU as long as the upload lives: scenes whose own
    // uploads begin after it is finished and before it goes bring their sky and light alone.
    std::unique_ptr<Upload> begin_upload(const scene::Ground& ground);
    std::shared_ptr<const Texture> texture(const mesh::Image& premultiplied_rgba);  // with mipmaps
    Drawn draw(const Frame& frame);
    // Draws a little of everything into a corner of the framebuffer, to be drawn over: much of what a driver compiles
    // it compiles when it is first drawn, and the first rain is no moment for that.
    Drawn rehearse(const Frame& like);
    // Waits so long at most for what draw() asked of the GPU last; true when it is done.
    bool is_done_within(std::chrono::nanoseconds patience);
    // Of a pixel, that this GPU can be asked for without waiting much longer: 1 or 4.
    int most_samples() const;
    double upload_bytes_per_s() const;            // into a texture; measured when it is asked, in some milliseconds
    void finish();                                // waits until everything is drawn; for measuring, never in the show
    mesh::Image read_pixels(const Frame& frame);  // RGBA, rows from the top, as the panel has them

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace quadrat::render
