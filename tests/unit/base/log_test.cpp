// SPDX-License-Identifier: Apache-2.0
#include "base/log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/sink.h>
#include <spdlog/spdlog.h>

#include "base/error.hpp"
#include "support/process.hpp"

namespace quadrat::base {
namespace {

TEST(LogFile, KeepsWhatIsInItAndIsBoundedInSizeAndNumber) {
    const tests::TemporaryFolder folder;
    const auto file = folder.write("a.log", "what went wrong before\n");
    open_log(LogDetail::Quiet);
    log_to_file_too(file);
    log::warn("what goes wrong now");
    EXPECT_THAT(tests::contents_of(file), testing::AllOf(testing::StartsWith("what went wrong before\n"),
                                                         testing::HasSubstr("what goes wrong now")));
    // On standard error, too, it would be too much to read.
    spdlog::default_logger()->sinks().front()->set_level(spdlog::level::off);
    const std::string line(64U << 10U, 'x');
    for (int i = 0; i < 400; ++i) log::warn(line);
    std::uintmax_t bytes = 0;
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        bytes += entry.file_size();
        ++files;
    }
    EXPECT_EQ(files, 4U);
    EXPECT_LT(bytes, 17U << 20U);
    open_log(LogDetail::Quiet);
}

TEST(LogFile, ThatCannotBeWrittenIsRefusedByName) {
    const tests::TemporaryFolder folder;
    folder.write("file", "");
    EXPECT_THAT([&] { log_to_file_too(folder / "file" / "a.log"); },
                testing::ThrowsMessage<InputError>(testing::HasSubstr("file/a.log: cannot write the log")));
}

}  // namespace
}  // namespace quadrat::base
