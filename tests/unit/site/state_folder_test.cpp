// SPDX-License-Identifier: Apache-2.0
#include "site/state_folder.hpp"

#include <gtest/gtest.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "support/process.hpp"

namespace quadrat::site {
namespace {

namespace fs = std::filesystem;

TEST(StateFolder, OfWhoTendsAnExhibitIsTheServicesWhereThereIsOne) {
    const tests::TemporaryFolder machine;
    const ServiceFolders service{machine / "state", machine / "run"};
    EXPECT_EQ(tended_state_folder("", service), state_folder("")) << "no service is installed";
    fs::create_directory(service.state);
    EXPECT_EQ(tended_state_folder("", service), service.state);
    EXPECT_EQ(tended_state_folder("elsewhere", service), "elsewhere");
}

TEST(StateFolder, WhoAsksByHandSeesTheServiceUnlessAnotherExhibitIsNamed) {
    const tests::TemporaryFolder machine;
    const ServiceFolders service{machine / "state", machine / "run"};
    EXPECT_EQ(watched_folder(machine / "other", service), machine / "other");
    fs::create_directory(service.state);
    fs::create_directory(service.runtime);
    EXPECT_EQ(watched_folder("", service), service.runtime);
    EXPECT_EQ(watched_folder(service.state / "", service), service.runtime)
        << "named, it is the service's all the same";
    EXPECT_EQ(watched_folder(machine / "other", service), machine / "other");
}

// Sets variables of the environment, and gives them back.
class Environment {
  public:
    explicit Environment(std::map<std::string, std::optional<std::string>> wanted) {
        for (const auto& [name, value] : wanted) {
            const char* before = std::getenv(name.c_str());
            before_[name] = before == nullptr ? std::nullopt : std::optional<std::string>(before);
        }
        set(wanted);
    }
    ~Environment() { set(before_); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    static void set(const std::map<std::string, std::optional<std::string>>& values) {
        for (const auto& [name, value] : values) {
            if (value)
                ::setenv(name.c_str(), value->c_str(), 1);
            else
                ::unsetenv(name.c_str());
        }
    }
    std::map<std::string, std::optional<std::string>> before_;
};

TEST(StateFolder, IsTheServicesThenTheUsersAsTheXdgSpecificationSays) {
    const Environment all{{{"STATE_DIRECTORY", "/s:/t"}, {"XDG_STATE_HOME", "/x"}, {"HOME", "/h"}}};
    EXPECT_EQ(state_folder(""), "/s");
    const Environment without_service{{{"STATE_DIRECTORY", ""}}};
    EXPECT_EQ(state_folder(""), "/x/quadrat");
    for (const std::optional<std::string>& ignored :
         {std::optional<std::string>(), {""}, {"state"}, {"./x"}, {"~/x"}}) {
        const Environment odd{{{"XDG_STATE_HOME", ignored}}};
        EXPECT_EQ(state_folder(""), "/h/.local/state/quadrat") << ignored.value_or("not set");
    }
}

TEST(StateFolder, WithoutAnythingInTheEnvironmentIsInTheHomeThatTheSystemKnows) {
    const passwd* user = ::getpwuid(::getuid());
    if (user == nullptr || !fs::is_directory(user->pw_dir)) GTEST_SKIP() << "this user has no home";
    for (const std::optional<std::string>& ignored : {std::optional<std::string>(), {""}, {"home"}}) {
        const Environment bare{{{"STATE_DIRECTORY", {}}, {"XDG_STATE_HOME", {}}, {"HOME", ignored}}};
        EXPECT_EQ(state_folder(""), fs::path(user->pw_dir) / ".local/state/quadrat");
    }
}

TEST(StateFolder, ThatIsNamedToBeReadMustBeThere) {
    const tests::TemporaryFolder machine;
    require_state_folder("");
    require_state_folder(machine.path().string());
    EXPECT_THROW(require_state_folder((machine / "nope").string()), base::InputError);
}

TEST(StateFolder, WhoTendsAnExhibitReadsTheSettingsThatTheServiceReads) {
    const tests::TemporaryFolder machine;
    const ServiceFolders service{machine / "state", machine / "run", machine / "site.toml"};
    EXPECT_EQ(tended_configuration("", "", service), "") << "no service is installed: the defaults are meant";
    machine.write("site.toml", "# the defaults\n");
    EXPECT_EQ(tended_configuration("", "", service), service.configuration);
    EXPECT_EQ(tended_configuration("", service.state, service), "") << "of that name there is none yet";
    fs::create_directory(service.state);
    EXPECT_EQ(tended_configuration("", service.state, service), service.configuration);
    EXPECT_EQ(tended_configuration("mine.toml", "", service), "mine.toml");
    EXPECT_EQ(tended_configuration("", machine / "other", service), "") << "another exhibit, with settings of its own";
    fs::remove(service.configuration);
    EXPECT_EQ(tended_configuration("", "", service), service.configuration) << "lost: that is what is to be found";
}

}  // namespace
}  // namespace quadrat::site
