// SPDX-License-Identifier: Apache-2.0
// What exhibits tell each other of landscapes, and whose of them one shows.
#include "fleet/favourites.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "base/error.hpp"
#include "genome/scene_code.hpp"

namespace quadrat::fleet {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::string code(std::uint64_t n) { return genome::code_of(genome::random_recipe(base::Seed{n})); }

std::string list_of(std::initializer_list<std::uint64_t> numbers) {
    std::vector<Favourite> favourites;
    for (const std::uint64_t n : numbers) favourites.push_back({code(n), ""});
    return to_text(favourites);
}

TEST(Favourites, SayALandscapeAndWhereItsPictureIsAndNothingElse) {
    const std::vector<Favourite> favourites{{code(1), "0123456789abcdef"}, {code(2), ""}};
    EXPECT_EQ(favourites_from(to_text(favourites)), favourites);
    const json said = json::parse(to_text(favourites));
    EXPECT_EQ(said.size(), 1U);
    for (const json& one : said.at("favourites"))
        for (const auto& [key, value] : one.items()) EXPECT_THAT(key, testing::AnyOf("code", "picture"));
    EXPECT_TRUE(favourites_from("").empty());
}

TEST(Favourites, AreTakenWithoutWhatStandsAroundTheirCodes) {
    const json said{{"favourites", {{{"code", "https://visitors.example/of-monday/" + code(3)}, {"who", "somebody"}}}}};
    EXPECT_EQ(to_text(favourites_from(said.dump())), list_of({3}));
    EXPECT_EQ(favourites_from(json{{"favourites", {{{"code", code(3)}}, {{"code", code(3)}}}}}.dump()).size(), 1U);
}

TEST(Favourites, ThatAreWrongAreRefusedWhole) {
    const auto refusal = [](const std::string& text, const std::string& why) {
        EXPECT_THAT([&] { favourites_from(text); }, ThrowsMessage<base::InputError>(HasSubstr(why))) << text;
    };
    refusal("hello", "it is no list of favourites");
    refusal("[]", "it is no list of favourites");
    refusal(R"({"favourites": 3})", "it is no list of favourites");
    refusal(R"({"favourites": [3]})", "a landscape has no code");
    refusal(R"({"favourites": [{}]})", "a landscape has no code");
    refusal(R"({"favourites": [{"code": "Q1-AAAA"}]})", "a landscape");
    refusal(R"({"favourites": [{"code": ")" + std::string(3000, 'A') + "\"}]}", "a code is too long");
    refusal(json{{"favourites", {{{"code", code(1)}, {"picture", "../../quadrat.db"}}}}}.dump(), "16 hexadecimal");
    refusal(list_of({1, 2, 3, 4, 5, 6, 7}), "more than 6 landscapes");
    refusal(std::string(kLongestList + 1, '['), "more than 8192 bytes");
    refusal(std::string(kLongestList, '['), "it is no list of favourites");
}

TEST(APictureOfAnother, IsAPngOfModestSize) {
    const auto png = [](int width, int height) {
        std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
        for (const int side : {width, height})
            for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(side >> shift & 0xff);
        return bytes + std::string(5, '\x8');
    };
    EXPECT_EQ(trouble_of_picture(png(480, 270)), "");
    EXPECT_THAT(trouble_of_picture(png(100'000, 270)), HasSubstr("100000 pixels wide or high"));
    EXPECT_THAT(trouble_of_picture(png(480, 961)), HasSubstr("961 pixels"));
    EXPECT_THAT(trouble_of_picture(png(0, 270)), HasSubstr("0 pixels"));
    EXPECT_EQ(trouble_of_picture(""), "it is no PNG");
    EXPECT_EQ(trouble_of_picture("GIF89a" + std::string(40, ' ')), "it is no PNG");
    EXPECT_THAT(trouble_of_picture(png(480, 270) + std::string(kLargestPicture, ' ')), HasSubstr("more than 524288"));
}

std::map<std::string, int> count_by_sender(const Guests& guests) {
    std::map<std::string, int> counts;
    for (const Guest& guest : guests.chosen()) ++counts[guest.from];
    return counts;
}

TEST(Guests, AreTheFirstOfEachExhibitBeforeTheSecondOfAny) {
    Guests guests("hall-1");
    guests.hear("hall-2", list_of({1, 2, 3, 4, 5, 6}));
    guests.hear("hall-3", list_of({11}));
    guests.hear("hall-4", list_of({21, 22, 23, 24, 25, 26}));
    guests.hear("hall-1", list_of({31}));
    EXPECT_TRUE(guests.look(Guests::Moment{}));
    EXPECT_FALSE(guests.look(Guests::Moment{} + 1s)) << "nothing new";
    EXPECT_EQ(guests.chosen().size(), Guests::kMost);
    const auto counts = count_by_sender(guests);
    EXPECT_EQ(counts, (std::map<std::string, int>{
                          {"hall-2", 6 - counts.at("hall-4") + 5}, {"hall-3", 1}, {"hall-4", counts.at("hall-4")}}));
    EXPECT_GE(counts.at("hall-4"), 5) << "its own are no guests, and no exhibit has more than its share";
}

TEST(Guests, ThatAreTakenBackGoAndWhatIsWrongChangesNothing) {
    Guests guests("hall-1");
    guests.hear("hall-2", list_of({1, 2}));
    ASSERT_TRUE(guests.look(Guests::Moment{}));
    guests.hear("hall-2", "what a pulled plug leaves");
    EXPECT_FALSE(guests.look(Guests::Moment{} + 61s));
    EXPECT_EQ(guests.chosen().size(), 2U);
    guests.hear("hall-2", list_of({2}));
    EXPECT_TRUE(guests.look(Guests::Moment{} + 122s));
    EXPECT_EQ(guests.chosen(), (std::vector<Guest>{{code(2), "hall-2", ""}}));
    guests.hear("hall-2", "");
    EXPECT_TRUE(guests.look(Guests::Moment{} + 183s));
    EXPECT_TRUE(guests.chosen().empty());
}

TEST(Guests, OfOneThatTalksWithoutEndAreReadOnceAMinuteAndThenItsLastWord) {
    Guests guests("hall-1");
    guests.hear("hall-2", list_of({1}));
    ASSERT_TRUE(guests.look(Guests::Moment{}));
    int changes = 0;
    for (auto now = Guests::Moment{} + 1s; now < Guests::Moment{} + 10min; now += 1s) {
        guests.hear("hall-2", list_of({static_cast<std::uint64_t>(2 + changes), 77}));
        changes += guests.look(now) ? 1 : 0;
    }
    EXPECT_EQ(changes, 9);
}

TEST(Guests, OfAThousandExhibitsAreFewAndAnotherChoiceForEach) {
    std::set<std::string> seen;
    for (int own = 0; own < 20; ++own) {
        Guests guests("hall-" + std::to_string(own));
        for (int other = 0; other < 1000; ++other)
            guests.hear("hall-" + std::to_string(other), list_of({static_cast<std::uint64_t>(other % 40)}));
        guests.look(Guests::Moment{});
        EXPECT_EQ(guests.chosen().size(), Guests::kMost);
        for (const Guest& guest : guests.chosen()) seen.insert(guest.from);
    }
    EXPECT_GT(seen.size(), 100U);
}

TEST(Guests, WhoseNameIsNoNameAreNotHeard) {
    Guests guests("hall-1");
    for (const std::string& name : {std::string(), std::string("hall\n2"), std::string(201, 'a')})
        guests.hear(name, list_of({1}));
    EXPECT_FALSE(guests.look(Guests::Moment{}));
}

}  // namespace
}  // namespace quadrat::fleet
