// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

namespace quadrat::mesh {

// Samples of a field where it matters: blocks of 8 x 8 x 8 on one lattice. Inside is more than 0; what no block holds
// is outside. Every sample inside must lie in a block that has neighbours on all sides, or at least a sample of its own
// between it and its rim.
class SparseField {
  public:
    static constexpr int kSide = 8;
    static constexpr int kSamples = kSide * kSide * kSide;
    using Block = std::array<float, kSamples>;  // x fastest, then y, then z

    explicit SparseField(glm::ivec3 blocks);

    // The number of the block at this place, made if it is not there yet; its samples are then not set. Outside the
    // lattice: -1.
    int make(glm::ivec3 place);
    int find(glm::ivec3 place) const;  // its number, or -1
    std::size_t count() const { return places_.size(); }
    Block& block(std::size_t i) { return pages_[i / kPage][i % kPage]; }
    const Block& block(std::size_t i) const { return pages_[i / kPage][i % kPage]; }
    glm::ivec3 place(std::size_t i) const { return places_[i]; }
    glm::ivec3 size() const { return size_; }
    float at(glm::ivec3 sample) const;  // -1 where there is no block

  private:
    glm::ivec3 size_;
    std::vector<std::int32_t> index_;
    static constexpr std::size_t kPage = 64;
    std::vector<std::unique_ptr<Block[]>> pages_;
    std::vector<glm::ivec3> places_;
};

}  // namespace quadrat::mesh
