// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fleet/favourites.hpp"
#include "fleet/link.hpp"

namespace quadrat::fleet {

// Where what is shared comes from, and where what others share goes. Both ways are quick, and throw nothing.
struct Sharing {
    struct Own {
        std::string code;
        std::string id;                 // 16 hexadecimal digits, the same for the same landscape
        std::filesystem::path picture;  // PNG; "": there is none
    };
    // What may be shown elsewhere, the dearest first; null: nothing is shared.
    std::function<std::vector<Own>()> own;
    // In place of those before; null: nothing is taken.
    std::function<void(const std::vector<Guest>&)> take;
    // PNG, as far as trouble_of_picture() sees; and whether there is one already.
    std::function<void(const Guest&, const std::string& bytes)> take_picture;
    std::function<bool(const Guest&)> has_picture;
};

// Shares favourites with the other exhibits at a broker: quadrat/NAME/favourites is a list (retained), below it each
// one's picture. Only pictures of what is taken are asked for.
class Exchange {
  public:
    using Moment = Guests::Moment;
    Exchange(std::string name, Sharing sharing);

    void connected(Link& link);
    // True: it was of this.
    bool heard(Link& link, const std::string& topic, const std::string& payload);
    void look(Link& link, Moment now);

  private:
    void share(Link& link, Moment now);
    Favourite told_with_picture(Link& link, const Sharing::Own& one) const;
    void take(Link& link, Moment now);
    void take_picture(Link& link, const std::string& topic, const std::string& payload);
    std::string list_topic() const { return "quadrat/" + name_ + "/favourites"; }

    std::string name_;
    Sharing sharing_;
    Guests guests_;
    std::string told_;                      // on this connection
    std::optional<std::string> held_;       // what the broker says it holds of us, since we looked
    std::set<std::string> pictures_told_;   // by id, on this connection
    std::map<std::string, Guest> awaited_;  // by the picture's topic
    std::optional<Moment> shared_at_, taken_at_, connected_at_;
    bool has_news_ = false;
};

}  // namespace quadrat::fleet
