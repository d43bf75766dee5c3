// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// What exhibits of one museum tell each other of the landscapes that visitors bred: a scene code each, and nothing of
// who bred it, or when.
namespace quadrat::fleet {

inline constexpr std::size_t kMostShared = 6;                // by one exhibit
inline constexpr std::size_t kLongestList = 8192;            // bytes of what says them
inline constexpr std::size_t kLargestPicture = 512U << 10U;  // bytes
inline constexpr int kWidestPicture = 960;                   // pixels, and as high at most

struct Favourite {
    std::string code;     // as genome::code_of writes it
    std::string picture;  // where its picture is, below the list: 16 hexadecimal digits; "": there is none
    friend bool operator==(const Favourite&, const Favourite&) = default;
};

std::string to_text(const std::vector<Favourite>& favourites);
// Takes any bytes. "" says that there are none. Throws InputError: what is wrong; then nothing of it is taken.
std::vector<Favourite> favourites_from(std::string_view text);
// "" for what is a PNG of a modest size as far as its frame says, else what is wrong. Takes any bytes.
std::string trouble_of_picture(std::string_view bytes);

struct Guest {
    std::string code;
    std::string from;     // the exhibit's name
    std::string picture;  // as above
    friend bool operator==(const Guest&, const Guest&) = default;
};

// What other exhibits share, as much of it as one exhibit shows: few of each, and fairly from all, also where there are
// a thousand. Of each the last word counts; it is read once a minute at most, so that one that talks without end costs
// no more than its words' room.
class Guests {
  public:
    using Moment = std::chrono::steady_clock::time_point;
    static constexpr std::size_t kMost = 12;
    static constexpr std::size_t kMostSenders = 64;
    static constexpr std::chrono::seconds kBetween{60};

    // `name`: of the exhibit that they are guests of; from which sender it takes first follows from both names.
    explicit Guests(std::string name) : name_(std::move(name)) {}

    void hear(const std::string& sender, std::string_view text);
    // Reads what was heard and is due. True: others than before.
    bool look(Moment now);
    const std::vector<Guest>& chosen() const { return chosen_; }

  private:
    struct Sender {
        std::optional<std::string> heard;  // and not read yet
        std::optional<Moment> read_at;
        std::vector<Favourite> favourites;
        bool is_told = false;  // that what it says is wrong
    };
    using Order = std::pair<std::uint64_t, std::string>;  // of a sender, for this exhibit
    Order order_of(const std::string& sender) const;
    void read(const std::string& name, Sender& sender, Moment now);
    std::vector<Guest> choose() const;

    std::string name_;
    std::map<Order, Sender> senders_;
    std::vector<Guest> chosen_;
};

}  // namespace quadrat::fleet
