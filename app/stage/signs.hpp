// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>

#include "render/lettering.hpp"
#include "render/pictogram.hpp"
#include "render/renderer.hpp"
#include "stage/legibility.hpp"

namespace quadrat::stage {

// A quarter is known by letter, shape and colour at once. The colours have the hues of Okabe & Ito (2008), which
// colour-blind eyes tell apart, and lightnesses that do so too: any two differ by 1.5:1 in luminance, in every vision.
struct Quarter {
    const char* letter;
    render::Shape shape;
    glm::vec4 colour;  // sRGB
};
inline constexpr std::size_t kQuarters = 4;
const Quarter& quarter(std::size_t index);

// Texts and badges, rasterised once and kept while they are used.
class SignWriter {
  public:
    explicit SignWriter(render::Renderer& renderer) : renderer_(renderer) {}

    struct Written {
        std::shared_ptr<const render::Texture> texture;
        int width = 0;
        int height = 0;
    };
    Written text(const std::string& utf8, float size_px, bool is_bold = false, int max_width_px = 0);
    Written badge(std::size_t quarter_index, int size_px);
    Written pictogram(render::Pictogram which, int size_px);
    // One beside the other; the first is where lines begin.
    enum class Begins { Left, Right };
    Written pictograms(std::span<const render::Pictogram> row, int size_px, Begins begins);
    // A QR code of the text, of so many pixels a side at most; nothing drawn (0 wide) where it has not room.
    Written code(const std::string& text, int most_px);

    // A picture, uploaded once as long as the same one is asked for.
    std::shared_ptr<const render::Texture> picture(const mesh::Image& image);

    // The same, wrapped at most_px.x, as much smaller as it takes to be no higher than most_px.y.
    Written text_within(const std::string& utf8, float size_px, bool is_bold, glm::ivec2 most_px);

    // What says the same without words, and the words within what it leaves of the room: after it, or before where
    // lines begin on the right. Either may be empty; pictograms alone are larger.
    Written said_within(std::span<const render::Pictogram> row, const std::string& utf8, float size_px, bool is_bold,
                        glm::ivec2 most_px, Begins begins);

    // Of all that was written within a room so far, what was made smallest for it: its share of the size it should
    // have.
    struct Tightest {
        float share = 1;
        std::string utf8;
    };
    const Tightest& tightest() const { return tightest_; }
    void forget_tightest() { tightest_ = {}; }

    // On one line, as much smaller as it takes to be no wider than that.
    Written line_within(const std::string& utf8, float size_px, bool is_bold, int most_px);

    // The badge of each quarter in its upper outer corner; that of the marked one is larger.
    std::vector<render::Sign> badges(int width, int height, TextSize size = TextSize::Normal,
                                     std::optional<std::size_t> marked = {});

  private:
    using Key = std::tuple<std::string, int, bool, int>;
    Written keep(const Key& key, const mesh::Image& image);
    float fitted_px(const std::string& utf8, float size_px, bool is_bold, glm::ivec2 most_px);
    render::Renderer& renderer_;
    std::map<Key, Written> written_;
    std::map<std::tuple<std::string, int, bool, int, int>, float> fitted_;  // how large texts are within their room
    Tightest tightest_;
    const mesh::Image* pictured_ = nullptr;
    std::shared_ptr<const render::Texture> picture_;
};

}  // namespace quadrat::stage
