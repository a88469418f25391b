// STL, text and binary: the same words, corners that become one vertex, errors.
#include "tests/tools/models/binary_texts.hpp"
#include "tests/tools/models/model_texts.hpp"
#include "tools/models/place_model.hpp"

#include <cmath>
#include <limits>

namespace umbra78::tools::test {
namespace {

using Facets = std::vector<std::array<std::uint32_t, 3>>;

ModelData stl_of(const std::string& text) {
    ModelResult result = read_model(text, "a.stl");
    EXPECT_EQ(result.error, "") << text;
    return std::move(result.model);
}

std::string stl_facet(const std::string& a, const std::string& b, const std::string& c) {
    return " facet normal 0 0 1\n  outer loop\n   vertex " + a + "\n   vertex " + b +
           "\n   vertex " + c + "\n  endloop\n endfacet\n";
}

const std::string stl_square = "solid square 1\n" + stl_facet("0 0 0", "1 0 0", "1 1.5 0") +
                           stl_facet("0 0 0", "1 1.5 0", "0 1 -.25") + "endsolid square 1\n";
const std::vector<float> stl_square_floats{0, 0, 0, 1, 0,    0, 1, 1.5f, 0,
                                       0, 0, 0, 1, 1.5f, 0, 0, 1,    -0.25f};

TEST(Stl, CornersAtTheSamePlaceAreOneVertex) {
    for (const std::string& text :
         {stl_square, with_crlf(stl_square), "\n\t " + stl_square + " # made",
          binary_stl(stl_square_floats), binary_stl(stl_square_floats, "solid but binary")}) {
        const ModelData model = stl_of(text);
        EXPECT_EQ(facets_of(model), (Facets{{0, 1, 2}, {0, 2, 3}}));
        ASSERT_EQ(model.vertices.size(), 4u);
        EXPECT_EQ(model.vertices[2].word, (std::array<std::int64_t, 3>{model_one, model_one * 3 / 2,
                                                                       0}));
        EXPECT_EQ(model.vertices[3].word, (std::array<std::int64_t, 3>{0, model_one,
                                                                       -model_one / 4}));
        EXPECT_TRUE(model.normals.empty());
        EXPECT_EQ(model.facets[0].normal[0], raster::Facet::flat);
    }
    EXPECT_EQ(stl_of(stl_square).vertices[3].line, 13);
    EXPECT_EQ(stl_of(binary_stl(stl_square_floats)).vertices[3].line, 2);
    // 0 and -0 are the same place; a hair beside it is another.
    const float hair = 1.0f / (1 << 30);
    EXPECT_EQ(stl_of(binary_stl({0, 0, 0, 1, 0, 0, 0, 1, 0, -0.0f, 0, 0, 1, hair, 0, 0, 1, 0}))
                  .vertices.size(), 4u);
}

TEST(Stl, ManySolidsEmptyOnesAndCapitals) {
    std::string text = stl_square + "SOLID\nENDSOLID\n\n" + stl_square;
    for (char& c : text)
        if (text.size() > 5) c = c == 'f' ? 'F' : c;
    EXPECT_EQ(stl_of(text).facets.size(), 4u);
    EXPECT_EQ(stl_of(text).vertices.size(), 4u);
}

// Its normals are not used: they may be anything.
TEST(Stl, WithoutAreaIsCountedAndNormalsAreSkipped) {
    std::string text = "solid\n" + stl_facet("0 0 0", "1 1 1", "2 2 2") +
                       stl_facet("0 0 0", "1 0 0", "0 1 0");
    text.replace(text.find("0 0 1"), 5, "nan inf x") += "endsolid";
    const ModelData model = stl_of(text);
    EXPECT_EQ(model.no_area, 1u);
    EXPECT_EQ(model.facets.size(), 1u);
    EXPECT_EQ(model.vertices.size(), 3u);
}

// What is placed out of the world is named by its line, or by its triangle.
TEST(Stl, PlacesInErrors) {
    const auto error_of = [](const std::string& text) {
        FirstError error;
        place_model(stl_of(text), {.scale = std::int64_t{10000} << scale_fraction},
                    "make it smaller", error);
        return error.line();
    };
    const std::string where = ": this point lies at [0, 40000, 0] in the world, which ends at "
                              "-32767 and 32767; make it smaller";
    EXPECT_EQ(error_of("solid\n" + stl_facet("0 0 0", "0 4 0", "1 0 0") + "endsolid"),
              "a.stl:5" + where);
    EXPECT_EQ(error_of(binary_stl({0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 4, 0, 1, 0, 0})),
              "a.stl: triangle 2" + where);
}

TEST(StlErrors, Text) {
    const std::string wrong = " belongs; correct the facet or solid that it is in";
    std::string four = stl_square;
    four.insert(four.find("  endloop"), "vertex 1 2 3\n");
    expect_messages({
        {"a.stl", "", "a.stl:1: the file holds no numbers; give it a model, or name another file"},
        {"a.stl", "solid\n",
         "a.stl:2: the file ends in a solid; add the rest, or correct the counts"},
        {"a.stl", "solid a\nendsolid a\n",
         "a.stl: the file holds no triangles; name another file"},
        {"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n",
         "a.stl:5: the file ends in facet 1; add the rest, or correct the counts"},
        {"a.stl", "solid a\nfacet normal 0 0\nouter loop\nvertex 0 0 0",
         "a.stl:3: 'loop' stands where 'outer'" + wrong},
        {"a.stl", "solid a\nfacte normal 0 0 1\n",
         "a.stl:2: 'facte' stands where 'endsolid'" + wrong},
        {"a.stl", four, "a.stl:7: 'vertex' stands where 'endloop'" + wrong},
        {"a.stl", "solid\n" + stl_facet("0 0 0", "1 nan 0", "0 1 0"),
         "a.stl:5: 'nan' is no coordinate; write a decimal, such as -2.5"},
        {"a.stl", "solid\n" + stl_facet("0 0 0", "1 0 1e300", "0 1 0"),
         "a.stl:5: the coordinate '1e300' is beyond -1048576 .. 1048576; scale the file's points"},
        {"a.stl", stl_square + "x",
         "a.stl:17: 'x' stands where 'solid'" + wrong},
    });
}

TEST(StlErrors, Binary) {
    const std::string whole = binary_stl(stl_square_floats);
    const auto with = [](float bad) {
        std::vector<float> floats = stl_square_floats;
        floats[13] = bad;
        return binary_stl(floats);
    };
    const std::string no_number = "a.stl: triangle 2: a coordinate is infinite or no number; write "
                                  "the file again with finite ones";
    const std::string beyond = "a.stl: triangle 2: a coordinate is beyond -1048576 .. 1048576; "
                               "scale the file's points";
    const auto size = [](long triangles, long bytes, long has) {
        return "a.stl: the header counts " + std::to_string(triangles) +
               " triangles, which would be a file of " + std::to_string(bytes) + " bytes; it has " +
               std::to_string(has) + ": write it again, whole";
    };
    std::string huge = whole;
    huge.replace(80, 4, "\xFF\xFF\xFF\xFF");
    expect_messages({
        {"a.stl", with(std::numeric_limits<float>::quiet_NaN()), no_number},
        {"a.stl", with(-HUGE_VALF), no_number},
        {"a.stl", with(1e30f), beyond},
        {"a.stl", with(-1048577), beyond},
        {"a.stl", whole.substr(0, 183), size(2, 184, 183)},
        {"a.stl", whole + "\n", size(2, 184, 185)},
        {"a.stl", huge, size(4294967295, 214748364834, 184)},
        {"a.stl", whole.substr(0, 84), size(2, 184, 84)},
        {"a.stl", binary_stl({}), "a.stl: the file holds no triangles; name another file"},
        {"a.stl", whole.substr(0, 83),
         "a.stl: the file is neither text, which begins with 'solid', nor as long as a binary "
         "header; name another file"},
    });
}

}  // namespace
}  // namespace umbra78::tools::test
