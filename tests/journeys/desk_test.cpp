// SPDX-License-Identifier: Apache-2.0
// The page for staff, over real connections, beside a running exhibit.
#include <random>
#include <set>

#include "journeys/desk.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST_F(StaffsPage, ShowsARunningExhibitAndHasItStandByAndStartAnew) {
    set_passphrase();
    Process exhibit(exhibit_alone(), folder.path());
    Process page(desk(), elsewhere.path());
    wait_until(page, "the desk", [&] { return ask("GET", "/login").starts_with("HTTP/1.1 200"); });
    EXPECT_THAT(ask("GET", "/"), StartsWith("HTTP/1.1 303"));
    log_in();
    wait_until(exhibit, "its health", [&] {
        return ask("GET", "/health.json").find("\"verdict\"") != std::string::npos &&
               ask("GET", "/").find("All is well") != std::string::npos;
    });
    wait_until(exhibit, "a picture", [&] { return ask("GET", "/picture.png").find("\x89PNG") != std::string::npos; });
    EXPECT_THAT(ask("GET", "/doctor"), HasSubstr("in use by the exhibit"));
    EXPECT_THAT(ask("GET", "/report"), StartsWith("HTTP/1.1 200"));
    EXPECT_THAT(ask("GET", "/backup.tar.xz"), HasSubstr("attachment"));

    EXPECT_THAT(act("standby"), StartsWith("HTTP/1.1 303"));
    wait_until(exhibit, "stand-by",
               [&] { return ask("GET", "/health.json").find("on stand-by, as staff asked") != std::string::npos; });
    EXPECT_THAT(ask("GET", "/"), HasSubstr(">Wake</button>"));
    EXPECT_THAT(act("wake"), StartsWith("HTTP/1.1 303"));
    wait_until(exhibit, "waking", [&] { return ask("GET", "/health.json").find("always open") != std::string::npos; });
    EXPECT_THAT(act("restart"), StartsWith("HTTP/1.1 303"));
    exhibit.wait();
    EXPECT_THAT(contents_of(folder / "stderr.txt"), HasSubstr("staff: restart"));
    EXPECT_THAT(contents_of(folder / "state/desk.log"), HasSubstr("127.0.0.1 asked for restart"));
    EXPECT_TRUE(std::filesystem::exists(folder / "state/health.json")) << "what it said last still lies there";
    EXPECT_THAT(ask("GET", "/"), HasSubstr("The exhibit says nothing"));
    EXPECT_THAT(act("standby"), StartsWith("HTTP/1.1 503")) << "nobody is there to be asked";
    EXPECT_FALSE(std::filesystem::exists(folder / "state/standby"));
    page.kill(SIGTERM);
    EXPECT_TRUE(succeeds(page.wait()));
}

TEST_F(StaffsPage, TestsLampsAndHasItStartInSafeModeAsUsualAndFromABackup) {
    set_passphrase();
    Process page(desk(), elsewhere.path());
    wait_until(page, "the desk", [&] { return ask("GET", "/login").starts_with("HTTP/1.1 200"); });
    log_in();
    const auto says = [&](Process& exhibit, const char* what) {
        wait_until(exhibit, what, [&] { return ask("GET", "/health.json").find(what) != std::string::npos; });
    };
    std::string backup;
    {
        Process exhibit(exhibit_alone(), folder.path());
        says(exhibit, R"("mode": "usual")");
        EXPECT_THAT(act("lamps"), StartsWith("HTTP/1.1 303"));
        says(exhibit, R"("tests_lamps": true)");
        says(exhibit, R"("tests_lamps": false)");
        EXPECT_THAT(act("safe"), StartsWith("HTTP/1.1 303"));
        EXPECT_EQ(exhibit.wait().signal, 0);
    }
    {
        Process exhibit(exhibit_alone(), folder.path());
        says(exhibit, R"("safe_as_wished": true)");
        EXPECT_THAT(ask("GET", "/"), HasSubstr("safe mode, as asked for here"));
        backup = ask("GET", "/backup.tar.xz");
        backup.erase(0, backup.find("\r\n\r\n") + 4);
        EXPECT_THAT(act("usual"), StartsWith("HTTP/1.1 303"));
        EXPECT_EQ(exhibit.wait().signal, 0);
    }
    Process exhibit(exhibit_alone(), folder.path());
    says(exhibit, R"("mode": "usual")");
    for (const char* gone : {"safe-mode", "usual.asked"})
        EXPECT_FALSE(std::filesystem::exists(folder.path() / "state" / gone));
    EXPECT_THAT(bring(backup), StartsWith("HTTP/1.1 303"));
    EXPECT_THAT(act("restore"), HasSubstr("Location: /login?done=restore")) << "it lets go of its state";
    EXPECT_EQ(exhibit.wait().signal, 0);
    EXPECT_THAT(contents_of(folder / "state/desk.log"), HasSubstr("127.0.0.1 restored the backup of"));
    page.kill(SIGTERM);
    EXPECT_TRUE(succeeds(page.wait()));
}

// What it holds in memory just now, in kB.
long resident_kB(pid_t process) {
    const std::string status = contents_of("/proc/" + std::to_string(process) + "/status");
    const std::size_t at = status.find("VmRSS:");
    return at == std::string::npos ? 0 : std::atol(status.c_str() + at + 6);
}

std::string malformed_request(std::mt19937& chance, const std::string& cookie) {
    const std::string words[]{"GET ",
                              "POST ",
                              "/",
                              "/login",
                              "/act",
                              "/restore",
                              "/../../etc/passwd",
                              "%2e%2e",
                              " HTTP/1.1",
                              " HTTP/9.9",
                              "\r\n",
                              "Host: x",
                              "Origin: http://evil.example",
                              "Content-Length: 99999999999999",
                              "Content-Length: -1",
                              "Content-Length: 7",
                              "Cookie: " + cookie,
                              "Transfer-Encoding: chunked",
                              "Content-Type: multipart/form-data; boundary=x",
                              "\r\n--x\r\nContent-Disposition: form-data; name=\"file\"; filename=\"../a\"\r\n\r\n",
                              "\r\n\r\n",
                              "ffffffff\r\n",
                              "act=restart&token=",
                              std::string(9000, 'A'),
                              std::string("\0\x01\xff", 3),
                              "passphrase=%"};
    std::string bytes = chance() % 2 == 0 ? "" : "GET / HTTP/1.1\r\nConnection: close\r\n";
    for (auto n = chance() % 12; n > 0; --n) bytes += words[chance() % std::size(words)];
    return bytes;
}

TEST_F(StaffsPage, OutlivesTenThousandMalformedRequestsWithNothingChanged) {
    set_passphrase();
    Process page(desk(), elsewhere.path());
    wait_until(page, "the desk", [&] { return ask("GET", "/login").starts_with("HTTP/1.1 200"); });
    log_in();
    const auto files = [&] {
        std::set<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
            names.insert(entry.path().string());
        return names;
    };
    const auto before = files();
    const std::string notes = contents_of(folder / "state/desk.log");
    const std::string hash = contents_of(folder / "state/desk.passphrase");
    std::mt19937 chance(11);
    long most_kB = 0;
    for (int i = 0; i < 10'000; ++i) {
        const std::string bytes = malformed_request(chance, cookie);
        const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
        const sockaddr_in address = loopback(port);
        if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
            ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        ::close(socket);
        if (i % 100 == 0) most_kB = std::max(most_kB, resident_kB(page.id()));
    }
    // One address may have so many connections at once; those that were closed are noticed one after the other.
    wait_until(page, "an answer", [&] { return ask("GET", "/login").starts_with("HTTP/1.1 200"); });
    EXPECT_GT(most_kB, 0);
    EXPECT_LT(most_kB, 300 * 1024) << "kB; hashing a passphrase takes 32 MB for a moment";
    EXPECT_EQ(files(), before);
    EXPECT_EQ(contents_of(folder / "state/desk.passphrase"), hash);
    EXPECT_THAT(contents_of(folder / "state/desk.log"), Not(HasSubstr("asked for")));
    EXPECT_THAT(contents_of(folder / "state/desk.log"), StartsWith(notes));
    EXPECT_THAT(ask("POST", "/login", "passphrase=" + std::string(5000, 'x')), StartsWith("HTTP/1.1 413"));
    EXPECT_THAT(ask("POST", "/login", "passphrase=%zz"), StartsWith("HTTP/1.1 400"));
    EXPECT_THAT(ask("GET", "/nowhere"), StartsWith("HTTP/1.1 404"));
    EXPECT_TRUE(page.is_running());
    EXPECT_THAT(ask("GET", "/"), HasSubstr("The exhibit says nothing")) << "the session of before";
    page.kill(SIGTERM);
    EXPECT_TRUE(succeeds(page.wait()));
}

TEST_F(StaffsPage, RestoresABackupThatWasLookedIntoAndConfirmed) {
    set_passphrase();
    folder.write("state/buttons.map", "");
    ASSERT_TRUE(succeeds(tool({"state", "--state", at("state"), "--backup", at("backup.tar.xz")})));
    std::filesystem::remove(folder / "state/buttons.map");
    Process page(desk(), elsewhere.path());
    wait_until(page, "the desk", [&] { return ask("GET", "/login").starts_with("HTTP/1.1 200"); });
    log_in();
    EXPECT_THAT(bring("no backup at all"), StartsWith("HTTP/1.1 503"));
    EXPECT_THAT(bring(std::string(std::size_t{65} << 20U, 'x')), StartsWith("HTTP/1.1 413"));
    const std::string backup = contents_of(folder / "backup.tar.xz");
    EXPECT_THAT(bring(backup.substr(0, backup.size() - 40)), StartsWith("HTTP/1.1 503"));
    EXPECT_THAT(act("restore"), StartsWith("HTTP/1.1 400")) << "none of these can be restored";
    EXPECT_FALSE(std::filesystem::exists(folder / "state/desk-brought.tar.xz"));

    EXPECT_THAT(bring(backup), StartsWith("HTTP/1.1 303"));
    EXPECT_THAT(ask("GET", "/backup"), HasSubstr("buttons.map"));
    EXPECT_FALSE(std::filesystem::exists(folder / "state/buttons.map")) << "not before it is confirmed";
    EXPECT_THAT(act("restore"), HasSubstr("Location: /login?done=restore"));
    EXPECT_TRUE(std::filesystem::exists(folder / "state/buttons.map"));
    EXPECT_THAT(ask("GET", "/"), StartsWith("HTTP/1.1 303")) << "everybody is logged out";
    EXPECT_FALSE(std::filesystem::exists(folder / "state/desk-restore.tar.xz"));
    EXPECT_THAT(contents_of(folder / "state/desk.log"), HasSubstr("127.0.0.1 restored the backup of"));
    log_in();
    page.kill(SIGTERM);
    EXPECT_TRUE(succeeds(page.wait()));
}

TEST_F(StaffsPage, ListensNowhereUnlessItIsSafeAndWanted) {
    const Ended without = tool({"desk", "--config", at("quadrat.toml"), "--state", at("state")});
    EXPECT_EQ(without.status, 2);
    EXPECT_THAT(without.err, HasSubstr("quadrat desk --set-passphrase"));
    set_passphrase();
    struct Wrong {
        const char* toml;
        int status;
        const char* says;
    };
    for (const Wrong& wrong :
         {Wrong{"", 0, "nothing listens"}, Wrong{"[desk]\nlisten = \"localhost:80\"\n", 2, "in numbers"},
          Wrong{"[desk]\nlisten = \"0.0.0.0:8443\"\n", 2, "unencrypted"},
          Wrong{"[desk]\nlisten = \"127.0.0.1:8443\"\nkey = \"no.pem\"\n", 2, "no.pem"}}) {
        folder.write("other.toml", std::string("# \n") + wrong.toml);
        const Ended ended = tool({"desk", "--config", at("other.toml"), "--state", at("state")});
        EXPECT_EQ(ended.status, wrong.status) << wrong.toml << ended.err;
        EXPECT_THAT(ended.err, HasSubstr(wrong.says)) << wrong.toml;
    }
    const std::string short_one = "echo short | '" QUADRAT_BINARY "' desk --set-passphrase --state '" + at("state") +
                                  "' 2>'" + (elsewhere / "said.txt").string() + "'";
    EXPECT_NE(std::system(short_one.c_str()), 0);
    EXPECT_THAT(contents_of(elsewhere / "said.txt"), HasSubstr("at least 10"));
}

}  // namespace
