// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// What a house control may ask of the exhibit by its broker: quadrat/NAME/set/WHAT. Each is answered once; who may ask
// is for the broker's own rules to say.
namespace quadrat::fleet {

inline constexpr std::size_t kLongestOrder = 200;  // bytes of what is asked for

struct Orders {
    // Does it, or throws InputError with why not; then nothing has changed. What: standby (on, off), wake, restart,
    // theme (its name), language (its code).
    std::function<void(const std::string& what, const std::string& value)> carry_out;
    // What holds now: standby, theme, language.
    std::function<std::map<std::string, std::string>()> state;
    // What may be said for theme and for language.
    std::function<std::vector<std::string>(const std::string& what)> choices;
};

// How often each may be asked for: a button that sticks, or a script gone wrong, must not keep the exhibit busy.
class OrderPace {
  public:
    using Moment = std::chrono::steady_clock::time_point;
    static constexpr std::chrono::seconds kBetweenRestarts{60};
    static constexpr std::chrono::seconds kBetween{1};
    bool may(const std::string& what, Moment now);

  private:
    std::map<std::string, Moment> last_;
};

// "" for what is known and well-formed, else what is wrong and what would be right. Takes any bytes.
std::string trouble_of_order(std::string_view what, std::string_view value);

// For quadrat/NAME/answer.
std::string answer_json(const std::string& what, const std::string& value, const std::string& trouble);

// What Home Assistant learns of an exhibit by (MQTT discovery): topics below its prefix, and what is retained there.
// Without orders, which may be null, it can only look.
std::map<std::string, std::string> discovery_of(const std::string& prefix, const std::string& name,
                                                const std::string& version, const Orders* orders);

}  // namespace quadrat::fleet
