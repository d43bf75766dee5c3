// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gtest/gtest.h>

#include "stage/easel.hpp"
#include "stage/spoken.hpp"
#include "stage/stage.hpp"

namespace quadrat::stage {

inline constexpr std::array kSizes{TextSize::Normal, TextSize::Large, TextSize::Largest};
inline constexpr std::array kSizeNames{"normal", "large", "largest"};

// A stage as large as the smallest screen that exhibits have.
class ALegibleStage : public testing::Test {
  protected:
    static constexpr int kWidth = 1280, kHeight = 720;
    ALegibleStage() : easel_(kWidth, kHeight), stage_(easel_.renderer(), configuration_) {
        const auto scene = nursery::grow(genome::random_recipe(base::Seed{1}), {65, 64, 128});
        const Shown shown{scene, upload_now(easel_.renderer(), scene)};
        four_.scenes.assign(4, shown);
        one_.scenes = {shown};
        canvas_ = easel_.display().begin_frame();
    }
    render::Frame frame(exhibit::Screen screen, base::Instant now = std::chrono::seconds{10}) {
        state_.screen = screen;
        const bool is_four =
            screen == exhibit::Screen::Ask || screen == exhibit::Screen::Breed || screen == exhibit::Screen::StillThere;
        StageView view{state_, timings_, is_four ? four_ : one_, flash_, 0.5F, now, caption_};
        view.asked = asked_ ? &*asked_ : nullptr;
        view.scanned = scanned_ ? &*scanned_ : nullptr;
        if (screen == exhibit::Screen::Finale) view.take_home = take_home_;
        return stage_.frame(view, canvas_);
    }
    void expect_within(const render::Frame& drawn, const std::string& what) {
        for (const render::Sign& sign : drawn.signs) {
            EXPECT_GE(sign.place.x, 0) << what;
            EXPECT_GE(sign.place.y, 0) << what;
            EXPECT_LE(sign.place.x + sign.place.width, kWidth) << what;
            EXPECT_LE(sign.place.y + sign.place.height, kHeight) << what;
        }
    }
    // Each word on the ground that it was given: the last plain rectangle before it that is filled.
    void expect_words_on_their_ground(const render::Frame& drawn, const std::string& what) {
        const render::Sign* ground = nullptr;
        for (const render::Sign& sign : drawn.signs) {
            if (!sign.texture && sign.border_px == 0 && sign.colour.a < 1 && sign.colour.r < 0.5F) ground = &sign;
            if (!sign.texture || ground == nullptr) continue;
            EXPECT_GE(sign.place.x, ground->place.x) << what;
            EXPECT_GE(sign.place.y, ground->place.y) << what;
            EXPECT_LE(sign.place.x + sign.place.width, ground->place.x + ground->place.width) << what;
            EXPECT_LE(sign.place.y + sign.place.height, ground->place.y + ground->place.height) << what;
        }
    }

    site::Configuration configuration_;
    Easel easel_;
    Stage stage_;
    display::Canvas canvas_;
    exhibit::State state_;
    exhibit::Timings timings_;
    Cast four_, one_;
    std::optional<Flash> flash_;
    std::string caption_;
    std::string take_home_;
    std::optional<Asked> asked_;
    std::optional<Scanned> scanned_;
};

// A tree with a branch, that has been walked to one of its nodes; and a long visit.
inline std::vector<exhibit::Ancestor> family_of(int rounds) {
    std::vector<exhibit::Ancestor> family{{-1, {}, true}};
    for (int round = 0; round < rounds; ++round) {
        exhibit::Ancestor next{static_cast<int>(family.size()) - 1, {}, true};
        next.pick.each = {round % 4, (round + 1) % 4, (round + 1) % 4};
        family.push_back(next);
    }
    family.push_back({1, family.back().pick, true});
    family.push_back({1, family.back().pick, true});
    family[static_cast<std::size_t>(rounds)].was_seen = false;
    return family;
}

}  // namespace quadrat::stage
