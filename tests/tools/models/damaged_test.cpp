// Damaged files: whatever a file holds, it is read, or refused in one line with file and line, or
// the place in a binary file.
#include "tests/tools/models/binary_texts.hpp"
#include "tests/tools/models/model_texts.hpp"
#include "tests/support/effort.hpp"

#include <random>
#include <regex>

namespace umbra78::tools::test {
namespace {

// A short file of each format, all of whose statements are there.
std::vector<std::pair<std::string, std::string>> whole_files() {
    std::string tea = "1\n1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16\n16\n" + patch_points(3);
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv .5 .25 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\n"
                            "f 1/1/1 2/1/1 3/1/1 4//-1 -1//1\nf 1 2 \\\n 3\nl 1 2\ng a\n";
    std::string spline = patch_points(0);
    for (std::size_t at = 0; at < spline.size(); at = spline.find('\n', at) + 1)
        spline.insert(at, "v ");
    spline += "cstype bspline\ndeg 3 3\nsurf 3 4 3 4 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\n"
              "parm u 0 1 2 3 4 5 6 7\nparm v 0 1 2 3 4 5 6 7\nend\n";
    const std::string stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                            "vertex 1 0 0\nvertex 0 1.5 0\nendloop\nendfacet\nendsolid a\n";
    const std::string ply = "element vertex 4\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 1\n"
                            "property list uchar uchar vertex_indices\nend_header\n";
    const std::string ply_text = "ply\nformat ascii 1.0\n" + ply +
                                 "0 0 0\n1 0 0\n1 1 0\n0 1 .5\n4 0 1 2 3\n";
    std::string ply_bytes = "ply\nformat binary_big_endian 1.0\n" + ply;
    for (const float v : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, .5f})
        ply_bytes += bytes_of(v, true);
    ply_bytes += std::string("\4\0\1\2\3", 5);
    return {{"a.stl", stl}, {"b.stl", binary_stl({0, 0, 0, 1, 0, 0, 0, 1, 0})},
            {"a.ply", ply_text}, {"b.ply", ply_bytes},
            {"a.bpt", "1\n3 3\n" + patch_points(1)}, {"a.bez", "BBP\n" + patch_points(2)},
            {"a.tea", tea}, {"a.obj", obj}, {"b.obj", spline}};
}

// One to four changes: a byte set, taken out, put in, or the end cut off.
std::string damaged(std::string text, std::mt19937& random) {
    static constexpr char bytes[] = "0123456789-+.eE/\\,# \t\r\n\0nanvfBEZ\x80\xFF";
    const auto some_byte = [&] { return bytes[random() % (sizeof bytes - 1)]; };
    for (unsigned changes = 1 + random() % 4; changes > 0 && !text.empty(); --changes) {
        const std::size_t at = random() % text.size();
        switch (random() % 4) {
            case 0: text[at] = some_byte(); break;
            case 1: text.erase(at, 1 + random() % 3); break;
            case 2: text.insert(at, 1 + random() % 3, some_byte()); break;
            default: if (random() % 8 == 0) text.resize(at);
        }
    }
    return text;
}

TEST(Damaged, FilesAreReadOrRefusedInOneLine) {
    constexpr unsigned seed = 1978;
    std::mt19937 random(seed);
    const std::regex one_line("[ab]\\.(bpt|bez|tea|obj|stl|ply)(:[0-9]+)?: [ -~]+");
    int refused = 0, read = 0;
    for (const auto& [name, text] : whole_files()) {
        ASSERT_EQ(read_model(text, name).error, "");
        for (int n = 0; n < umbra78::test::effort(4000); ++n) {
            const std::string bad = damaged(text, random);
            const ModelResult result = read_model(bad, name);
            ++(result.ok() ? read : refused);
            if (!result.ok()) {
                ASSERT_TRUE(std::regex_match(result.error, one_line))
                    << result.error << "\nseed " << seed << ", case " << n << ":\n" << bad;
            }
        }
    }
    EXPECT_GT(refused, umbra78::test::effort(4000));
    EXPECT_GT(read, umbra78::test::effort(2000));
}

}  // namespace
}  // namespace umbra78::tools::test
