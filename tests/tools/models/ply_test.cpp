// PLY as text and binary: the same words, elements and properties that are skipped, errors.
#include "tests/tools/models/binary_texts.hpp"
#include "tests/tools/models/model_texts.hpp"

#include <cmath>
#include <limits>

namespace umbra78::tools::test {
namespace {

using Facets = std::vector<std::array<std::uint32_t, 3>>;

ModelData ply_of(const std::string& text) {
    ModelResult result = read_model(text, "a.ply");
    EXPECT_EQ(result.error, "") << text;
    return std::move(result.model);
}

const std::string ply_places = "property float x\nproperty float y\nproperty float z\n";
const std::string ply_faces = "element face 1\nproperty list uchar int vertex_indices\n"
                              "end_header\n";
const std::string ply_head = "ply\nformat ascii 1.0\n";
const std::string ply_square = ply_head + "element vertex 5\n" + ply_places + ply_faces +
                           "0 0 0\n1 0 0\n9 9 9\n1 1.5 0\n0 1 -.25\n4 0 1 3 4\n";
const Facets ply_two{{3, 0, 1}, {3, 1, 2}};

TEST(Ply, VerticesAreExactWordsAndFacesTriangles) {
    for (const std::string& text : {ply_square, with_crlf(ply_square)}) {
        const ModelData model = ply_of(text);
        EXPECT_EQ(facets_of(model), ply_two);
        ASSERT_EQ(model.vertices.size(), 4u);  // the third is not used
        EXPECT_EQ(model.vertices[2].word, (std::array<std::int64_t, 3>{model_one, model_one * 3 / 2,
                                                                       0}));
        EXPECT_EQ(model.vertices[2].line, 13);
        EXPECT_EQ(model.facets[0].normal[0], raster::Facet::flat);
    }
}

// Everything that may be there: comments, other elements before and between, lists and scalars of
// all types beside those that are read, normals, coordinates as double, float and whole numbers.
struct Binary {
    bool big;
    std::string text;

    explicit Binary(bool is_big) : big(is_big) {
        text = "ply\nformat binary_" + std::string(big ? "big" : "little") + "_endian 1.0\n"
               "comment made for a test\nobj_info x\nelement camera 2\nproperty double a\n"
               "property list ushort short b\nelement nothing 1000000000000\n"
               "element face 2\nproperty uchar flags\nproperty list int uint vertex_index\n"
               "property list char double weights\nelement vertex 5\nproperty int16 x\n"
               "property list uint8 float32 t\nproperty float64 y\nproperty float nx\n"
               "property float ny\nproperty float nz\nproperty float z\nproperty uchar red\n"
               "end_header\n";
        for (int k = 0; k < 2; ++k) number(1e300).whole(k, 2).whole(9, 2 * k);
        whole(7, 1).whole(4, 4).whole(0, 4).whole(1, 4).whole(3, 4).whole(4, 4).whole(0, 1);
        whole(7, 1).whole(3, 4).whole(4, 4).whole(3, 4).whole(1, 4).whole(1, 1).number(NAN);
        vertex(0, 0, 0), vertex(1, 0, 0), vertex(9, 9, 9), vertex(1, 1.5, 0), vertex(0, 1, -0.25f);
    }
    Binary& whole(std::uint64_t v, int bytes) {
        text += bytes == 0 ? "" : bytes_of(v, bytes, big);
        return *this;
    }
    Binary& number(double v) {
        text += bytes_of(v, big);
        return *this;
    }
    void vertex(int x, double y, float z) {
        whole(static_cast<std::uint64_t>(x), 2).whole(1, 1).whole(0x7FC00000, 4).number(y);
        for (const float n : {0.0f, 0.5f, 2.0f, z}) text += bytes_of(n, big);
        whole(255, 1);
    }
};

TEST(Ply, BinaryOfBothByteOrders) {
    for (const bool big : {false, true}) {
        const ModelData model = ply_of(Binary(big).text);
        EXPECT_EQ(facets_of(model), (Facets{{3, 0, 1}, {3, 1, 2}, {3, 2, 1}})) << big;
        ASSERT_EQ(model.vertices.size(), 4u);
        const ModelData text = ply_of(ply_square);
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_EQ(model.vertices[k].word, text.vertices[k].word) << k;
        EXPECT_EQ(model.vertices[3].line, 4);  // its number in the file
        ASSERT_EQ(model.normals.size(), 4u);
        EXPECT_EQ(model.normals[1].word, (std::array<std::int64_t, 3>{0, model_one / 2,
                                                                      2 * model_one}));
        EXPECT_EQ(model.facets[1].normal, (std::array<std::uint32_t, 3>{3, 1, 2}));
    }
}

TEST(Ply, NormalsAreTakenIfAllThreeAreThere) {
    const auto with = [](const std::string& properties, const std::string& more) {
        return ply_of(ply_head + "element vertex 3\n" + properties + ply_places + ply_faces +
                      more + "0 0 0\n" + more + "1 0 0\n" + more + "0 1 0\n3 0 1 2\n");
    };
    EXPECT_EQ(with("property float nx\nproperty float ny\nproperty float nz\n", "0 .5 1 ")
                  .normals.size(), 3u);
    EXPECT_EQ(with("property float nx\nproperty float nz\n", "0 nan ").normals.size(), 0u);
    EXPECT_EQ(with("property list uchar float nx\n", "2 0 1 ").normals.size(), 0u);
}

TEST(PlyErrors, Headers) {
    const std::string& head = ply_head;
    std::string many = head;
    for (int k = 0; k < 300; ++k) many += "element e" + std::to_string(k) + " 0\n";
    expect_messages({
        {"a.ply", "", "a.ply:1: the file does not begin with the line 'ply'; name another file"},
        {"a.ply", "plyx\n",
         "a.ply:1: the file does not begin with the line 'ply'; name another file"},
        {"a.ply", "ply\n", "a.ply:1: the file ends in its header; add end_header and the data"},
        {"a.ply", "ply\nend_header\n",
         "a.ply:2: the header has no format; add 'format ascii 1.0' below 'ply'"},
        {"a.ply", "ply\nformat ascii 2.0\n",
         "a.ply:2: the format is unknown; write 'format ascii 1.0', binary_little_endian or "
         "binary_big_endian"},
        {"a.ply", head + "elemnt vertex 3\n",
         "a.ply:3: 'elemnt' begins no line of a PLY header; remove the line, or begin it with "
         "comment"},
        {"a.ply", head + "element vertex -3\n",
         "a.ply:3: an element needs a name and a count; write 'element vertex 8'"},
        {"a.ply", head + "element vertex 99999999999999999999\n",
         "a.ply:3: an element needs a name and a count; write 'element vertex 8'"},
        {"a.ply", head + "element a 1\nelement a 2\n",
         "a.ply:4: there is an element 'a' already; remove one"},
        {"a.ply", many,
         "a.ply:259: there are more than 256 elements; remove those that are not vertex and face"},
        {"a.ply", head + "property float x\n",
         "a.ply:3: a property stands before the first element; move it below its element"},
        {"a.ply", head + "element vertex 3\nproperty list float x\n",
         "a.ply:4: a property needs a type and a name; write 'property float x' or 'property list "
         "uchar int vertex_indices'"},
        {"a.ply", head + "element vertex 3\nproperty real x\n",
         "a.ply:4: 'real' is no type; write char, uchar, short, ushort, int, uint, float or "
         "double"},
        {"a.ply", head + "element face 3\nproperty list float int vertex_index\n",
         "a.ply:4: 'float' counts no list; write uchar or another whole type"},
        {"a.ply", head + ply_faces, "a.ply:5: the header has no element vertex; name another file"},
        {"a.ply", head + "element vertex 3\nproperty float x\nproperty float y\n" + ply_faces,
         "a.ply:3: the element vertex has 0 properties z; give it one that is no list"},
        {"a.ply", head + "element vertex 3\nproperty float x\n" + ply_places + ply_faces,
         "a.ply:3: the element vertex has 2 properties x; give it one that is no list"},
        {"a.ply", head + "element vertex 3\n" + ply_places + "end_header\n0 0 0\n",
         "a.ply:7: the file holds no faces; a surface needs an element face with a list "
         "vertex_indices"},
        {"a.ply", head + "element vertex 3\n" + ply_places + "element face 1\n"
                  "property list uchar int vertex_index\nproperty list uchar int vertex_indices\n"
                  "end_header\n",
         "a.ply:7: the element face has two lists of vertices; remove one"},
    });
}

TEST(PlyErrors, DataAsText) {
    const auto changed = [](const std::string& from, const std::string& to) {
        std::string text = ply_square;
        return text.replace(text.rfind(from), from.size(), to);
    };
    const std::string lines = " does not begin a line; the lines do not hold what the "
                              "header's properties say: correct one of them";
    expect_messages({
        {"a.ply", ply_square.substr(0, ply_square.size() - 4),
         "a.ply:15: the file ends in element 'face' 0 of 1; add the rest, or correct the counts"},
        {"a.ply", changed("vertex 5", "vertex 1000000000000"),
         "a.ply:15: element 'vertex' 6 of 1000000000000" + lines},
        {"a.ply", changed("face 1", "face 1000000000000"),
         "a.ply:16: the file ends in element 'face' 1 of 1000000000000; add the rest, or correct "
         "the counts"},
        {"a.ply", changed("9 9 9\n", ""), "a.ply:14: element 'face' 0 of 1" + lines},
        {"a.ply", changed("9 9 9", "9 9"), "a.ply:13: element 'vertex' 3 of 5" + lines},
        {"a.ply", changed("9 9 9", "9 9 9 9"), "a.ply:12: element 'vertex' 3 of 5" + lines},
        {"a.ply", ply_square + "3 0 1 2\n",
         "a.ply:16: '3' follows the last element; correct the counts of the header, or remove it"},
        {"a.ply", changed("9 9 9", "9 nan 9"),
         "a.ply:12: 'nan' is no coordinate; write a decimal, such as -2.5"},
        {"a.ply", changed("9 9 9", "9 1e300 9"),
         "a.ply:12: the coordinate '1e300' is beyond -1048576 .. 1048576; scale the file's points"},
        {"a.ply", changed("4 0 1 3 4", "4 0 1 3 5"),
         "a.ply:15: vertex 5 is named; there are 5, numbered from 0: correct the number"},
        {"a.ply", changed("4 0 1 3 4", "4 0 1 3 -1"),
         "a.ply:15: vertex -1 is named; there are 5, numbered from 0: correct the number"},
        {"a.ply", changed("4 0 1 3 4", "4 0 1 3 4.0"),
         "a.ply:15: '4.0' is no whole number that fits; correct it"},
        {"a.ply", changed("4 0 1 3 4", "2 0 1"),
         "a.ply:15: a face has 2 corners; give 3 .. 1024"},
        {"a.ply", changed("4 0 1 3 4", "1000000000000 0 1"),
         "a.ply:15: a face has 1000000000000 corners; give 3 .. 1024"},
        {"a.ply", changed("4 0 1 3 4", "-4 0 1"),
         "a.ply:15: a list 'vertex_indices' has -4 items; correct the count"},
    });
}

TEST(PlyErrors, DataInBinary) {
    const std::string whole = Binary(false).text;
    const std::size_t data = whole.find("end_header\n") + 11, face = data + 2 * 8 + 2 + 2 + 2;
    const std::size_t vertex = whole.size() - 5 * 32;
    const auto changed = [&](std::size_t at, const std::string& to) {
        return std::string(whole).replace(at, to.size(), to);
    };
    const auto counted = [&](const std::string& from, const std::string& to) {
        return std::string(whole).replace(whole.find(from), from.size(), to);
    };
    const std::string ends = " the file ends in it; add the rest, or correct the counts of the "
                             "header";
    const float nan = std::numeric_limits<float>::quiet_NaN();
    expect_messages({
        {"a.ply", whole.substr(0, whole.size() - 1), "a.ply: element 'vertex' 4 of 5:" + ends},
        {"a.ply", whole.substr(0, data), "a.ply: element 'camera' 0 of 2:" + ends},
        {"a.ply", counted("vertex 5", "vertex 1000000000000"),
         "a.ply: element 'vertex' 5 of 1000000000000:" + ends},
        {"a.ply", counted("camera 2", "camera 1000000000000"),
         "a.ply: element 'camera' 2 of 1000000000000:" + ends},
        {"a.ply", whole + "xy",
         "a.ply: 2 bytes follow the last element; correct the counts of the header, or remove "
         "them"},
        {"a.ply", changed(face + 1, bytes_of(std::uint64_t{0x7FFFFFFF}, 4)),
         "a.ply: element 'face' 0 of 2: a face has 2147483647 corners; give 3 .. 1024"},
        {"a.ply", changed(face + 1, bytes_of(~std::uint64_t{0}, 4)),
         "a.ply: element 'face' 0 of 2: a list 'vertex_index' has -1 items; correct the count"},
        {"a.ply", changed(face + 9, bytes_of(~std::uint64_t{0}, 4)),
         "a.ply: element 'face' 0 of 2: vertex 4294967295 is named; there are 5, numbered from 0: "
         "correct the number"},
        {"a.ply", changed(vertex + 32 + 7, bytes_of(1e300)),
         "a.ply: vertex 1: a coordinate is beyond -1048576 .. 1048576; scale the file's points"},
        {"a.ply", changed(vertex + 64 + 27, bytes_of(nan)),
         "a.ply: vertex 2: a coordinate is infinite or no number; write the file again with finite "
         "ones"},
    });
}

}  // namespace
}  // namespace umbra78::tools::test
