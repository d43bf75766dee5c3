// SPDX-License-Identifier: Apache-2.0
#include "commands/ask_exhibit.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "base/error.hpp"
#include "base/file.hpp"
#include "staff/presence.hpp"
#include "staff/watch.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kPatience{10};

void require_exhibit(const fs::path& folder) {
    if (staff::is_exhibit_present(folder)) return;
    std::error_code ignored;
    fs::remove(folder / staff::kPictureAsked, ignored);
    throw base::InputError(fmt::format(
        "no exhibit runs in {}: systemctl status quadrat; started by hand, name its --state", folder.string()));
}

// The exhibit's own reason why there is no picture, or "".
std::string refusal_in(const fs::path& folder) {
    std::error_code error;
    if (!fs::exists(folder / staff::kNoPicture, error)) return {};
    const std::string text = base::read_file(folder / staff::kNoPicture, 1U << 12U);
    return text.substr(0, text.find('\n'));
}

}  // namespace

std::string picture_of_exhibit(const fs::path& folder) {
    const fs::path asked = folder / staff::kPictureAsked;
    require_exhibit(folder);
    std::error_code error;
    fs::remove(folder / staff::kNoPicture, error);
    base::write_file(asked, "");
    const auto until = std::chrono::steady_clock::now() + kPatience;
    while (fs::exists(asked, error)) {
        if (std::chrono::steady_clock::now() > until) {
            fs::remove(asked, error);
            throw base::InputError(
                fmt::format("the exhibit in {} does not answer within {} s: journalctl -u quadrat -n 50",
                            folder.string(), kPatience.count()));
        }
        require_exhibit(folder);
        std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
    if (const std::string why = refusal_in(folder); !why.empty())
        throw base::InputError(fmt::format(
            "the exhibit in {} is {}: its screen is switched off as planned, so there is nothing to take a picture of; "
            "ask again while it is open, or wake it by a button (hours.wakes_by_button)",
            folder.string(), why));
    return base::read_file(folder / staff::kPicture);
}

}  // namespace quadrat::commands
