// SPDX-License-Identifier: Apache-2.0
#include "render/gl/fence.hpp"

#include <gtest/gtest.h>

#include "unit/render/gpu_fixture.hpp"

namespace quadrat::render::gl {
namespace {

using namespace std::chrono_literals;

int deleted = 0;

// Counts what is deleted, and has it done.
class SyncsOnGpu : public Gpu {
  protected:
    void SetUp() override {
        Gpu::SetUp();
        glDeleteSync(nullptr);  // epoxy finds the driver's own with the first call
        driver_s_ = epoxy_glDeleteSync;
        deleted = 0;
        epoxy_glDeleteSync = [](GLsync sync) {
            ++deleted;
            driver_s_(sync);
        };
    }
    void TearDown() override {
        epoxy_glDeleteSync = driver_s_;
        Gpu::TearDown();
    }
    static void draw() { glClear(GL_COLOR_BUFFER_BIT); }

    static inline PFNGLDELETESYNCPROC driver_s_ = nullptr;
};

TEST_F(SyncsOnGpu, OneThatIsDoneIsDeletedWhenALaterOneIsDone) {
    Fence first(std::make_shared<Fences>());
    draw();
    first.set();
    ASSERT_TRUE(first.is_done_within(10s));
    EXPECT_EQ(deleted, 0) << "the thread that signalled it may not have left it";
    draw();
    first.set();
    EXPECT_EQ(deleted, 0);
    ASSERT_TRUE(first.is_done_within(10s));
    EXPECT_EQ(deleted, 1);
}

TEST_F(SyncsOnGpu, OneOfAnotherFenceDoesAsWell) {
    const auto all = std::make_shared<Fences>();
    Fence other(all);
    {
        Fence passing(all);
        draw();
        passing.set();
        ASSERT_TRUE(passing.is_done_within(10s));
    }
    EXPECT_EQ(deleted, 0);
    draw();
    other.set();
    ASSERT_TRUE(other.is_done_within(10s));
    EXPECT_EQ(deleted, 1);
}

TEST_F(SyncsOnGpu, OneThatNobodyWaitedForGoesToo) {
    const auto all = std::make_shared<Fences>();
    Fence fence(all);
    for (int i = 0; i < 100; ++i) {
        draw();
        fence.set();  // the ones before it are given up
    }
    ASSERT_TRUE(fence.is_done_within(10s));
    EXPECT_EQ(deleted, 99);
}

TEST_F(SyncsOnGpu, NoneOutlivesWhatKeepsThem) {
    {
        Fence fence(std::make_shared<Fences>());
        draw();
        fence.set();
        draw();
        fence.set();
    }
    EXPECT_EQ(deleted, 2);
}

TEST_F(SyncsOnGpu, AFenceThatWasNeverSetIsDone) {
    Fence fence(std::make_shared<Fences>());
    EXPECT_TRUE(fence.is_done_within(0s));
}

}  // namespace
}  // namespace quadrat::render::gl
