// SPDX-License-Identifier: Apache-2.0
// The finale's code, read back from the picture as a telephone reads it from the screen: by zbar.
#include <gtest/gtest.h>

#include "genome/scene_code.hpp"
#include "genome/speech.hpp"
#include "pictures/picture.hpp"
#include "render/code_picture.hpp"
#include "stage/easel.hpp"
#include "stage/spoken.hpp"
#include "stage/stage.hpp"
#include "support/process.hpp"

namespace quadrat::stage {
namespace {

using namespace std::chrono_literals;

// What zbar reads in the picture, a line for each code; "" for none.
std::string read_by_zbar(const mesh::Image& picture) {
    const tests::TemporaryFolder folder;
    pictures::write_image(folder / "screen.png", picture);
    const tests::Ended ended = tests::run({"zbarimg", "--quiet", "--raw", "screen.png"}, folder);
    return ended.status == 0 ? ended.out : "";
}

struct Screen {
    int width;
    int height;
};
void PrintTo(const Screen& screen, std::ostream* os) { *os << screen.width << "x" << screen.height; }

class Finale : public testing::TestWithParam<Screen> {
  protected:
    Finale() : easel_(GetParam().width, GetParam().height), stage_(easel_.renderer(), configuration_) {
        const auto scene = nursery::grow(genome::random_recipe(base::Seed{1}), {65, 64, 128});
        cast_.scenes = {{scene, upload_now(easel_.renderer(), scene)}};
        state_.screen = exhibit::Screen::Finale;
    }
    render::Frame frame() {
        StageView view{state_, timings_, cast_, flash_, 0, 10s, caption_};
        view.take_home = take_home_;
        view.language = configuration_.visit.language;
        view.asked = asked_ ? &*asked_ : nullptr;
        return stage_.frame(view, easel_.display().begin_frame());
    }
    mesh::Image drawn() {
        const render::Frame f = frame();
        easel_.renderer().draw(f);
        return easel_.renderer().read_pixels(f);
    }

    site::Configuration configuration_;
    Easel easel_;
    Stage stage_;
    exhibit::State state_;
    exhibit::Timings timings_;
    Cast cast_;
    std::optional<Flash> flash_;
    std::string caption_ = genome::language("en").describe(genome::Description{});
    std::string take_home_;
    std::optional<Asked> asked_;
};
INSTANTIATE_TEST_SUITE_P(Sizes, Finale, testing::Values(Screen{1280, 720}, Screen{1920, 1080}, Screen{2560, 1440}));

TEST_P(Finale, HasACodeThatZbarReadsAtEverySizeOfText) {
    const genome::Recipe recipe = genome::random_recipe(base::Seed{GetParam().height + 0U});
    take_home_ = "https://museum.example/a/path/of/its/own/quadrat/" + genome::code_of(recipe);
    for (const char* size : {"normal", "large", "largest"})
        for (const char* language : {"en", "ar"}) {
            configuration_.look.size = size;
            configuration_.visit.language = language;
            const render::Frame f = frame();
            for (const render::Sign& sign : f.signs) {
                EXPECT_GE(sign.place.y, 0) << size;
                EXPECT_LE(sign.place.x + sign.place.width, GetParam().width) << size;
                EXPECT_LE(sign.place.y + sign.place.height, GetParam().height) << size;
            }
            EXPECT_GT(f.signs.back().place.height, GetParam().height / 36) << "what it is for is read too";
            EXPECT_EQ(read_by_zbar(drawn()), take_home_ + "\n") << size << " " << language;
        }
}

// With its four labels, which leave the less room the larger they are.
TEST_P(Finale, HasACodeThatZbarReadsWhereItAsksToo) {
    take_home_ = "https://museum.example/quadrat/#" + genome::code_of(genome::random_recipe(base::Seed{7}));
    timings_.can_print = true;
    state_.finale_asks = true;
    state_.family = {{-1, {}, true}, {0, {}, false}};
    state_.here = 1;
    for (const char* size : {"normal", "large", "largest"})
        for (const char* language : {"en", "ar", "el"}) {
            configuration_.look.size = size;
            configuration_.visit.language = language;
            asked_ = asked_of(state_, timings_, Spoken(configuration_), std::nullopt);
            ASSERT_TRUE(asked_);
            EXPECT_EQ(read_by_zbar(drawn()), take_home_ + "\n") << size << " " << language;
            std::vector<render::Rect> grounds;
            for (const render::Sign& sign : frame().signs) {
                EXPECT_GE(sign.place.x, 0) << size << " " << language;
                EXPECT_LE(sign.place.x + sign.place.width, GetParam().width) << size << " " << language;
                if (!sign.texture && sign.border_px == 0 && sign.colour.a < 1 && sign.colour.r < 0.5F)
                    grounds.push_back(sign.place);
            }
            ASSERT_EQ(grounds.size(), 6U) << "a statement, the code, four labels";
            for (std::size_t i = 0; i < grounds.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_TRUE(grounds[i].x + grounds[i].width <= grounds[j].x ||
                                grounds[j].x + grounds[j].width <= grounds[i].x ||
                                grounds[i].y + grounds[i].height <= grounds[j].y ||
                                grounds[j].y + grounds[j].height <= grounds[i].y)
                        << size << " " << language;
        }
}

TEST_P(Finale, HasNoCodeWhereTheSiteSaysNothing) {
    const std::size_t without = frame().signs.size();
    EXPECT_EQ(read_by_zbar(drawn()), "");
    take_home_ = "https://museum.example/" + genome::code_of(genome::Recipe{});
    EXPECT_EQ(frame().signs.size(), without + 3) << "a ground, what it is for, the code";
    state_.screen = exhibit::Screen::Attract;
    configuration_.play.shows_how = false;
    EXPECT_LE(frame().signs.size(), without) << "it is the finale's alone";
}

TEST(CodePicture, HasWholeModulesAndAQuietZoneAndIsLeftOutWhereItHasNoRoom) {
    const mesh::Image code = render::code_picture("HTTPS://MUSEUM.EXAMPLE/", 200);
    ASSERT_GT(code.width, 100);
    EXPECT_LE(code.width, 200);
    const int module = code.width / 29;  // version 1 has 21 modules, and 4 on either side
    EXPECT_EQ(code.width, 29 * module);
    for (int x = 0; x < code.width; ++x) EXPECT_EQ(code.pixel(x, 4 * module - 1)[0], 255) << x;
    EXPECT_EQ(code.pixel(4 * module, 4 * module)[0], 0) << "the corner of a finder";
    EXPECT_EQ(render::code_picture("HTTPS://MUSEUM.EXAMPLE/", 28).width, 0);
    EXPECT_EQ(render::code_picture(std::string(4000, 'a'), 4000).width, 0) << "more than a code can hold";
}

}  // namespace
}  // namespace quadrat::stage
