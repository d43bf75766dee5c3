// SPDX-License-Identifier: Apache-2.0
#include "machine/account.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "support/process.hpp"

namespace quadrat::machine {
namespace {

namespace fs = std::filesystem;

TEST(Account, MayDoWhatTheModesOfAFileAndOfTheFoldersAboveAllow) {
    const tests::TemporaryFolder folder;
    const auto node = folder.write("hidraw0", "");
    const Account stranger{"quadrat", ::getuid() + 12345, {}};
    const Account member{"quadrat", ::getuid() + 12345, {::getgid()}};
    fs::permissions(node, fs::perms{0640});
    EXPECT_FALSE(may_read(member, node)) << "the folder above lets nobody through";
    fs::permissions(folder.path(), fs::perms{0755});
    EXPECT_TRUE(may_read(member, node));
    EXPECT_FALSE(may_use(member, node));
    EXPECT_FALSE(may_read(stranger, node));
    fs::permissions(node, fs::perms{0660});
    EXPECT_TRUE(may_use(member, node));
    fs::permissions(node, fs::perms{0606});
    EXPECT_TRUE(may_use(stranger, node));
    EXPECT_FALSE(may_use(member, node)) << "a group that is denied is denied";
    EXPECT_FALSE(may_use(member, folder / "gone"));
    EXPECT_FALSE(may_use(member, folder.path())) << "no files of its own in there";
}

TEST(Account, IsOfAUserThatThereIs) {
    const auto root = account_named("root");
    ASSERT_TRUE(root.has_value());
    EXPECT_EQ(root->user, 0U);
    EXPECT_FALSE(root->groups.empty());
    EXPECT_FALSE(account_named("no-such-user-here").has_value());
}

}  // namespace
}  // namespace quadrat::machine
