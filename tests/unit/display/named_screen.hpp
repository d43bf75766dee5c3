// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <utility>

#include "display/display.hpp"

namespace quadrat::tests {

// A display without a GPU that calls itself what it is told to.
class NamedScreen final : public display::Display {
  public:
    explicit NamedScreen(std::string renderer, std::string rest = "")
        : Display("named"), renderer_(std::move(renderer)), rest_(std::move(rest)) {}
    void becomes(std::string renderer, std::string rest) {
        renderer_ = std::move(renderer);
        rest_ = std::move(rest);
    }
    std::string_view kind() const override { return "named"; }
    std::string description() const override { return renderer_ + ", " + rest_; }
    std::string renderer() const override { return renderer_; }
    display::Canvas canvas() const override { return {}; }
    display::Canvas begin_frame() override { return {}; }
    display::Presented present(const tempo::HandOver&) override { return {}; }
    void set_power(display::Power) override {}

  private:
    std::string renderer_, rest_;
};

}  // namespace quadrat::tests
