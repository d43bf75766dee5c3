// SPDX-License-Identifier: Apache-2.0
// Which landscapes a curator is offered, and what comes of a choice.
#include "commands/curator_collection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "genome/scene_code.hpp"
#include "staff/landscapes.hpp"
#include "support/process.hpp"

namespace quadrat::commands {
namespace {

std::string code(std::uint64_t n) { return genome::code_of(genome::random_recipe(base::Seed{n})); }

class ACollection : public testing::Test {
  protected:
    ACollection() { folder_.write("quadrat.toml", "# nothing\n"); }
    void bred(std::uint64_t n) const {
        staff::keep_landscape(places_.lately, mesh::Image(4, 4, 4), code(n), staff::kMostBredLately);
    }
    site::Curation curation() const { return {folder_ / "quadrat.toml", folder_.path()}; }
    site::Configuration now() const { return curation().now().configuration; }
    std::vector<desk::Entry> offered() const {
        return collection_form(places_, now(), *desk::language_of("en")).groups[0].entries;
    }
    bool choose(const desk::Fields& fields) const {
        const bool is_other =
            curation().change(collection_edits(places_, fields, now(), curation().of_the_site().configuration), {});
        keep_chosen(places_, now());
        return is_other;
    }
    static std::string field(std::uint64_t n) { return "show." + staff::id_of_landscape(code(n)); }

    tests::TemporaryFolder folder_;
    CollectionPlaces places_{folder_ / "bred", folder_ / "collection", folder_ / "guests"};
};

TEST_F(ACollection, OffersEachOnceAndKeepsWhatIsChosen) {
    EXPECT_TRUE(offered().empty());
    for (std::uint64_t n = 1; n <= 3; ++n) bred(n);
    bred(2);
    ASSERT_EQ(offered().size(), 3U);
    EXPECT_FALSE(choose({})) << "nothing was said of any";
    EXPECT_TRUE(choose({{field(1), "favourite"}, {field(2), "hidden"}, {field(3), ""}}));
    EXPECT_THAT(now().attract.favourites, testing::ElementsAre(code(1)));
    EXPECT_THAT(now().attract.hidden, testing::ElementsAre(code(2)));
    EXPECT_EQ(offered().size(), 3U);
    EXPECT_EQ(offered()[0].value, "favourite") << "what is chosen comes first";
    std::filesystem::remove_all(places_.lately);
    EXPECT_EQ(offered().size(), 2U);
    EXPECT_TRUE(landscape_picture(places_, staff::id_of_landscape(code(1))));
    EXPECT_FALSE(choose({{field(1), "favourite"}, {field(2), "hidden"}}));
    EXPECT_TRUE(choose({{field(1), ""}}));
    EXPECT_FALSE(landscape_picture(places_, staff::id_of_landscape(code(1))));
    EXPECT_TRUE(curation().undo());
    EXPECT_EQ(offered().size(), 2U);
    EXPECT_EQ(offered()[0].picture, "") << "it can be chosen without its picture too";
    EXPECT_THROW(choose({{field(1), "sold"}}), base::InputError);
}

TEST_F(ACollection, OffersWhatOtherExhibitsShareAndKeepsWhereItIsFrom) {
    bred(1);
    staff::keep_guest(places_.guests, code(2), "hall-2");
    staff::keep_landscape(folder_ / "there", mesh::Image(4, 4, 4), code(2), 1);
    const std::string id = staff::id_of_landscape(code(2));
    staff::keep_picture_of_guest(places_.guests, code(2), tests::contents_of(folder_ / ("there/" + id + ".png")));
    EXPECT_FALSE(std::filesystem::exists(places_.guests / (id + ".foreign")));
    ASSERT_EQ(offered().size(), 2U);
    EXPECT_EQ(offered()[1].label, "Landscape 2, from hall-2");
    EXPECT_EQ(offered()[1].options[0].label, "not shown");
    EXPECT_NE(offered()[1].picture, "");
    EXPECT_TRUE(choose({{field(2), "favourite"}}));
    std::filesystem::remove_all(places_.guests);
    EXPECT_EQ(offered()[0].label, "Landscape 1, from hall-2") << "though hall-2 shares it no more";
    EXPECT_TRUE(landscape_picture(places_, id));
    folder_.write("quadrat.toml", "[fleet]\ntakes = \"all\"\n");
    EXPECT_TRUE(choose({{field(2), "hidden"}}));
    EXPECT_EQ(offered()[1].options[0].label, "shown in turn");
    EXPECT_THAT(now().attract.hidden, testing::ElementsAre(code(2)));
}

TEST_F(ACollection, LeavesAGuestWithoutAPictureThatIsNone) {
    staff::keep_guest(places_.guests, code(2), "hall-2");
    EXPECT_THROW(staff::keep_picture_of_guest(places_.guests, code(2), "\x89PNG\r\n\x1a\n, it says"), base::InputError);
    ASSERT_EQ(offered().size(), 1U);
    EXPECT_EQ(offered()[0].picture, "");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(places_.guests), {}), 1);
}

TEST_F(ACollection, HasNoPictureOfWhatIsNoLandscape) {
    folder_.write("0123456789abcdef.png", "of another folder");
    for (const char* id : {"", "../0123456789abcdef", "0123456789abcdef", "0123456789ABCDEF", "..", "0123456789abcde/"})
        EXPECT_FALSE(landscape_picture(places_, id)) << id;
}

TEST_F(ACollection, HasTheLastDozenOfWhatWasBredAndPassesOverWhatIsDamaged) {
    for (std::uint64_t n = 1; n <= staff::kMostBredLately + 3; ++n) bred(n);
    EXPECT_EQ(staff::landscapes_in(places_.lately).size(), staff::kMostBredLately);
    folder_.write("bred/0123456789abcdef.code", "Q1-OTHER\n");
    folder_.write("bred/" + staff::id_of_landscape(code(90)) + ".code", code(90).substr(0, 40));
    EXPECT_EQ(staff::landscapes_in(places_.lately).size(), staff::kMostBredLately);
}

TEST_F(ACollection, IsNoMoreThanADozenFavouritesAndOnlyLandscapes) {
    std::string many = "[attract]\nfavourites = [";
    for (std::uint64_t n = 1; n <= site::Configuration::Attract::kMostFavourites + 1; ++n)
        many += "\"" + code(n) + "\", ";
    const auto mistakes_of = [](const std::string& toml) {
        std::string all;
        for (const auto& mistake : site::check_configuration(toml, "x").mistakes) all += to_text(mistake) + "\n";
        return all;
    };
    EXPECT_THAT(mistakes_of(many + "]\n"), testing::HasSubstr("has more than 12 landscapes"));
    EXPECT_THAT(mistakes_of("[attract]\nhidden = [\"a tree\"]\n"), testing::HasSubstr("holds what is no landscape"));
    EXPECT_EQ(mistakes_of("[attract]\nhidden = [\"" + code(7) + "\"]\n"), "");
}

}  // namespace
}  // namespace quadrat::commands
