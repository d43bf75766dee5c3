// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "render/lettering.hpp"
#include "render/renderer.hpp"

namespace quadrat::stage {

// A quarter is known by letter, shape and colour at once. Colours: Okabe & Ito 2008, told apart by colour-blind eyes.
struct Quarter {
    const char* letter;
    render::Shape shape;
    glm::vec4 colour;  // sRGB
};
inline constexpr std::size_t kQuarters = 4;
inline constexpr glm::vec4 kPlate{0.05F, 0.06F, 0.07F, 0.72F};  // what words stand on
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

    // A picture, uploaded once as long as the same one is asked for.
    std::shared_ptr<const render::Texture> picture(const mesh::Image& image);

    // The badge of each quarter in its upper outer corner, sized for the target.
    std::vector<render::Sign> badges(int width, int height);

  private:
    using Key = std::tuple<std::string, int, bool, int>;
    Written keep(const Key& key, const mesh::Image& image);
    render::Renderer& renderer_;
    std::map<Key, Written> written_;
    const mesh::Image* pictured_ = nullptr;
    std::shared_ptr<const render::Texture> picture_;
};

}  // namespace quadrat::stage
