// SPDX-License-Identifier: Apache-2.0
#include "base/file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "base/error.hpp"
#include "base/owned.hpp"

namespace quadrat::base {
namespace {

namespace fs = std::filesystem;

class File : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "quadrat-file-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        directory_ = name;
    }
    void TearDown() override { fs::remove_all(directory_); }

    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory_), fs::directory_iterator()));
    }

    fs::path directory_;
};

TEST_F(File, ReadsBackWhatWasWrittenByteForByte) {
    std::string bytes;
    for (int i = 0; i < 300'000; ++i) bytes.push_back(static_cast<char>(i * 31 % 256));
    write_file(directory_ / "a.bin", bytes);
    EXPECT_EQ(read_file(directory_ / "a.bin"), bytes);
    write_file(directory_ / "a.bin", "");
    EXPECT_EQ(read_file(directory_ / "a.bin"), "");
    EXPECT_EQ(files(), 1U);
}

// While it lives, no file grows beyond 4 KiB: what a full disk does, without one.
class SmallFilesOnly {
  public:
    SmallFilesOnly() {
        before_signal_ = std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{4096, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallFilesOnly() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, before_signal_);
    }
    SmallFilesOnly(const SmallFilesOnly&) = delete;
    SmallFilesOnly& operator=(const SmallFilesOnly&) = delete;

  private:
    rlimit before_{};
    void (*before_signal_)(int);
};

TEST_F(File, LeavesTheOldFileWholeWhenWritingFails) {
    write_file(directory_ / "a.png", "old");
    {
        const SmallFilesOnly full_disk;
        EXPECT_THROW(write_file(directory_ / "a.png", std::string(10'000, 'x')), InputError);
    }
    EXPECT_EQ(read_file(directory_ / "a.png"), "old");
    EXPECT_EQ(files(), 1U) << "the half-written file is left behind";
}

TEST_F(File, TakesEveryNameThatTheSystemTakes) {
    for (const std::string& name :
         {std::string("what?.png"), std::string("100%d.png"),
          std::string("Gr\xC3\xB6\xC3\x9F"
                      "e.png"),
          std::string("no UTF-8 \xF6.png"), std::string("two\nlines.png"), std::string(251, 'x') + ".png"}) {
        write_file(directory_ / name, name);
        EXPECT_EQ(read_file(directory_ / name), name);
    }
    EXPECT_EQ(files(), 6U);
}

TEST_F(File, NeverTakesThePlaceOfWhatIsNoFile) {
    const fs::path pipe = directory_ / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(write_file(pipe, "x"), InputError);
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_THROW(write_file("/dev/null", "x"), InputError);
}

TEST_F(File, ItsEndingIsKnownBeforeWorkBegins) {
    EXPECT_EQ(ending_of("a/Now.PNG"), ".png");
    EXPECT_EQ(ending_of(".png"), "");
    require_ending(directory_ / "now.PNG", {".png", ".exr"}, "a picture");
    for (const char* name : {"now.jpg", "now", "png", ".png", "now.png.bak"})
        EXPECT_THAT(
            [&] {
                require_ending(directory_ / name, {".png", ".exr"}, "a picture");
            },
            testing::ThrowsMessage<InputError>(testing::HasSubstr("a picture is written as .png or .exr")));
    EXPECT_THAT([&] { require_ending(directory_ / "no" / "now.png", {".png"}, "a picture"); },
                testing::ThrowsMessage<InputError>(testing::HasSubstr("there is no folder")));
    EXPECT_EQ(files(), 0U);
}

TEST_F(File, IsKnownToBeWritableBeforeItIsWritten) {
    const fs::path file = directory_ / "a.html";
    require_writable(file);
    EXPECT_EQ(files(), 0U) << "asking leaves nothing behind";
    write_file(file, "old");
    require_writable(file);
    EXPECT_EQ(read_file(file), "old");
    for (const fs::path& no_file : {directory_, directory_ / "", directory_ / "missing" / "a.html", file / "b.html"})
        EXPECT_THROW(require_writable(no_file), InputError) << no_file;
    EXPECT_THROW(require_writable("/dev/null"), InputError) << "it would be replaced";
}

TEST_F(File, SaysWhichFileCannotBeReadOrWritten) {
    const auto message_of = [](const auto& work) -> std::string {
        try {
            work();
        } catch (const InputError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_THAT(message_of([&] { read_file(directory_ / "none"); }), testing::HasSubstr("none: cannot read"));
    EXPECT_THAT(message_of([&] { read_file(directory_); }), testing::HasSubstr("is a directory"));
    EXPECT_THAT(message_of([&] { write_file(directory_ / "no" / "such", "x"); }), testing::HasSubstr("such: cannot"));
    write_file(directory_ / "long", "12345");
    EXPECT_THAT(message_of([&] { read_file(directory_ / "long", 4); }), testing::HasSubstr("larger than 4 bytes"));
    EXPECT_EQ(read_file(directory_ / "long", 5), "12345");
}

struct Count {
    inline static int closed = 0;
    void operator()(int) const { ++closed; }
};

TEST(Owned, ClosesEveryHandleExactlyOnce) {
    Count::closed = 0;
    {
        Owned<int, Count, -1> first(3);
        Owned<int, Count, -1> second(std::move(first));
        EXPECT_FALSE(first);  // NOLINT(bugprone-use-after-move): moved-from means nothing, and that is the contract
        second = Owned<int, Count, -1>(4);
        EXPECT_EQ(Count::closed, 1);
        EXPECT_EQ(second.get(), 4);
        const Owned<int, Count, -1> none;
        Owned<int, Count, -1> released(5);
        EXPECT_EQ(released.release(), 5);
    }
    EXPECT_EQ(Count::closed, 2);
}

}  // namespace
}  // namespace quadrat::base
