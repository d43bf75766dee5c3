// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace quadrat::render::gl {

// A picture of four bytes a pixel spread over a larger one, bilinearly, corner pixel over corner pixel, in steps of
// 1/256 of a pixel. Quick for rows one after another: each of the picture's is widened once.
class Enlargement {
  public:
    // from has at least 2 pixels a side, to at least as many as from.
    Enlargement(glm::ivec2 from, glm::ivec2 to);

    bool is_of(glm::ivec2 from, glm::ivec2 to) const { return from_ == from && to_ == to; }
    // The picture, all of from, row after row; it has to stay until the last row is written.
    void begin(std::span<const std::uint32_t> picture);
    // A row of the larger one.
    void write(int row, std::span<std::uint32_t> to);

  private:
    struct WideRow {
        int of = -1;
        std::vector<std::uint8_t> bytes;
    };
    const std::uint8_t* widened(int row);

    glm::ivec2 from_;
    glm::ivec2 to_;
    std::vector<int> columns_;           // of every column of to: the one before it
    std::vector<std::uint16_t> shares_;  // of every byte of a row of to: how much of the column after that, of 256
    std::span<const std::uint32_t> picture_;
    std::vector<std::uint32_t> before_, after_;
    std::array<WideRow, 2> wide_;  // the two last ones, an even and an odd one
};

}  // namespace quadrat::render::gl
