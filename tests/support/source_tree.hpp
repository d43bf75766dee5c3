// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace quadrat::tests {

struct SourceFile {
    std::string path;  // from the repository's root, with slashes
    std::string text;
};

// Every file of ours below the named folders whose name ends in one of the endings, sorted.
inline std::vector<SourceFile> source_files(const std::vector<std::string>& folders,
                                            const std::vector<std::string>& endings) {
    namespace fs = std::filesystem;
    const fs::path root = QUADRAT_SOURCE_DIR;
    std::vector<SourceFile> files;
    for (const std::string& folder : folders) {
        if (!fs::exists(root / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string extension = entry.path().extension().string();
            bool is_wanted = false;
            for (const std::string& ending : endings) is_wanted = is_wanted || ending == extension;
            if (!entry.is_regular_file() || !is_wanted) continue;
            std::ifstream file(entry.path(), std::ios::binary);
            files.push_back({fs::relative(entry.path(), root).generic_string(),
                             std::string{std::istreambuf_iterator<char>(file), {}}});
        }
    }
    return files;
}

}  // namespace quadrat::tests
