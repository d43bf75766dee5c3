// SPDX-License-Identifier: Apache-2.0
// The finale's code, read back from the picture as a telephone reads it from the screen: by zbar.
#include <gtest/gtest.h>

#include "genome/scene_code.hpp"
#include "genome/speech.hpp"
#include "pictures/picture.hpp"
#include "render/code_picture.hpp"
#include "stage/easel.hpp"
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
            EXPECT_GT(f.signs[f.signs.size() - 2].place.height, GetParam().height / 36) << "what it is for is read too";
            EXPECT_EQ(read_by_zbar(drawn()), take_home_ + "\n") << size << " " << language;
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
