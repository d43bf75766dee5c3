// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gtest/gtest.h>

#include <memory>

#include "display/display.hpp"
#include "render/gl/limits.hpp"
#include "render/renderer.hpp"

namespace quadrat::tests {

// A headless display and a renderer on it. At a test's end nothing may have been done that a Raspberry Pi cannot.
class Stage : public testing::Test {
  protected:
    void SetUp() override {
        render::gl::limits::forget_breaches();
        open({640, 360});
    }
    // What was drawn with before is gone, and all that it made must be.
    void open(display::Size size) {
        renderer_.reset();
        display::DisplayOptions options;
        options.kind = display::Kind::Headless;
        options.size = size;
        display_ = display::open_display(options);
        canvas_ = display_->begin_frame();
        renderer_ = std::make_unique<render::Renderer>();
    }
    void TearDown() override {
        renderer_.reset();
        for (const std::string& line : render::gl::limits::breaches()) ADD_FAILURE() << line;
    }

    std::shared_ptr<const render::GpuScene> uploaded(std::shared_ptr<const scene::Scene> scene) {
        const auto upload = renderer_->begin_upload(std::move(scene));
        while (!upload->advance(std::size_t{1} << 20U)) continue;
        return upload->take();
    }
    render::Frame frame() const {
        render::Frame f;
        f.size = {canvas_.size.width, canvas_.size.height};
        f.framebuffer = canvas_.framebuffer;
        f.seconds = 3;
        return f;
    }
    mesh::Image drawn(const render::Frame& f) {
        renderer_->draw(f);
        return renderer_->read_pixels(f);
    }

    std::unique_ptr<display::Display> display_;
    display::Canvas canvas_;
    std::unique_ptr<render::Renderer> renderer_;
};

}  // namespace quadrat::tests
