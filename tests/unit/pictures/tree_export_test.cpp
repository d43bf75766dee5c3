// SPDX-License-Identifier: Apache-2.0
#include "pictures/tree_export.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>
#include <assimp/Importer.hpp>

#include <map>
#include <mutex>
#include <string>

#include "base/error.hpp"
#include "pictures/clamped_scene.hpp"
#include "support/effort.hpp"
#include "support/manifold.hpp"
#include "support/process.hpp"

namespace quadrat::pictures {
namespace {

// What an independent reader of OBJ makes of the wood: empty when every edge has two triangles, one each way.
std::string read_by_assimp(const std::string& obj, std::size_t triangles) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(
        obj.data(), obj.size(), aiProcess_JoinIdenticalVertices | aiProcess_ValidateDataStructure, "obj");
    if (scene == nullptr) return importer.GetErrorString();
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        const aiMesh& mesh = *scene->mMeshes[m];
        if (std::string(mesh.mName.C_Str()).find("wood") == std::string::npos) continue;
        if (mesh.mNumFaces != triangles) return "other triangles than ours";
        std::map<std::pair<unsigned, unsigned>, int> edges;
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            if (mesh.mFaces[f].mNumIndices != 3) return "a face that is no triangle";
            for (unsigned k = 0; k < 3; ++k)
                ++edges[{mesh.mFaces[f].mIndices[k], mesh.mFaces[f].mIndices[(k + 1) % 3]}];
        }
        for (const auto& [edge, count] : edges) {
            const auto back = edges.find({edge.second, edge.first});
            if (back == edges.end() || back->second != count) return "an open edge";
        }
        return {};
    }
    return "no wood";
}

TEST(TreeExport, OfTwoHundredScenesIsClosedOrientedAndWithoutSlivers) {
    std::mutex mutex;
    std::string faults;
    tbb::parallel_for(0, tests::of(200), [&](int seed) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{static_cast<std::uint64_t>(seed)});
        const mesh::Model model = tree_model(recipe, Limbs::AsDrawn);
        const mesh::Mesh& wood = model.parts.front().mesh;
        std::string fault = tests::manifold_fault(wood.indices, wood.positions_m.size());
        if (fault.empty() && tests::volume_of(wood) <= 0) fault = "inside out";
        if (fault.empty() && tests::degenerate_triangles(wood) > 0) fault = "triangles without area";
        if (fault.empty()) fault = read_by_assimp(mesh::to_obj(model), wood.triangle_count());
        if (fault.empty()) return;
        const std::scoped_lock lock(mutex);
        faults += std::to_string(seed) + ": " + fault + "\n";
    });
    EXPECT_EQ(faults, "");
}

TEST(TreeExport, OfEveryWayOfMeshingIsClosed) {
    const genome::Recipe recipe = genome::random_recipe(base::Seed{5});
    for (const char* name : {"drawn", "smooth", "swept", "cylinders"}) {
        const mesh::Mesh wood = tree_model(recipe, limbs_from(name)).parts.front().mesh;
        EXPECT_GT(wood.triangle_count(), 500U) << name;
        EXPECT_EQ(tests::manifold_fault(wood.indices, wood.positions_m.size()), "") << name;
    }
}

TEST(TreeExport, ClampsParametersThatNoSceneCanHaveInsteadOfFailing) {
    const tests::TemporaryFolder folder;
    folder.write("wild.json",
                 R"({"quadrat":"scene","version":1,"seeds":{"trees":"0000000000000001","land":"0000000000000002",)"
                 R"("sky":"0000000000000003"},"camera":"0000000000000004",)"
                 R"("parameters":{"tree.height_m":9000,"tree.type":-3,"tree.girth":1.1}})");
    EXPECT_THROW(read_scene((folder / "wild.json").string()), base::InputError);
    const genome::Recipe recipe = read_scene_clamped((folder / "wild.json").string()).scenes.front();
    EXPECT_EQ(recipe.values[*genome::parameter_named("tree.height_m")],
              genome::parameter(*genome::parameter_named("tree.height_m")).max);
    EXPECT_EQ(recipe.values[*genome::parameter_named("tree.type")],
              genome::parameter(*genome::parameter_named("tree.type")).min);
    EXPECT_FLOAT_EQ(recipe.values[*genome::parameter_named("tree.girth")], 1.1F);
    EXPECT_GT(tree_model(recipe, Limbs::AsDrawn).parts.front().mesh.triangle_count(), 100U);
    EXPECT_THROW(read_scene_clamped((folder / "none.json").string()), base::InputError);
}

}  // namespace
}  // namespace quadrat::pictures
