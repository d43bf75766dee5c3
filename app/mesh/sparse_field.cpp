// SPDX-License-Identifier: Apache-2.0
#include "mesh/sparse_field.hpp"

namespace quadrat::mesh {

SparseField::SparseField(glm::ivec3 blocks)
    : size_(glm::max(blocks, glm::ivec3{1})),
      index_(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) * static_cast<std::size_t>(size_.z),
             -1) {}

int SparseField::find(glm::ivec3 p) const {
    if (p.x < 0 || p.y < 0 || p.z < 0 || p.x >= size_.x || p.y >= size_.y || p.z >= size_.z) return -1;
    return index_[(static_cast<std::size_t>(p.z) * static_cast<std::size_t>(size_.y) + static_cast<std::size_t>(p.y)) *
                      static_cast<std::size_t>(size_.x) +
                  static_cast<std::size_t>(p.x)];
}

int SparseField::make(glm::ivec3 p) {
    const int found = find(p);
    const bool is_in = p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < size_.x && p.y < size_.y && p.z < size_.z;
    if (found >= 0 || !is_in) return found;
    const auto number = static_cast<std::int32_t>(places_.size());
    index_[(static_cast<std::size_t>(p.z) * static_cast<std::size_t>(size_.y) + static_cast<std::size_t>(p.y)) *
               static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(p.x)] = number;
    if (places_.size() % kPage == 0) pages_.push_back(std::make_unique_for_overwrite<Block[]>(kPage));
    places_.push_back(p);
    return number;
}

float SparseField::at(glm::ivec3 s) const {
    const int b = find({s.x >> 3, s.y >> 3, s.z >> 3});
    return b < 0 ? -1.0F : block(b)[((s.z & 7) * kSide + (s.y & 7)) * kSide + (s.x & 7)];
}

}  // namespace quadrat::mesh
