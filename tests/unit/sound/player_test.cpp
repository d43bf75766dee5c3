// SPDX-License-Identifier: Apache-2.0
#include "sound/player.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>

#include "sound/wav.hpp"
#include "support/process.hpp"

namespace quadrat::sound {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

// Whatever another thread does is there within a while, or never.
template <typename IsThere>
bool comes(const IsThere& is_there) {
    const auto until = std::chrono::steady_clock::now() + 20s;
    while (!is_there() && std::chrono::steady_clock::now() < until) std::this_thread::sleep_for(2ms);
    return is_there();
}

// What the tests do to a card, and what it was given.
struct Card {
    std::atomic<bool> is_plugged_in{true}, is_dry{false};
    std::atomic<int> opened{0}, asked{0}, blocks{0};
    std::atomic<float> loudest{0};
};

class FakeOutput final : public Output {
  public:
    explicit FakeOutput(Card& card) : card_(card) {}
    Outcome play(Block block) override {
        std::this_thread::sleep_for(1ms);  // the pace of a card
        if (!card_.is_plugged_in) return Outcome::Gone;
        for (const Frame& frame : block) card_.loudest = std::max(card_.loudest.load(), std::abs(frame.left));
        ++card_.blocks;
        return card_.is_dry.exchange(false) ? Outcome::Late : Outcome::Played;
    }
    std::string trouble() const override { return card_.is_plugged_in ? "" : "the card is gone"; }

  private:
    Card& card_;
};

OpenOutput opens(Card& card) {
    return [&card](std::string& trouble) -> std::unique_ptr<Output> {
        ++card.asked;
        if (!card.is_plugged_in) {
            trouble = "there is no card";
            return nullptr;
        }
        ++card.opened;
        return std::make_unique<FakeOutput>(card);
    };
}

const Soundscape& soundscape() {
    static const Soundscape once(base::Seed{1});
    return once;
}

TEST(APlayer, PlaysWhatItIsTold) {
    Card card;
    Player player(opens(card), soundscape(), {1, 1, 1, 1});
    ASSERT_TRUE(comes([&] { return card.blocks > 3; }));
    EXPECT_EQ(card.loudest, 0);
    player.tell(Sounds{Signal::Choice, 2});
    EXPECT_TRUE(comes([&] { return card.loudest > 0.1F; }));
    card.loudest = 0;
    player.say({1, std::make_shared<const std::vector<float>>(4'800, 0.9F)});
    EXPECT_TRUE(comes([&] { return card.loudest > 0.5F; }));
    EXPECT_TRUE(player.health().is_playing);
    EXPECT_EQ(player.health().trouble, "");
}

TEST(APlayer, WaitsForACardThatIsMissingAndTakesOneThatComesBack) {
    Card card;
    card.is_plugged_in = false;
    Player player(opens(card), soundscape(), {1, 1, 1, 1});
    ASSERT_TRUE(comes([&] { return player.health().trouble == "there is no card"; }));
    EXPECT_FALSE(player.health().is_playing);
    card.is_plugged_in = true;
    ASSERT_TRUE(comes([&] { return card.blocks > 0; }));
    EXPECT_TRUE(player.health().is_playing);
    EXPECT_EQ(player.health().trouble, "");
    card.is_plugged_in = false;
    ASSERT_TRUE(comes([&] { return !player.health().is_playing; }));
    EXPECT_THAT(player.health().trouble, testing::AnyOf("the card is gone", "there is no card"));
    card.is_plugged_in = true;
    ASSERT_TRUE(comes([&] { return card.opened == 2; }));
    EXPECT_LT(card.asked, 8) << "it is not asked for all the time";
}

TEST(APlayer, CountsGapsAndNeverLetsAnyoneWait) {
    Card card;
    card.is_dry = true;
    Player player(opens(card), soundscape(), {1, 1, 1, 1});
    ASSERT_TRUE(comes([&] { return player.health().underruns == 1; }));
    for (int i = 0; i < 5'000; ++i) player.tell(Sounds{});
    EXPECT_GT(player.health().dropped, 0U) << "more than can be heard";
}

// ALSA's own devices stand for cards: there is none on a machine that tests.
TEST(AnAlsaCard, ThatIsMissingSaysSoByItsName) {
    std::string trouble;
    EXPECT_EQ(open_alsa("hw:CARD=NoSuchCard", trouble), nullptr);
    EXPECT_THAT(trouble, HasSubstr("the sound card hw:CARD=NoSuchCard cannot be opened: "));
    EXPECT_EQ(trouble_with_alsa("hw:CARD=NoSuchCard"), trouble);
    EXPECT_EQ(trouble_with_alsa("null"), "");
}

TEST(AnAlsaCard, ThatSwallowsEverythingIsFedNoFasterThanItWouldPlay) {
    std::string trouble;
    const auto output = open_alsa("null", trouble);
    ASSERT_NE(output, nullptr) << trouble;
    std::vector<Frame> block(480);
    const auto since = std::chrono::steady_clock::now();
    for (int i = 0; i < 40; ++i) EXPECT_EQ(output->play(block), Output::Outcome::Played);
    EXPECT_GE(std::chrono::steady_clock::now() - since, 380ms);
}

TEST(AnAlsaCard, GetsWhatIsPlayedSampleBySample) {
    const tests::TemporaryFolder folder;
    const std::string file = (folder / "card.wav").string();
    std::vector<Frame> played(4'800);
    for (std::size_t i = 0; i < played.size(); ++i) {
        const float value = std::sin(0.03F * static_cast<float>(i));
        played[i] = {0.5F * value, 0.5F * value};
    }
    {
        std::string trouble;
        const auto output = open_alsa("file:\"" + file + "\",wav", trouble);
        ASSERT_NE(output, nullptr) << trouble;
        for (std::size_t at = 0; at < played.size(); at += 480)
            ASSERT_EQ(output->play(Block(played).subspan(at, 480)), Output::Outcome::Played);
    }
    const std::vector<float> heard = speech_from_wav(tests::contents_of(file), file);
    ASSERT_EQ(heard.size(), played.size());
    for (std::size_t i = 0; i < heard.size(); ++i) ASSERT_NEAR(heard[i], played[i].left, 1e-3F) << i;
}

}  // namespace
}  // namespace quadrat::sound
