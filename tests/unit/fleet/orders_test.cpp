// SPDX-License-Identifier: Apache-2.0
// What a broker may ask for, and what a house control is told.
#include "fleet/orders.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

namespace quadrat::fleet {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using testing::HasSubstr;

Orders some_orders() {
    Orders orders;
    orders.choices = [](const std::string& what) {
        return what == "theme" ? std::vector<std::string>{"by date", "autumn"} : std::vector<std::string>{"de", "en"};
    };
    return orders;
}

TEST(AnOrder, IsOneOfFiveWithAValueThatMakesSense) {
    for (const auto& [what, value] : {std::pair{"standby", "on"},
                                      {"standby", "off"},
                                      {"wake", ""},
                                      {"restart", ""},
                                      {"restart", "now"},
                                      {"theme", "autumn week"},
                                      {"language", "xh"}})
        EXPECT_EQ(trouble_of_order(what, value), "") << what << " " << value;
    for (const auto& [what, value, says] : {std::tuple{"reboot", "", "there are language, restart, standby"},
                                            {"", "", "nobody knows"},
                                            {"standby/x", "on", "nobody knows"},
                                            {"standby", "ON", "write on or off"},
                                            {"standby", "", "write on or off"},
                                            {"theme", "", "write which"},
                                            {"language", "", "write which"},
                                            {"theme", "a\nb", "control characters"},
                                            {"theme", "\xff\xfe", "UTF-8"}})
        EXPECT_THAT(trouble_of_order(what, value), HasSubstr(says)) << what;
    EXPECT_THAT(trouble_of_order("theme", std::string(kLongestOrder + 1, 'a')), HasSubstr("more than 200 bytes"));
}

TEST(AnOrder, IsNotDoneAgainAndAgainInAMoment) {
    OrderPace pace;
    const OrderPace::Moment begin{};
    EXPECT_TRUE(pace.may("restart", begin));
    EXPECT_FALSE(pace.may("restart", begin + 59s));
    EXPECT_TRUE(pace.may("standby", begin)) << "each has its own pace";
    EXPECT_FALSE(pace.may("standby", begin + 999ms));
    EXPECT_TRUE(pace.may("standby", begin + 1s));
    EXPECT_TRUE(pace.may("restart", begin + 60s)) << "what was refused does not count";
}

TEST(AnOrder, IsAnsweredInOneObjectWhateverItsBytesWere) {
    const json answer = json::parse(answer_json("theme", "\xff\"\n", "it is \xc3"));
    EXPECT_EQ(answer["set"], "theme");
    EXPECT_EQ(answer["done"], false);
    EXPECT_EQ(json::parse(answer_json("wake", "", ""))["done"], true);
    EXPECT_LT(answer_json(std::string(5000, 'a'), std::string(5000, 'b'), "").size(), 1000U);
}

TEST(HomeAssistant, IsToldOfAnExhibitAndOfWhatItMayAsk) {
    const Orders orders = some_orders();
    const auto all = discovery_of("homeassistant", "Foyer 2", "1.4", &orders);
    ASSERT_TRUE(all.contains("homeassistant/switch/quadrat_Foyer_202/standby/config")) << all.begin()->first;
    std::set<std::string> ids;
    for (const auto& [topic, text] : all) {
        EXPECT_THAT(topic, testing::MatchesRegex("homeassistant/[a-z]+/[A-Za-z0-9_-]+/[a-z]+/config"));
        const json one = json::parse(text);
        EXPECT_TRUE(ids.insert(one["unique_id"]).second) << topic;
        EXPECT_EQ(one["availability_topic"], "quadrat/Foyer 2/status");
        EXPECT_EQ(one["device"]["sw_version"], "1.4");
        if (one.contains("command_topic")) {
            const auto command = one["command_topic"].get<std::string>();
            const std::string what = command.substr(std::string("quadrat/Foyer 2/set/").size());
            std::vector<std::string> values = one.value("options", std::vector<std::string>{});
            for (const char* payload : {"payload_on", "payload_off", "payload_press"})
                if (one.contains(payload)) values.push_back(one[payload]);
            EXPECT_FALSE(values.empty()) << topic;
            for (const std::string& value : values) EXPECT_EQ(trouble_of_order(what, value), "") << topic;
        }
    }
    EXPECT_EQ(json::parse(all.at("homeassistant/select/quadrat_Foyer_202/theme/config"))["options"],
              (json{"by date", "autumn"}));
}

TEST(HomeAssistant, IsToldApartExhibitsOfLikeNames) {
    const Orders orders = some_orders();
    std::set<std::string> topics;
    for (const char* name : {"a b", "a_b", "a-b", "a\xc3\xa4", "a_20b"})
        for (const auto& [topic, text] : discovery_of("ha", name, "1", &orders))
            EXPECT_TRUE(topics.insert(topic).second) << name << ": " << topic;
}

TEST(HomeAssistant, CanOnlyLookWhereNothingMayBeAsked) {
    const auto all = discovery_of("homeassistant", "hall", "1", nullptr);
    EXPECT_EQ(all.size(), 2U);
    for (const auto& [topic, text] : all) EXPECT_THAT(text, testing::Not(HasSubstr("command_topic"))) << topic;
}

}  // namespace
}  // namespace quadrat::fleet
