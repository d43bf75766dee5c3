// SPDX-License-Identifier: Apache-2.0
// A postcard on paper as CUPS itself prints it: a scheduler of the test's own, whose printer is a file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "journeys/quadrat_program.hpp"
#include "support/effort.hpp"

namespace {

namespace fs = std::filesystem;
using namespace quadrat::tests;
using testing::StartsWith;

const std::string kAddress = "https://museum.example/quadrat/";

// A printer for paper of A6 with a margin of three millimetres, which takes PDF.
constexpr const char* kPrinter = R"ppd(*PPD-Adobe: "4.3"
*FormatVersion: "4.3"
*FileVersion: "1.0"
*LanguageVersion: English
*LanguageEncoding: ISOLatin1
*PCFileName: "CARDS.PPD"
*Manufacturer: "Quadrat"
*Product: "(Cards)"
*ModelName: "Cards"
*ShortNickName: "Cards"
*NickName: "Cards"
*PSVersion: "(3010.000) 0"
*LanguageLevel: "3"
*ColorDevice: True
*DefaultColorSpace: RGB
*FileSystem: False
*TTRasterizer: Type42
*cupsFilter2: "application/vnd.cups-pdf application/pdf 0 -"
*OpenUI *PageSize/Media Size: PickOne
*OrderDependency: 10 AnySetup *PageSize
*DefaultPageSize: A6
*PageSize A6/A6: ""
*CloseUI: *PageSize
*OpenUI *PageRegion: PickOne
*OrderDependency: 10 AnySetup *PageRegion
*DefaultPageRegion: A6
*PageRegion A6/A6: ""
*CloseUI: *PageRegion
*DefaultImageableArea: A6
*ImageableArea A6/A6: "8.5 8.5 288.5 411.5"
*DefaultPaperDimension: A6
*PaperDimension A6/A6: "297 420"
)ppd";

class Cups : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* tool :
             {"/usr/sbin/cupsd", "/usr/bin/lp", "/usr/lib/cups/filter/imagetopdf", "/usr/bin/pdftoppm"})
            if (!fs::exists(tool)) GTEST_SKIP() << tool << " is missing (apt-get install cups poppler-utils)";
        // Started as root, its filters run as somebody else.
        fs::permissions(folder.path(), fs::perms{0755});
        for (const char* name : {"cups/ppd", "cache", "run/certs", "spool/tmp", "log", "scheduler"})
            fs::create_directories(folder / name);
        folder.write("cups/ppd/cards.ppd", kPrinter);
        folder.write("cups/printers.conf", "<Printer cards>\nDeviceURI file://" + path("card.pdf") +
                                               "\nState Idle\nAccepting Yes\n</Printer>\n");
        folder.write("cups/cups-files.conf", "ServerRoot " + path("cups") + "\nCacheDir " + path("cache") +
                                                 "\nStateDir " + path("run") + "\nRequestRoot " + path("spool") +
                                                 "\nTempDir " + path("spool/tmp") + "\nErrorLog " + path("log/error") +
                                                 "\nAccessLog " + path("log/access") + "\nPageLog " + path("log/page") +
                                                 "\nFileDevice Yes\nSystemGroup root\n");
        folder.write("cups/cupsd.conf", "Listen " + path("sock") +
                                            "\nBrowsing No\nWebInterface No\nDefaultAuthType None\n"
                                            "PreserveJobFiles No\n<Location />\nOrder allow,deny\nAllow all\n"
                                            "</Location>\n<Policy default>\n<Limit All>\nOrder allow,deny\n"
                                            "Allow all\n</Limit>\n</Policy>\n");
    }
    std::string path(const std::string& name) const { return (folder / name).string(); }
    std::unique_ptr<Process> scheduler() const {
        return std::make_unique<Process>(
            std::vector<std::string>{"/usr/sbin/cupsd", "-f", "-c", path("cups/cupsd.conf"), "-s",
                                     path("cups/cups-files.conf")},
            folder / "scheduler");
    }
    std::vector<std::string> exhibit(const std::string& printer) const {
        folder.write("site.toml",
                     "[picture]\nland_samples = 65\nalpha = 0.2\n[visit]\nrounds = 1\nfinale_s = 600\n"
                     "describe_words = 0\n[take_home]\nurl = \"" +
                         kAddress + "\"\n[postcard]\nwhen = \"always\"\nplace = \"Museum\"\nprinter = \"" + printer +
                         "\"\n");
        folder.write("visit.script",
                     "wait 6s\npress A\nwait 3s\npress A\nwait 3s\npress B\nwait 3s\npress C\nwait 900s\n");
        auto command = program({"run", "--config", "site.toml", "--display", "headless", "--size", "640x360", "--input",
                                "script:visit.script", "--state", "state", "--seed", "5", "--speed", "1.001",
                                "--capture", "pictures"});
        command.insert(command.begin(), {"env", "CUPS_SERVER=" + path("sock")});
        return command;
    }
    template <typename Condition>
    static bool comes(Process& process, const Condition& condition) {
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds{kIsSanitized ? 400 : 150};
        while (process.is_running() && std::chrono::steady_clock::now() < until) {
            if (condition()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds{100});
        }
        return condition();
    }
    std::string said() const { return contents_of(folder / "stderr.txt"); }
    std::string scheduler_said() const {
        return contents_of(folder / "scheduler/stderr.txt") + contents_of(folder / "log/error");
    }
    bool is_printed() const {
        return run({"env", "CUPS_SERVER=" + path("sock"), "lpstat", "-W", "completed"}, scratch_)
            .out.starts_with("cards-1 ");
    }

    TemporaryFolder folder;

  private:
    TemporaryFolder scratch_;
};

TEST_F(Cups, PrintsAPostcardOfTheFinaleThatIsReadFromItsPageAndKeepsNothingOfIt) {
    const auto cups = scheduler();
    ASSERT_TRUE(comes(*cups, [&] { return fs::exists(folder / "sock"); })) << scheduler_said();
    Process running(exhibit("cards"), folder.path());
    ASSERT_TRUE(comes(running, [&] { return is_printed(); })) << said() << scheduler_said();
    EXPECT_EQ(count_of(said(), "a postcard goes to the printer cards"), 1U) << said();
    ASSERT_TRUE(comes(running, [&] { return fs::exists(folder / "pictures/finale-01.png"); })) << said();
    running.kill(SIGTERM);
    EXPECT_TRUE(succeeds(running.wait()));

    EXPECT_THAT(run({"pdfinfo", "card.pdf"}, folder).out,
                testing::ContainsRegex("Pages: +1\n(.*\n)*Page size: +297 x 420 pts"));
    // As a printer of 300 dots an inch puts it on paper.
    ASSERT_TRUE(succeeds(run({"pdftoppm", "-r", "300", "-png", "card.pdf", "page"}, folder)));
    const Ended read = run({"zbarimg", "--quiet", "--raw", "page-1.png"}, folder);
    ASSERT_THAT(read.out, StartsWith(kAddress + "Q"));
    const Ended bred = run(program({"code", "encode", "pictures/finale-01.png"}), folder);
    EXPECT_EQ(read.out, kAddress + bred.out) << "the landscape that was on the screen";
    // CUPS names a document d00001-001.
    for (const auto& entry : fs::recursive_directory_iterator(folder / "spool"))
        EXPECT_FALSE(entry.path().filename().string().starts_with("d")) << entry.path();
}

TEST_F(Cups, ThatHasNoSuchPrinterSaysSoAndCostsNoVisit) {
    const auto cups = scheduler();
    ASSERT_TRUE(comes(*cups, [&] { return fs::exists(folder / "sock"); })) << scheduler_said();
    Process running(exhibit("nobodys"), folder.path());
    EXPECT_TRUE(comes(
        running,
        [&] { return count_of(said(), "printer nobodys: lp: Error - The printer or class does not exist.") == 1; }))
        << said() << scheduler_said();
    EXPECT_TRUE(running.is_running());
    EXPECT_EQ(count_of(said(), "the landscape they bred"), 1U);
    running.kill(SIGTERM);
    EXPECT_TRUE(succeeds(running.wait()));
}

}  // namespace
