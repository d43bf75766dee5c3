// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <optional>
#include <string>

#include "fleet/link.hpp"
#include "fleet/orders.hpp"

namespace quadrat::fleet {

// What a house control hears and says of one exhibit: below quadrat/NAME/ orders come by set/WHAT, each is answered at
// answer, and state/WHAT (retained) is what holds now. Where Home Assistant looks, it finds the exhibit by itself.
class HouseControl {
  public:
    struct How {
        std::string name;              // of the exhibit
        std::string discovery;         // the prefix below which Home Assistant looks; "": it is told nothing
        std::string version;           // of the program
        std::optional<Orders> orders;  // none: nothing is taken, and no state is told
    };
    explicit HouseControl(How how) : how_(std::move(how)) {}

    void connected(Link& link);
    // True: it was an order, and was answered.
    bool heard(Link& link, const std::string& topic, const std::string& value, bool is_retained);
    // Says what is new, at most once a second: what others do to the exhibit is told too.
    void look(Link& link, OrderPace::Moment now);

  private:
    std::string trouble_with(const std::string& what, const std::string& value, OrderPace::Moment now);
    std::string topic(const std::string& name) const { return "quadrat/" + how_.name + "/" + name; }

    How how_;
    OrderPace pace_;
    std::map<std::string, std::string> told_;  // by topic, on this connection
    std::optional<OrderPace::Moment> looked_at_;
};

}  // namespace quadrat::fleet
