// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quadrat::benches {

// What a shader needs on a chip, as that chip's compiler says; tests/gpu/run --json writes it.
struct CompiledShader {
    std::string vertex;  // the pair that is linked: "ground.vert"
    std::string fragment;
    std::string stage;  // "fragment", "vertex"; "binning": of the vertex shader what a tile's list needs
    std::string chip;   // of V3D: "4.2" in a Raspberry Pi 4, "7.1" in a 5
    int instructions = 0;
    int threads = 0;
    int spills = 0;
    int fills = 0;
    std::optional<int> budget;  // of instructions
};

struct ShaderTable {
    std::string compiler;  // "Mesa 25.0.7"
    std::vector<CompiledShader> shaders;
};

// Throws base::InputError naming source and the place: where it is not JSON, where a key is missing, unknown or has
// another type than it should, and where a row stands twice.
ShaderTable shader_table_from(std::string_view text, std::string_view source);

// What tests/gpu/run calls a breach.
bool has_few_threads(const CompiledShader& shader);
bool is_over_budget(const CompiledShader& shader);
bool spills(const CompiledShader& shader);

// HTML: a section with a row for each pair and stage, the chips beside each other.
std::string section_of(const ShaderTable& table);

}  // namespace quadrat::benches
