// SPDX-License-Identifier: Apache-2.0
#include "machine/account.hpp"

#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>

namespace quadrat::machine {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kRead = 4, kWrite = 2, kPass = 1;

bool allows(const fs::path& path, const Account& account, mode_t wanted) {
    struct stat facts {};
    if (::stat(path.c_str(), &facts) != 0) return false;
    if (account.user == 0) return true;
    if (S_ISDIR(facts.st_mode)) wanted |= kPass;
    const bool is_in_group = std::ranges::find(account.groups, facts.st_gid) != account.groups.end();
    const unsigned shift = facts.st_uid == account.user ? 6U : is_in_group ? 3U : 0U;
    return (facts.st_mode >> shift & wanted) == wanted;
}

bool may(const Account& account, const fs::path& path, mode_t wanted) {
    const fs::path absolute = fs::absolute(path).lexically_normal();
    for (fs::path folder = absolute.parent_path();; folder = folder.parent_path()) {
        if (!allows(folder, account, kPass)) return false;
        if (!folder.has_relative_path()) break;
    }
    return allows(absolute, account, wanted);
}

}  // namespace

std::optional<Account> account_named(const std::string& name) {
    const passwd* found = ::getpwnam(name.c_str());
    if (found == nullptr) return std::nullopt;
    constexpr int kMostGroups = 256;
    Account account{name, found->pw_uid, std::vector<gid_t>(kMostGroups)};
    int count = kMostGroups;
    ::getgrouplist(name.c_str(), found->pw_gid, account.groups.data(), &count);
    account.groups.resize(static_cast<std::size_t>(std::clamp(count, 0, kMostGroups)));
    return account;
}

bool may_read(const Account& account, const fs::path& path) { return may(account, path, kRead); }

bool may_use(const Account& account, const fs::path& path) { return may(account, path, kRead | kWrite); }

}  // namespace quadrat::machine
