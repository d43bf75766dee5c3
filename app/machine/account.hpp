// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quadrat::machine {

// A user of this machine, who need not be the one that runs us.
struct Account {
    std::string name;
    uid_t user = 0;
    std::vector<gid_t> groups;
};

// Nothing: there is no such user.
std::optional<Account> account_named(const std::string& name);

// By the modes of the file or folder and of all folders on the way; of access control lists nothing is known. False for
// what is not there.
bool may_read(const Account& account, const std::filesystem::path& path);
bool may_use(const Account& account, const std::filesystem::path& path);  // read and write; a folder: make files in it

}  // namespace quadrat::machine
