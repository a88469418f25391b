// The STL and PLY readers beside assimp, which reads coordinates as float: as many faces, and every
// vertex of one is a vertex of the other: exactly where the file has floats, within a float's
// rounding where it has decimals.
#include "tests/tools/models/model_texts.hpp"
#include "tests/support/effort.hpp"

#ifdef UMBRA78_ASSIMP
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#endif

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace umbra78::tools::test {
namespace {

#ifdef UMBRA78_ASSIMP

using Place = std::array<double, 3>;

struct Imported {
    std::size_t triangles = 0;
    std::vector<Place> vertices;
};

Imported by_assimp(const std::string& path) {
    Imported imported;
    const aiScene* scene = aiImportFile(path.c_str(), aiProcess_Triangulate);
    EXPECT_NE(scene, nullptr) << path << ": " << aiGetErrorString();
    if (!scene) return imported;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        const aiMesh& mesh = *scene->mMeshes[m];
        imported.triangles += mesh.mNumFaces;
        for (unsigned k = 0; k < mesh.mNumVertices; ++k)
            imported.vertices.push_back(
                {mesh.mVertices[k].x, mesh.mVertices[k].y, mesh.mVertices[k].z});
    }
    aiReleaseImport(scene);
    return imported;
}

// How far the vertex farthest from its nearest one of the others is, as a share of its size.
double apart(const std::vector<Place>& some, const std::vector<Place>& others) {
    double most = 0;
    for (const Place& p : some) {
        double least = HUGE_VAL;
        for (const Place& q : others) {
            double off = 0;
            for (std::size_t k = 0; k < 3; ++k)
                off = std::max(off, std::abs(p[k] - q[k]) / std::max(1.0, std::abs(p[k])));
            least = std::min(least, off);
        }
        most = std::max(most, least);
    }
    return most;
}

TEST(Assimp, StlAndPlyHaveTheSameFacesAndVertices) {
    const struct {
        const char* name;
        double apart;  // 2^-33: half a word
    } files[] = {
        {"STL/Spider_binary.stl", 0x1p-33}, {"STL/Wuson.stl", 0x1p-33},
        {"STL/3DSMaxExport.STL", 0x1p-33},  {"PLY/cube_binary.ply", 0x1p-33},
        {"STL/Spider_ascii.stl", 0x1p-22},  {"STL/sphereWithHole.stl", 0x1p-22},
        {"STL/triangle_with_two_solids.stl", 0x1p-22}, {"PLY/cube.ply", 0x1p-22},
        {"PLY/cube_uv.ply", 0x1p-22},       {"PLY/float-color.ply", 0x1p-22},
    };
    const char* root = std::getenv("UMBRA78_MODELS_DATA");
    for (const auto& file : files) {
        const std::string path =
            (root ? root : "") + std::string("/usr/share/assimp/models/") + file.name;
        std::ifstream stream(path, std::ios::binary);
        if (!stream) GTEST_SKIP() << "without the package assimp-testmodels";
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        if (umbra78::test::sanitized && text.size() > 100'000) continue;
        const ModelResult ours = read_model(text, path);
        ASSERT_EQ(ours.error, "");
        std::vector<Place> vertices;
        for (const ModelPoint& p : ours.model.vertices) {
            vertices.emplace_back();
            for (std::size_t k = 0; k < 3; ++k)
                vertices.back()[k] = std::ldexp(static_cast<double>(p.word[k]), -model_fraction);
        }
        const Imported theirs = by_assimp(path);
        EXPECT_EQ(ours.model.facets.size() + ours.model.no_area, theirs.triangles) << file.name;
        EXPECT_LE(apart(vertices, theirs.vertices), file.apart) << file.name;
        if (ours.model.no_area == 0) {  // else some are named by no facet
            EXPECT_LE(apart(theirs.vertices, vertices), file.apart) << file.name;
        }
    }
}

#else

TEST(Assimp, IsNotCompared) {
    GTEST_SKIP() << "built without assimp (libassimp-dev)";
}

#endif

}  // namespace
}  // namespace umbra78::tools::test
