// SPDX-License-Identifier: Apache-2.0
#include "render/gl/buffer_pool.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "render/gl/buffer_upload.hpp"
#include "unit/render/gpu_fixture.hpp"

namespace quadrat::render::gl {
namespace {

constexpr std::size_t kMegabyte = 1U << 20U;

class BuffersOfAPool : public Gpu {};

TEST_F(BuffersOfAPool, AreTakenAgainOnceNobodyHoldsThem) {
    BufferPool pool;
    auto first = pool.take(GL_ARRAY_BUFFER, kMegabyte);
    const auto second = pool.take(GL_ARRAY_BUFFER, kMegabyte);
    EXPECT_NE(first, second);
    EXPECT_GE(first->bytes(), kMegabyte);
    const Buffer* free = first.get();
    first.reset();
    EXPECT_EQ(pool.take(GL_ARRAY_BUFFER, kMegabyte - 1000).get(), free);
}

TEST_F(BuffersOfAPool, ServeTheirTargetAndAboutTheirSize) {
    BufferPool pool;
    auto large = pool.take(GL_ARRAY_BUFFER, kMegabyte);
    const Buffer* free = large.get();
    large.reset();
    EXPECT_NE(pool.take(GL_ELEMENT_ARRAY_BUFFER, kMegabyte).get(), free);
    EXPECT_NE(pool.take(GL_ARRAY_BUFFER, kMegabyte + kMegabyte / 2).get(), free);
    EXPECT_NE(pool.take(GL_ARRAY_BUFFER, kMegabyte / 4).get(), free);  // three quarters of it would lie idle
    EXPECT_EQ(pool.take(GL_ARRAY_BUFFER, kMegabyte / 4 * 3).get(), free);
}

TEST_F(BuffersOfAPool, SmallOnesAreNotKept) {
    const std::size_t before = LiveObjects::count();
    BufferPool pool;
    const auto small = pool.take(GL_ARRAY_BUFFER, 1000);
    EXPECT_EQ(small->bytes(), 1000U);
    pool.take(GL_ARRAY_BUFFER, 2000);
    EXPECT_EQ(LiveObjects::count(), before + 1);
}

TEST_F(BuffersOfAPool, GoWhenManyAreFree) {
    const std::size_t before = LiveObjects::count();
    BufferPool pool;
    std::vector<std::shared_ptr<Buffer>> held;
    for (int i = 0; i < 40; ++i) held.push_back(pool.take(GL_ARRAY_BUFFER, kMegabyte));
    EXPECT_EQ(LiveObjects::count(), before + 40);
    held.clear();
    held.push_back(pool.take(GL_ARRAY_BUFFER, kMegabyte));
    EXPECT_LE(LiveObjects::count(), before + 12);
    pool.trim(0);
    EXPECT_EQ(LiveObjects::count(), before + 1);  // the one that is held
}

TEST_F(BuffersOfAPool, HoldWhatWasWrittenLast) {
    const auto pool = std::make_shared<BufferPool>();
    std::shared_ptr<Buffer> buffer;
    const auto bring = [&](std::uint32_t from) {
        std::vector<std::uint32_t> numbers(200'000);
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = from + static_cast<std::uint32_t>(i);
        Slices slices;
        add_elements<std::uint32_t>(slices, buffer, pool, GL_ARRAY_BUFFER, numbers.size(),
                                    [&] { return std::span<const std::uint32_t>(numbers); });
        while (!slices.advance(1)) continue;
        glBindBuffer(GL_ARRAY_BUFFER, buffer->name());
        const auto bytes = static_cast<GLsizeiptr>(numbers.size() * sizeof(std::uint32_t));
        const auto* back =
            static_cast<const std::uint32_t*>(glMapBufferRange(GL_ARRAY_BUFFER, 0, bytes, GL_MAP_READ_BIT));
        ASSERT_NE(back, nullptr);
        EXPECT_TRUE(std::equal(numbers.begin(), numbers.end(), back));
        glUnmapBuffer(GL_ARRAY_BUFFER);
    };
    bring(1);
    const GLuint name = buffer->name();
    buffer.reset();
    bring(1'000'000);
    EXPECT_EQ(buffer->name(), name);
}

}  // namespace
}  // namespace quadrat::render::gl
