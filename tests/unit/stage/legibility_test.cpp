// SPDX-License-Identifier: Apache-2.0
#include "stage/legibility.hpp"

#include <gtest/gtest.h>

#include "genome/scene_code.hpp"
#include "genome/speech.hpp"
#include "render/lettering.hpp"
#include "unit/stage/legible_stage.hpp"

namespace quadrat::stage {
namespace {

using namespace std::chrono_literals;

// What an eye sees of a height from three metres, on a screen of 24 inches, by trigonometry.
double arcmin_of(double px, int height_px) {
    constexpr double kScreen_mm = 298.9, kDistance_mm = 3000, kArcminARadian = 60 * 180 / 3.14159265358979;
    return 2 * std::atan(px / height_px * kScreen_mm / 2 / kDistance_mm) * kArcminARadian;
}

// Rows of the image in which there is ink.
int ink_height_px(const mesh::Image& image) {
    int first = image.height, last = -1;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (image.pixel(x, y)[3] > 127) first = std::min(first, y), last = y;
    return last < 0 ? 0 : last - first + 1;
}

TEST(Legibility, CapitalsAreAsHighAsTheTableSaysWhenTheyAreDrawn) {
    constexpr double kPromised[3][4] = {{12, 14.4, 9, 10}, {16, 19.2, 12, 13.3}, {20, 24, 15, 16.7}};
    for (const int height : {720, 1080, 2160})
        for (std::size_t size = 0; size < 3; ++size)
            for (std::size_t which = 0; which < 4; ++which) {
                render::TextStyle style;
                style.size_px = em_px(static_cast<Letters>(which), kSizes[size], height);
                style.is_bold = which != 2;
                style.shadow_px = 0;
                const int drawn = ink_height_px(render::letter("H", style));
                const double a_pixel = arcmin_of(1, height);
                EXPECT_NEAR(arcmin_of(drawn, height), kPromised[size][which],
                            1.2 * a_pixel + 0.025 * kPromised[size][which])
                    << height << " " << kSizeNames[size] << " " << which;
            }
}

TEST(Legibility, TheLetterInEveryBadgeIsAtLeastAsHighAsALabels) {
    for (const int height : {720, 1080})
        for (const TextSize size : kSizes)
            for (std::size_t i = 0; i < kQuarters; ++i) {
                const Quarter& q = quarter(i);
                const int side = badge_px(size, height);
                const mesh::Image with = render::badge(q.shape, q.letter, q.colour, side);
                const mesh::Image without = render::badge(q.shape, "", q.colour, side);
                int first = side, last = -1;
                for (int y = 0; y < side; ++y)
                    for (int x = 0; x < side; ++x)
                        if (std::abs(with.pixel(x, y)[1] - without.pixel(x, y)[1]) > 60)
                            first = std::min(first, y), last = y;
                const double seen = arcmin_of(last - first + 1, height);
                EXPECT_GE(seen, capitals_arcmin(Letters::Label, size) - 1.2 * arcmin_of(1, height)) << q.letter;
            }
}

double luminance(const glm::vec3& srgb) {
    double sum = 0;
    constexpr double kShares[] = {0.2126, 0.7152, 0.0722};
    for (int i = 0; i < 3; ++i) {
        const double c = static_cast<double>(srgb[i]);
        sum += kShares[i] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    return sum;
}

TEST(Legibility, WhiteOnAPlateHasItsContrastOverTheBrightestPicture) {
    const auto contrast = [](bool is_high) {
        const glm::vec4 plate = plate_colour({TextSize::Normal, is_high, false});
        return 1.05 / (luminance(glm::vec3(plate) * plate.a + (1 - plate.a)) + 0.05);
    };
    EXPECT_GE(contrast(false), 7);
    EXPECT_GE(contrast(true), 18);
}

TEST_F(ALegibleStage, HasRoomForEveryPromptOfEveryLanguageAtEverySize) {
    using exhibit::Screen;
    for (const std::string_view code : genome::language_codes())
        for (const char* size : kSizeNames)
            for (const std::string_view key : genome::kPrompts) {
                configuration_.look.size = size;
                configuration_.look.contrast = key == "breed" ? "high" : "normal";
                configuration_.visit.language = std::string(code);
                const std::string words(genome::prompt(code, key));
                const std::string what = std::string(code) + " " + size + " " + std::string(key);
                configuration_.texts = {{"ask.trees", words},
                                        {"finale", words},
                                        {"still-there", words},
                                        {"scan.one", words},
                                        {"back", words}};
                caption_ = genome::language(code).describe(genome::Description{});
                scanned_ = Scanned{exhibit::Choice::Back, "scan.one", true};
                for (const Screen screen : {Screen::Ask, Screen::Breed, Screen::StillThere, Screen::Finale}) {
                    if (screen != Screen::Ask) scanned_.reset();
                    const render::Frame drawn = frame(screen);
                    expect_within(drawn, what);
                    if (screen != Screen::Ask) expect_words_on_their_ground(drawn, what);
                }
            }
}

// Each prompt where it stands in a visit: what has no room on its line is broken, and then made smaller, but not so
// small that it would not be read from three metres.
TEST_F(ALegibleStage, WritesNothingMuchSmallerThanItShouldBeInAnyLanguage) {
    using exhibit::Screen;
    timings_.can_print = timings_.can_breed_on = true;
    take_home_ = "https://museum.example/quadrat/#" + genome::code_of(genome::Recipe{});
    state_.family = family_of(6);
    state_.here = 6;
    const std::array screens{Screen::Attract,    Screen::Language, Screen::Ask,   Screen::Breed,
                             Screen::StillThere, Screen::Finale,   Screen::Family};
    for (const std::string_view code : genome::language_codes())
        for (std::size_t size = 0; size < kSizes.size(); ++size) {
            configuration_.look.size = kSizeNames[size];
            configuration_.visit.language = std::string(code);
            caption_ = genome::language(code).describe(genome::Description{});
            const Spoken spoken(configuration_);
            stage_.writer().forget_tightest();
            for (const Screen screen : screens)
                for (const char* hint : {"", "invite.one", "invite.two", "hold.one", "hold.two", "scan.one",
                                         "scan.step", "scan.two", "scan.rest", "hear.again"}) {
                    const bool is_invited = std::string_view(hint).starts_with("invite.");
                    if (is_invited != (screen == Screen::Attract) && *hint != 0) continue;
                    state_.screen = screen;
                    state_.walked = screen == Screen::Family ? 1 : 6;
                    state_.finale_asks = screen == Screen::Finale;
                    state_.is_printed = *hint == 0;
                    asked_ = asked_of(state_, timings_, spoken, std::nullopt);
                    scanned_ = *hint == 0 ? std::nullopt : std::optional(Scanned{{}, hint, !is_invited});
                    for (const genome::Aspect aspect : genome::kAspects) {
                        state_.question = aspect;
                        expect_within(frame(screen, screen == Screen::Attract ? 9700ms : 3s), std::string(code));
                        if (screen != Screen::Ask) break;
                    }
                }
            // Than what stands below a question of normal size, but for an eighth.
            const float smallest = 0.875F * capitals_arcmin(Letters::Below, TextSize::Normal) /
                                   capitals_arcmin(Letters::Below, kSizes[size]);
            EXPECT_GE(stage_.writer().tightest().share, smallest)
                << code << " " << kSizeNames[size] << ": " << stage_.writer().tightest().utf8;
        }
}

TEST_F(ALegibleStage, HasRoomForTheLabelsOfEveryWordBelowTheirQuestionAtEverySize) {
    for (const std::string_view code : genome::language_codes())
        for (const char* size : kSizeNames)
            for (const genome::Word& word : genome::vocabulary()) {
                configuration_.look.size = size;
                configuration_.visit.language = std::string(code);
                asked_ = Asked{"describe." + std::string(name_of(word.aspect)), genome::language(code).answers(word.id),
                               std::nullopt};
                scanned_ = Scanned{{}, "scan.two", true};
                const render::Frame drawn = frame(exhibit::Screen::Describe);
                const std::string what = std::string(code) + " " + size + " " + std::string(word.name);
                expect_within(drawn, what);
                expect_words_on_their_ground(drawn, what);
                // Plate, question, hint, pictogram, ground of Back, Back; then four times ground, badge and words.
                ASSERT_EQ(drawn.signs.size(), 6U + 12U) << what;
                const render::Rect& back = drawn.signs[4].place;
                for (std::size_t label = 0; label < 2; ++label) {
                    const render::Rect& upper = drawn.signs[6 + 3 * label].place;
                    const bool is_beside = upper.x + upper.width <= back.x || upper.x >= back.x + back.width;
                    EXPECT_TRUE(is_beside || upper.y + upper.height <= back.y) << what;
                    EXPECT_LE(upper.y + upper.height, drawn.signs[0].place.y) << what;
                }
            }
}

// What words stand on: filled, dark, and not quite opaque.
std::vector<render::Rect> grounds_of(const render::Frame& drawn) {
    std::vector<render::Rect> grounds;
    for (const render::Sign& sign : drawn.signs)
        if (!sign.texture && sign.border_px == 0 && sign.colour.a < 1 && sign.colour.r < 0.5F)
            grounds.push_back(sign.place);
    return grounds;
}

bool are_apart(const render::Rect& a, const render::Rect& b) {
    return a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;
}

TEST_F(ALegibleStage, KeepsTheSliderApartFromAllElseAtEverySize) {
    for (const std::string_view code : genome::language_codes())
        for (const char* size : kSizeNames)
            for (const genome::Word& word : genome::vocabulary()) {
                configuration_.look.size = size;
                configuration_.visit.language = std::string(code);
                const genome::Language& language = genome::language(code);
                asked_ = Asked{"slide",
                               {"←", "→", "−", "+"},
                               ShownSlider{std::string(language.end(word.id, false)),
                                           std::string(language.end(word.id, true)), 0.5F}};
                scanned_ = Scanned{{}, "scan.two", true};
                const render::Frame drawn = frame(exhibit::Screen::Slide);
                const std::string what = std::string(code) + " " + size + " " + std::string(word.name);
                expect_within(drawn, what);
                expect_words_on_their_ground(drawn, what);
                const std::vector<render::Rect> grounds = grounds_of(drawn);
                ASSERT_EQ(grounds.size(), 7U) << what << ": a question, Back, four labels, a slider";
                for (std::size_t i = 0; i < grounds.size(); ++i)
                    for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE(are_apart(grounds[i], grounds[j])) << what;
            }
}

TEST_F(ALegibleStage, HasRoomForWhatAFinaleOffersInEveryLanguageAtEverySize) {
    using exhibit::Screen;
    timings_.can_print = true;
    state_.finale_asks = true;
    state_.family = family_of(6);
    state_.here = 6;
    for (const std::string_view code : genome::language_codes())
        for (const char* size : kSizeNames)
            for (const Screen screen : {Screen::Finale, Screen::Family})
                for (const int walked : {0, 1, 4, 6, 8}) {
                    configuration_.look.size = size;
                    configuration_.visit.language = std::string(code);
                    Spoken spoken(configuration_);
                    state_.screen = screen;
                    state_.walked = walked;
                    state_.is_printed = walked == 4;
                    asked_ = asked_of(state_, timings_, spoken, std::nullopt);
                    ASSERT_TRUE(asked_);
                    caption_ = genome::language(code).describe(genome::Description{});
                    const render::Frame drawn = frame(screen);
                    const std::string what = std::string(code) + " " + size + " " + std::to_string(walked);
                    expect_within(drawn, what);
                    if (screen == Screen::Family) continue;
                    expect_words_on_their_ground(drawn, what);
                    const std::vector<render::Rect> grounds = grounds_of(drawn);
                    ASSERT_EQ(grounds.size(), 5U) << what << ": a statement, four labels";
                    for (std::size_t i = 0; i < grounds.size(); ++i)
                        for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE(are_apart(grounds[i], grounds[j])) << what;
                }
}

// The large card is where it was walked to, and no card lies on another, whatever the tree.
TEST_F(ALegibleStage, DrawsAFamilyTreeOfWhichNoCardLiesOnAnother) {
    state_.finale_asks = true;
    for (const int rounds : {1, 3, 8, 20})
        for (int walked = 0; walked <= rounds + 2; ++walked) {
            state_.family = family_of(rounds);
            state_.here = rounds;
            state_.walked = walked;
            state_.screen = exhibit::Screen::Family;
            asked_ = asked_of(state_, timings_, Spoken(configuration_), std::nullopt);
            const render::Frame drawn = frame(exhibit::Screen::Family);
            std::vector<render::Rect> cards;
            for (const render::Sign& sign : drawn.signs)
                if (!sign.texture && sign.colour.a == 1 && sign.colour.b > 0.11F && sign.colour.b < 0.13F)
                    cards.push_back(sign.place);
            ASSERT_GE(cards.size(), 1U);
            EXPECT_LE(cards.size(), state_.family.size());
            for (std::size_t i = 0; i < cards.size(); ++i) {
                EXPECT_LE(cards[i].width, cards.back().width) << "the last is the large one";
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_TRUE(are_apart(cards[i], cards[j])) << rounds << " " << walked;
            }
            if (rounds <= 8) {
                EXPECT_GE(cards.size(), static_cast<std::size_t>(rounds)) << walked;
            }
        }
}

TEST_F(ALegibleStage, ShowsTheFamilyTreeApartFromAllWordsAtEverySizeWithBackToo) {
    state_.screen = exhibit::Screen::Family;
    state_.finale_asks = true;
    state_.family = family_of(5);
    state_.here = 5;
    state_.walked = 1;
    asked_ = asked_of(state_, timings_, Spoken(configuration_), std::nullopt);
    caption_ = genome::language("en").describe(genome::Description{});
    for (const char* size : kSizeNames)
        for (const bool offers_back : {false, true}) {
            configuration_.look.size = size;
            scanned_ = Scanned{exhibit::Choice::Back, "scan.one", offers_back};
            const render::Frame drawn = frame(exhibit::Screen::Family);
            expect_within(drawn, size);
            std::vector<render::Rect> grounds = grounds_of(drawn), cards;
            for (const render::Sign& sign : drawn.signs)
                if (!sign.texture && sign.colour.a == 1 && sign.colour.b > 0.11F && sign.colour.b < 0.13F)
                    cards.push_back(sign.place);
            ASSERT_GE(cards.size(), 3U) << size;
            EXPECT_GT(cards.back().height, kHeight / 5) << size << ": the large one";
            // What was chosen lies on grounds within it.
            std::erase_if(grounds, [&](const render::Rect& ground) {
                return ground.y >= cards.back().y && ground.y + ground.height <= cards.back().y + cards.back().height &&
                       ground.x >= cards.back().x && ground.x + ground.width <= cards.back().x + cards.back().width;
            });
            const auto labels = std::ranges::count_if(asked_->labels, [](const auto& label) { return !label.empty(); });
            EXPECT_EQ(std::ssize(grounds), labels + (offers_back ? 2 : 1)) << "the plate, the labels, Back";
            for (const render::Rect& card : cards)
                for (const render::Rect& ground : grounds) EXPECT_TRUE(are_apart(card, ground)) << size;
            for (std::size_t i = 0; i < grounds.size(); ++i)
                for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE(are_apart(grounds[i], grounds[j])) << size;
        }
}

TEST_F(ALegibleStage, OffersToBreedOnAndToTakeTurnsInEveryLanguageAtEverySize) {
    using exhibit::Screen;
    for (const std::string_view code : genome::language_codes())
        for (const char* size : kSizeNames) {
            configuration_.look.size = size;
            configuration_.visit.language = std::string(code);
            const std::string what = std::string(code) + " " + size;
            timings_ = {};
            const std::size_t without = frame(Screen::Attract, 3s).signs.size();
            timings_.can_breed_on = true;
            const render::Frame attract = frame(Screen::Attract, 3s);
            EXPECT_EQ(attract.signs.size(), without + 3) << what;
            expect_within(attract, what);
            expect_words_on_their_ground(attract, what);
            const std::vector<render::Rect> grounds = grounds_of(attract);
            ASSERT_EQ(grounds.size(), 2U);
            EXPECT_TRUE(are_apart(grounds[0], grounds[1])) << what;
            timings_ = {};
            state_.rounds = 1;
            const std::size_t alone = frame(Screen::Ask).signs.size();
            timings_.turns = exhibit::TakingTurns::Always;
            const render::Frame group = frame(Screen::Ask);
            EXPECT_EQ(group.signs.size(), alone + 4) << "three people on a ground";
            state_.rounds = 0;
            const render::Frame first = frame(Screen::Ask);
            EXPECT_EQ(first.signs.size(), group.signs.size() + 1) << "and, at first, what to do";
            expect_within(first, what);
            expect_within(group, what);
        }
}

TEST_F(ALegibleStage, HasRoomForTheGhostThatShowsHowItIsPlayedInEveryLanguageAtEverySize) {
    for (const std::string_view code : genome::language_codes())
        for (const char* size : kSizeNames)
            for (const char* motion : {"full", "calm"}) {
                configuration_.look.size = size;
                configuration_.look.motion = motion;
                configuration_.visit.language = std::string(code);
                scanned_ = Scanned{{}, "invite.two"};
                const render::Frame drawn = frame(exhibit::Screen::Attract, 9700ms);
                EXPECT_GT(drawn.signs.size(), 8U);
                expect_within(drawn, std::string(code) + " " + size + " " + motion);
                expect_words_on_their_ground(drawn, std::string(code) + " " + size + " " + motion);
            }
}

// Of each aspect that was judged its pictogram and the badge of the button, which come from its quarter to the middle.
TEST_F(ALegibleStage, ShowsWhatTheNextFourGrowFrom) {
    const std::size_t without = frame(exhibit::Screen::Breed, 2000ms).signs.size();
    genome::Pick pick;
    pick.each = {3, 0, 1};
    state_.past_answers = {pick};
    const render::Frame arrived = frame(exhibit::Screen::Breed, 2000ms);
    ASSERT_EQ(arrived.signs.size(), without + 7);
    expect_within(arrived, "arrived");
    const render::Rect card = arrived.signs[without].place;
    for (std::size_t i = without + 1; i < arrived.signs.size(); ++i) {
        EXPECT_GE(arrived.signs[i].place.x, card.x);
        EXPECT_LE(arrived.signs[i].place.x + arrived.signs[i].place.width, card.x + card.width);
    }
    const render::Frame leaving = frame(exhibit::Screen::Breed, 10ms);
    const auto places = quarters(leaving.size.x, leaving.size.y);
    const auto badge_of = [&](std::size_t aspect) { return leaving.signs[without + 2 + 2 * aspect].place; };
    for (const auto& [aspect, from] : {std::pair{0U, 3U}, {1U, 0U}, {2U, 1U}}) {
        EXPECT_GE(badge_of(aspect).x, places[from].x);
        EXPECT_GE(badge_of(aspect).y, places[from].y);
    }
    configuration_.look.motion = "calm";
    EXPECT_EQ(frame(exhibit::Screen::Breed, 10ms).signs[without + 1].place.x, arrived.signs[without + 1].place.x);
}

TEST_F(ALegibleStage, LettersAndSignsGrowFromSizeToSize) {
    int last_height = 0, last_badge = 0;
    for (const char* size : kSizeNames) {
        configuration_.look.size = size;
        const render::Frame drawn = frame(exhibit::Screen::Ask);
        EXPECT_GT(drawn.signs[0].place.width, last_badge);
        EXPECT_GT(drawn.signs[5].place.height, last_height);
        last_badge = drawn.signs[0].place.width;
        last_height = drawn.signs[5].place.height;
    }
}

TEST_F(ALegibleStage, HighContrastOutlinesWhatWordsStandOn) {
    const std::size_t normal = frame(exhibit::Screen::Ask).signs.size();
    configuration_.look.contrast = "high";
    EXPECT_EQ(frame(exhibit::Screen::Ask).signs.size(), normal + 1);
}

TEST_F(ALegibleStage, OneOfSeveralThatHangGivesWayToTheNextThroughTheDark) {
    using exhibit::Screen;
    EXPECT_EQ(frame(Screen::Attract, 24s).views[0].dim, 0) << "one alone stays";
    one_.scenes = {four_.scenes[0], four_.scenes[1]};
    for (const auto clear : {0s, 2s, 12s, 22s, 26s, 36s}) EXPECT_EQ(frame(Screen::Attract, clear).views[0].dim, 0);
    EXPECT_GT(frame(Screen::Attract, 23'900ms).views[0].dim, 0.9F);
    EXPECT_GT(frame(Screen::Attract, 24'100ms).views[0].dim, 0.9F);
    EXPECT_NE(frame(Screen::Attract, 23'900ms).views[0].camera.eye_m,
              frame(Screen::Attract, 24'100ms).views[0].camera.eye_m)
        << "the flight goes on";
}

TEST_F(ALegibleStage, InCalmNothingFliesAndNothingGrowsIn) {
    using exhibit::Screen;
    for (const Screen screen : {Screen::Ask, Screen::Attract, Screen::Finale, Screen::Breed}) {
        configuration_.look.motion = "full";
        EXPECT_NE(frame(screen, 2s).views[0].camera.eye_m, frame(screen, 20s).views[0].camera.eye_m);
        EXPECT_LT(frame(screen, 1s).views[0].growth, 1);
        configuration_.look.motion = "calm";
        const render::Frame first = frame(screen, 0s), later = frame(screen, 20s);
        EXPECT_EQ(first.views[0].camera.eye_m, later.views[0].camera.eye_m);
        EXPECT_EQ(first.views[0].camera.target_m, later.views[0].camera.target_m);
        EXPECT_EQ(first.views[0].growth, 1);
        EXPECT_EQ(first.views[0].dim, 1) << "it comes out of the dark";
        EXPECT_LT(later.views[0].dim, 0.5F);
        EXPECT_GE(frame(screen, 700ms).views[0].dim, frame(screen, 800ms).views[0].dim);
    }
}

}  // namespace
}  // namespace quadrat::stage
