// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ as commonly read, and glTF 2.0, binary and as text (Khronos 2017/2022, sections 3.6, 4.4).
#include "mesh/model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

#include "base/srgb.hpp"

namespace quadrat::mesh {
namespace {

std::vector<Model::Placed> placements(const Model& model) {
    if (!model.placed.empty()) return model.placed;
    std::vector<Model::Placed> all(model.parts.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i].part = i;
    return all;
}

glm::vec3 turned(const glm::vec3& v, float yaw_rad) {
    const float c = std::cos(yaw_rad);
    const float s = std::sin(yaw_rad);
    return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

void append_obj(std::string& out, const Model::Part& part, const Model::Placed& placed, std::size_t number,
                std::size_t& first_vertex, std::size_t& first_normal) {
    auto to = std::back_inserter(out);
    fmt::format_to(to, "o {}_{}\n", part.name, number);
    const glm::vec3 colour{base::srgb_from_linear(part.colour.x), base::srgb_from_linear(part.colour.y),
                           base::srgb_from_linear(part.colour.z)};
    for (const glm::vec3& local : part.mesh.positions_m) {
        const glm::vec3 p = placed.at_m + placed.scale * turned(local, placed.yaw_rad);
        fmt::format_to(to, "v {} {} {} {:.4g} {:.4g} {:.4g}\n", p.x, p.y, p.z, colour.x, colour.y, colour.z);
    }
    const bool has_normals = part.mesh.normals.size() == part.mesh.positions_m.size();
    if (has_normals) {
        for (const glm::vec3& local : part.mesh.normals) {
            const glm::vec3 n = turned(local, placed.yaw_rad);
            fmt::format_to(to, "vn {:.5g} {:.5g} {:.5g}\n", n.x, n.y, n.z);
        }
    }
    const auto& indices = part.mesh.indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        out += "f";
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::size_t v = indices[i + corner];
            if (has_normals)
                fmt::format_to(to, " {}//{}", first_vertex + v, first_normal + v);
            else
                fmt::format_to(to, " {}", first_vertex + v);
        }
        out += '\n';
    }
    first_vertex += part.mesh.positions_m.size();
    if (has_normals) first_normal += part.mesh.normals.size();
}

// The binary chunk and the JSON that describes it, built side by side.
struct Glb {
    std::string binary;
    std::string views;
    std::string accessors;
    std::size_t count = 0;

    template <typename Element>
    std::size_t add(const std::vector<Element>& elements, std::string_view type, int component, int target,
                    const std::string& bounds = {}) {
        const std::size_t bytes = elements.size() * sizeof(Element);
        const std::size_t offset = binary.size();
        binary.append(reinterpret_cast<const char*>(elements.data()), bytes);
        const char* comma = count == 0 ? "" : ",";
        views += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{},"target":{}}})", comma, offset, bytes,
                             target);
        accessors += fmt::format(R"({}{{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})", comma, count,
                                 component, elements.size(), type, bounds);
        return count++;
    }
};

constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

std::string bounds_of(const std::vector<glm::vec3>& positions) {
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{std::numeric_limits<float>::lowest()};
    for (const glm::vec3& p : positions) {
        for (int i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
    return fmt::format(R"(,"min":[{},{},{}],"max":[{},{},{}])", low.x, low.y, low.z, high.x, high.y, high.z);
}

std::string mesh_json(Glb& glb, const Model::Part& part, std::size_t number) {
    const Mesh& mesh = part.mesh;
    const std::size_t positions = glb.add(mesh.positions_m, "VEC3", kFloat, kArrayBuffer, bounds_of(mesh.positions_m));
    std::string attributes = fmt::format(R"("POSITION":{})", positions);
    if (mesh.normals.size() == mesh.positions_m.size())
        attributes += fmt::format(R"(,"NORMAL":{})", glb.add(mesh.normals, "VEC3", kFloat, kArrayBuffer));
    const std::size_t indices = glb.add(mesh.indices, "SCALAR", kUnsignedInt, kElementArrayBuffer);
    return fmt::format(R"({{"name":"{}","primitives":[{{"attributes":{{{}}},"indices":{},"material":{}}}]}})",
                       part.name, attributes, indices, number);
}

void append_chunk(std::string& out, std::string chunk, std::string_view kind, char padding) {
    while (chunk.size() % 4 != 0) chunk += padding;
    const auto size = static_cast<std::uint32_t>(chunk.size());
    char head[4];
    std::memcpy(head, &size, sizeof head);
    out.append(head, sizeof head).append(kind).append(chunk);
}

// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t here = std::min<std::size_t>(bytes.size() - i, 3);
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8U | (k < here ? static_cast<std::uint8_t>(bytes[i + k]) : std::uint8_t{0});
        for (std::size_t k = 0; k < 4; ++k) text += k <= here ? kLetters[bits >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

std::string joined(const std::vector<std::string>& items) { return fmt::format("{}", fmt::join(items, ",")); }

}  // namespace

std::string to_obj(const Model& model) {
    std::string out = "# quadrat, metres, y up; colours after the positions are sRGB, 0 to 1\n";
    std::size_t first_vertex = 1;
    std::size_t first_normal = 1;
    std::size_t number = 0;
    for (const Model::Placed& placed : placements(model))
        append_obj(out, model.parts.at(placed.part), placed, number++, first_vertex, first_normal);
    return out;
}

namespace {

// Fills glb; uri: of its binary part, as a member of the buffer, or nothing.
template <typename Uri>
std::string gltf_json(const Model& model, Glb& glb, const Uri& uri) {
    std::vector<std::string> meshes;
    std::vector<std::string> materials;
    std::vector<std::string> nodes;
    std::vector<std::string> roots;
    for (const Model::Part& part : model.parts) {
        if (part.mesh.indices.empty()) continue;
        meshes.push_back(mesh_json(glb, part, meshes.size()));
        materials.push_back(fmt::format(
            R"({{"name":"{}","doubleSided":true,"pbrMetallicRoughness":{{"baseColorFactor":[{},{},{},1],"metallicFactor":0}}}})",
            part.name, part.colour.x, part.colour.y, part.colour.z));
    }
    // Parts without triangles have no mesh: glTF forbids empty ones.
    std::vector<std::size_t> mesh_of(model.parts.size(), 0);
    for (std::size_t i = 0, next = 0; i < model.parts.size(); ++i)
        mesh_of[i] = model.parts[i].mesh.indices.empty() ? model.parts.size() : next++;
    for (const Model::Placed& placed : placements(model)) {
        if (mesh_of.at(placed.part) == model.parts.size()) continue;
        roots.push_back(std::to_string(nodes.size()));
        nodes.push_back(
            fmt::format(R"({{"mesh":{},"translation":[{},{},{}],"rotation":[0,{},0,{}],"scale":[{},{},{}]}})",
                        mesh_of[placed.part], placed.at_m.x, placed.at_m.y, placed.at_m.z, std::sin(placed.yaw_rad / 2),
                        std::cos(placed.yaw_rad / 2), placed.scale, placed.scale, placed.scale));
    }
    return fmt::format(
        R"({{"asset":{{"version":"2.0","generator":"quadrat"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],"meshes":[{}],"materials":[{}],"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}{}}}]}})",
        joined(roots), joined(nodes), joined(meshes), joined(materials), glb.accessors, glb.views, glb.binary.size(),
        uri(glb.binary));
}

}  // namespace

std::string to_glb(const Model& model) {
    Glb glb;
    const std::string json = gltf_json(model, glb, [](const std::string&) { return std::string(); });
    std::string chunks;
    append_chunk(chunks, json, "JSON", ' ');
    append_chunk(chunks, glb.binary, std::string_view("BIN\0", 4), '\0');
    const std::uint32_t head[3] = {0x46546C67U, 2U, static_cast<std::uint32_t>(chunks.size() + sizeof head)};
    std::string out(reinterpret_cast<const char*>(head), sizeof head);
    return out + chunks;
}

std::string to_gltf(const Model& model) {
    Glb glb;
    return gltf_json(model, glb, [](const std::string& binary) {
        return fmt::format(R"(,"uri":"data:application/octet-stream;base64,{}")", base64(binary));
    });
}

std::string model_file(const Model& model, std::string_view ending) {
    assert(std::ranges::find(kModelEndings, ending) != kModelEndings.end());
    return ending == ".obj" ? to_obj(model) : ending == ".glb" ? to_glb(model) : to_gltf(model);
}

}  // namespace quadrat::mesh
