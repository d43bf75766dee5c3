// SPDX-License-Identifier: Apache-2.0
// Whatever lies where the state file should be, the exhibit opens for the public.
#include "archive/archive.hpp"

#include <stdlib.h>

#include <fstream>

namespace fs = std::filesystem;

namespace {

// A folder under TMPDIR, gone when the program ends.
struct Scratch {
    fs::path directory;

    Scratch() {
        std::string name = (fs::temp_directory_path() / "quadrat-fuzz-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) std::abort();
        directory = name;
    }
    ~Scratch() { fs::remove_all(directory); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat::archive;
    static const Scratch scratch;
    const fs::path directory = scratch.directory / "state";
    fs::remove_all(directory);
    fs::create_directory(directory);
    std::ofstream(directory / "quadrat.db", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
    Archive::Opened opened = Archive::open(directory, WallTime{});
    if (opened.condition == Archive::Condition::MemoryOnly) std::abort();
    if (opened.message.find('\n') != std::string::npos) std::abort();
    Generation generation;
    generation.visit = opened.archive.begin_visit(WallTime{}).visit;
    generation.breeder = "belief";
    const bool is_kept = !opened.archive.append(generation).has_value();
    if (opened.condition != Archive::Condition::Continued && !is_kept) std::abort();
    if (is_kept && opened.archive.latest() != generation) std::abort();
    return 0;
}
