// The OBJ reader beside tinyobjloader, which reads coordinates as float: the same vertices in the
// same order, and as many triangles. It counts a face's corners in a byte, so faces of more than
// 255 corners, as in assimp's box_longline.obj, cannot be compared.
#include "tests/tools/models/model_texts.hpp"

#ifdef UMBRA78_TINYOBJ
#include <tiny_obj_loader.h>
#endif

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace umbra78::tools::test {
namespace {

#ifdef UMBRA78_TINYOBJ

struct Counted {
    std::size_t triangles = 0;
    std::vector<std::array<double, 3>> used;  // vertices that a face names, in the file's order
};

Counted by_tiny_obj(const std::string& text) {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::string warning, error;
    std::istringstream stream(text);
    const bool fine = tinyobj::LoadObj(&attributes, &shapes, nullptr, &warning, &error, &stream,
                                       nullptr, false, false);
    EXPECT_TRUE(fine) << error;
    Counted counted;
    std::set<int> numbers;
    for (const tinyobj::shape_t& shape : shapes) {
        for (const int corners : shape.mesh.num_face_vertices)
            counted.triangles += static_cast<std::size_t>(corners - 2);
        for (const tinyobj::index_t& index : shape.mesh.indices) numbers.insert(index.vertex_index);
    }
    for (const int n : numbers) {
        const float* p = &attributes.vertices[3 * static_cast<std::size_t>(n)];
        counted.used.push_back({p[0], p[1], p[2]});
    }
    return counted;
}

void compare(const std::string& text, const std::string& what) {
    const ModelResult ours = read_model(text, "a.obj");
    ASSERT_TRUE(ours.ok()) << what << ": " << ours.error;
    const Counted theirs = by_tiny_obj(text);
    EXPECT_EQ(ours.model.facets.size() + ours.model.no_area, theirs.triangles) << what;
    if (ours.model.no_area > 0) return;  // the vertices of what was left out may be, too
    ASSERT_EQ(ours.model.vertices.size(), theirs.used.size()) << what;
    for (std::size_t k = 0; k < theirs.used.size(); ++k)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double word = std::ldexp(static_cast<double>(ours.model.vertices[k].word[axis]),
                                           -model_fraction);
            EXPECT_NEAR(word, theirs.used[k][axis], 1e-6 * (1 + std::abs(word)))
                << what << " " << k;
        }
}

TEST(TinyObj, ReadsAwkwardTextsAlike) {
    const std::string house = "v 0 0 0\nv 4 0 0\nv 4 3 1e0\nv 2 1 .5\nv 0 3 1.\nv 9 9 9\n";
    for (const std::string& text :
         {house + "f 1 2 3 4 5\n", house + "f -6 -5 -4 -3\nf 1//1 2//1 3//1\nvn 0 0 1\n",
          house + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1/1 3/1 5/1\n# f 1 2\n\ng a b\no c\n"
                  "s off\nusemtl x\nf  1   2\t4 \n",
          with_crlf(house + "f 1 2 3\r\nf 3 4 5\n")})
        compare(text, text);
}

TEST(TinyObj, ReadsFilesOfPackagesAlike) {
    const char* root = std::getenv("UMBRA78_MODELS_DATA");
    int files = 0;
    for (const char* path :
         {"glmark2/models/bunny.obj", "assimp/models/OBJ/spider.obj",
          "assimp/models/OBJ/WusonOBJ.obj", "assimp/models/OBJ/box.obj",
          "assimp/models/OBJ/testmixed.obj",
          "assimp/models/OBJ/concave_polygon.obj", "assimp/models/OBJ/regr_3429812.obj",
          "assimp/models/OBJ/cube_with_vertexcolors.obj"}) {
        std::ifstream file((root ? root : "") + ("/usr/share/" + std::string(path)));
        if (!file) continue;
        compare({std::istreambuf_iterator<char>(file), {}}, path);
        ++files;
    }
    if (files == 0) GTEST_SKIP() << "without the packages glmark2-data and assimp-testmodels";
}

#else

TEST(TinyObj, ReadsAwkwardTextsAlike) {
    GTEST_SKIP() << "built without tinyobjloader (libtinyobjloader-dev)";
}

#endif

}  // namespace
}  // namespace umbra78::tools::test
