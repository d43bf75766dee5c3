// SPDX-License-Identifier: Apache-2.0
// The room `stage`: what the audience sees. From a visit's moment and grown landscapes to a frame, its words and signs;
// what lies on the GPU. Nothing here decides what happens next or listens to buttons.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "base/clock.hpp"
#include "display/display.hpp"
#include "exhibit/visit.hpp"
#include "render/pictogram.hpp"
#include "render/renderer.hpp"
#include "site/configuration.hpp"
#include "stage/asked.hpp"
#include "stage/board.hpp"
#include "stage/miniatures.hpp"
#include "stage/scanned.hpp"
#include "stage/signs.hpp"

namespace quadrat::stage {

// One landscape as it can be drawn.
struct Shown {
    std::shared_ptr<const scene::Scene> scene;
    std::shared_ptr<const render::GpuScene> gpu;
};

// What is on stage: nothing yet, one landscape or four.
struct Cast {
    std::vector<Shown> scenes;
    base::Instant arrived{0};  // when they first were seen, from which they grow in
};

// What happened to a button, for the flash that acknowledges it.
struct Flash {
    exhibit::Choice button;
    base::Instant at;
};

struct StageView {
    const exhibit::State& state;
    const exhibit::Timings& timings;
    const Cast& cast;
    const std::optional<Flash>& flash;
    float growing_progress = 0;  // of what Breed waits for, 0 to 1
    base::Instant now{0};
    std::string_view caption = {};           // below the prompt of Breed and of the finale; may be empty
    const Asked* asked = nullptr;            // in Describe and Slide
    const Board* board = nullptr;            // over everything, or null
    const mesh::Image* backdrop = nullptr;   // a picture of an earlier landscape in place of what is not there, or null
    std::string_view sign = {};              // for staff, small in a corner; may be empty
    const Scanned* scanned = nullptr;        // for who has not four buttons, or null
    std::string_view take_home = {};         // in the finale, as a QR code; may be empty
    std::string_view language = {};          // that is spoken now; "": the site's
    const Miniatures* miniatures = nullptr;  // for Family, or null
};

// From the visit's state to a frame: which views, how dim, which words. Holds rasterised words, nothing else.
class Stage {
  public:
    Stage(render::Renderer& renderer, const site::Configuration& configuration)
        : writer_(renderer), renderer_(renderer), configuration_(configuration) {}

    render::Frame frame(const StageView& view, const display::Canvas& canvas);
    SignWriter& writer() { return writer_; }

  private:
    void add_views(render::Frame& frame, const StageView& view);
    void add_ground(render::Frame& frame, const render::Rect& place, float corner_px);  // that words stand on
    void add_quarter_signs(render::Frame& frame, const StageView& view);
    void add_board(render::Frame& frame, const Board& board);
    void add_strip(render::Frame& frame, const Board& board);
    void add_sign(render::Frame& frame, std::string_view words);
    void add_backdrop(render::Frame& frame, const mesh::Image& picture);
    struct Room {
        float em_px;
        bool is_bold;
        glm::ivec2 most_px;
    };
    SignWriter::Written written(const StageView& view, std::string_view key, const std::string& utf8, const Room& room);
    SignWriter::Begins begins(const StageView& view) const;
    struct PlateText;
    PlateText plate_text(const StageView& view, glm::ivec2 size);
    void add_plate(render::Frame& frame, const StageView& view);
    void add_beside_plate(render::Frame& frame, const StageView& view, const render::Rect& plate);
    void add_chosen(render::Frame& frame, const StageView& view, const render::Rect& plate);
    void add_take_home(render::Frame& frame, const StageView& view, const render::Rect& plate);
    void add_take_home_beside(render::Frame& frame, const StageView& view, const render::Rect& plate);
    void add_code(render::Frame& frame, const render::Rect& card, glm::ivec2 at, const SignWriter::Written& code);
    void add_words(render::Frame& frame, const SignWriter::Written& words, glm::ivec2 at);
    bool shares_top(const StageView& view) const;
    void add_demonstration(render::Frame& frame, const StageView& view, const render::Rect& plate);
    void add_back(render::Frame& frame, const StageView& view, const render::Rect& plate);
    void add_progress(render::Frame& frame, const StageView& view, const render::Rect& plate);
    void add_labels(render::Frame& frame, const StageView& view);
    int labels_top(int height) const;  // above which labels leave the picture free
    int lower_row(int height) const;   // of them: its height
    int beside_arrows(int height);     // where labels that are an arrow leave it free
    void add_turns(render::Frame& frame, const StageView& view, const render::Rect& plate);
    void add_breeds_on(render::Frame& frame, const StageView& view, const render::Rect& plate);
    void add_family(render::Frame& frame, const StageView& view, const render::Rect& plate);
    void add_family_lines(render::Frame& frame, const StageView& view, const std::vector<render::Rect>& cards);
    void add_family_card(render::Frame& frame, const StageView& view, int node, const render::Rect& card);
    void add_picked(render::Frame& frame, const StageView& view, const render::Rect& card);
    void bring_family(const StageView& view);
    void add_slider(render::Frame& frame, const ShownSlider& slider, int room_px);

    SignWriter writer_;
    render::Renderer& renderer_;
    const site::Configuration& configuration_;
    struct FamilyPicture {
        int number = 0;  // of its miniature
        std::shared_ptr<const render::Texture> texture;
    };
    std::map<int, FamilyPicture> family_;  // by node; as long as Family is shown
};

// Whether the four are shown, a quarter each.
bool shows_four(const StageView& view);

// How bright the acknowledgement of the last press still is: 1 on its first frame, 0 when it is over.
float flash_left(const StageView& view);

// Whether the language that is spoken does: what has a beginning and an end begins on the right then. The four quarters
// stay where their buttons are.
bool reads_right_to_left(const StageView& view, const site::Configuration& configuration);

bool is_written_from_the_right(const std::string& language);

// Which of genome::kPrompts is said.
std::string_view key_of(const StageView& view);

// The words of the moment, in the language that is spoken.
std::string words(const StageView& view, const site::Configuration& configuration);

}  // namespace quadrat::stage
