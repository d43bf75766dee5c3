// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "render/gl/buffer.hpp"
#include "render/gl/buffer_pool.hpp"
#include "render/gl/slices.hpp"

namespace quadrat::render::gl {

inline constexpr std::size_t kBufferPieceBytes = 256U << 10U;

// Adds the slices that fill buffer with what find() gives once everything is prepared: count elements, which owner
// keeps alive. The buffer's address must stay.
template <typename Element, typename Find>
void add_elements(Slices& slices, Buffer& buffer, GLenum target, std::size_t count, Find find) {
    if (count == 0) return;
    slices.add(0, [&buffer, target, count] { buffer = Buffer{target, count * sizeof(Element)}; });
    slices.add_pieces(count, kBufferPieceBytes / sizeof(Element), sizeof(Element),
                      [&buffer, find](std::size_t first, std::size_t many) {
                          buffer.write<Element>(first, std::span<const Element>(find()).subspan(first, many));
                      });
}

// The same into a buffer of the pool, which may have room for more.
template <typename Element, typename Find>
void add_elements(Slices& slices, std::shared_ptr<Buffer>& buffer, const std::shared_ptr<BufferPool>& pool,
                  GLenum target, std::size_t count, Find find) {
    slices.add(0, [&buffer, pool, target, count] { buffer = pool->take(target, count * sizeof(Element)); });
    slices.add_pieces(count, kBufferPieceBytes / sizeof(Element), sizeof(Element),
                      [&buffer, find](std::size_t first, std::size_t many) {
                          buffer->write<Element>(first, std::span<const Element>(find()).subspan(first, many));
                      });
}

// The same for elements that are there already, and are kept alive by their pointer.
template <typename Element>
void add_elements(Slices& slices, Buffer& buffer, GLenum target, std::shared_ptr<const std::vector<Element>> from) {
    const std::size_t count = from->size();
    add_elements<Element>(slices, buffer, target, count,
                          [from = std::move(from)] { return std::span<const Element>(*from); });
}

// The same for elements that are worked out while everything is prepared: element(i) for each of count.
template <typename Element, typename Make>
void add_made(Slices& slices, Buffer& buffer, GLenum target, std::size_t count, Make element) {
    const auto made = std::make_shared<std::vector<Element>>();
    slices.prepare([made, count, element = std::move(element)] {
        made->reserve(count);
        for (std::size_t i = 0; i < count; ++i) made->push_back(element(i));
    });
    add_elements<Element>(slices, buffer, target, count, [made] { return std::span<const Element>(*made); });
}

}  // namespace quadrat::render::gl
