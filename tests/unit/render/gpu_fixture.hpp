// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gtest/gtest.h>

#include <memory>

#include "display/display.hpp"
#include "render/gl/limits.hpp"

namespace quadrat::render {

// A context, and a clean record of limits.
class Gpu : public testing::Test {
  protected:
    void SetUp() override {
        display::DisplayOptions options;
        options.kind = display::Kind::Headless;
        options.size = {64, 64};
        display_ = display::open_display(options);
        canvas_ = display_->begin_frame();
        gl::limits::forget_breaches();
    }
    void TearDown() override { gl::limits::forget_breaches(); }

    std::unique_ptr<display::Display> display_;
    display::Canvas canvas_;
};

}  // namespace quadrat::render
