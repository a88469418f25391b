// Malformed scene files: grammar, the scene as a whole, surfaces and materials.
#include "tests/tools/scene/malformed.hpp"

namespace umbra78::tools::test {
namespace {

TEST(SceneErrors, TextThatIsNoToml) {
    expect_messages({
        {"light = \n",
         "a.toml:1: this is not valid TOML: Error while parsing key-value pair: expected value, "
         "saw '\\n'"},
        {"[=]\n",
         "a.toml:1: this is not valid TOML: Error while parsing key: expected bare key starting "
         "character or string delimiter, saw '='"},
        {"[light\n",
         "a.toml:1: this is not valid TOML: Error while parsing table header: expected ']', saw "
         "'\\n'"},
        {"[light]\nazimuth = 1\nazimuth = 2\n",
         "a.toml:3: this is not valid TOML: Error while parsing key-value pair: cannot redefine "
         "existing integer 'azimuth'"},
        {"[light]\nazimuth = 1 elevation = 2\n",
         "a.toml:2: this is not valid TOML: Error while parsing key-value pair: expected a comment "
         "or whitespace, saw 'e'"},
        {"[light]\nazimuth = 99999999999999999999\n",
         "a.toml:2: this is not valid TOML: Error while parsing decimal integer: "
         "'99999999999999999999' is not representable in 64 bits"},
        {"[light]\nkind = \"\\q\"\n",
         "a.toml:2: this is not valid TOML: Error while parsing string: unknown escape sequence "
         "'\\q'"},
    });
}

TEST(SceneErrors, TheWholeScene) {
    expect_messages({
        {"",
         "a.toml: there is no [light]; add [light] and azimuth = -100, or another"},
        {ball,
         "a.toml: there is no [light]; add [light] and azimuth = -100, or another"},
        {"[ligth]\nazimuth = 1\n",
         "a.toml:1: unknown key 'ligth' in the scene; did you mean 'light'?"},
        {"title = \"a\"\n",
         "a.toml:1: unknown key 'title' in the scene; known here: observer, light, "
         "material, sphere, plane, patch, torus, cylinder, cone, box, triangle, model, "
         "stream, settings"},
        {"light = 3\n",
         "a.toml:1: [light] is the number 3; write [light] and its keys below it"},
        {"light = [3]\n",
         "a.toml:1: [[light]] is the number 3; write [[light]] and its keys below it"},
        {"[sphere]\ncentre = [0, 0, 0]\n",
         "a.toml:1: [sphere] must be written [[sphere]]: there may be many"},
        {"sphere = [3]\n",
         "a.toml:1: [[sphere]] is the number 3; write [[sphere]] and its keys below it"},
    });
}

TEST(SceneErrors, Surfaces) {
    expect_messages({
        {"[[sphere]]\ncentre = [0, 0, 0]\nradios = 1\n",
         "a.toml:3: unknown key 'radios' in [[sphere]]; did you mean 'radius'?"},
        {"[[sphere]]\ncentre = [0, 0, 0]\n",
         "a.toml:1: [[sphere]] has no 'radius'; add radius = 1"},
        {"[[sphere]]\nradius = 1\n",
         "a.toml:1: [[sphere]] has no 'centre'; add centre = [0, 0, 0]"},
        {"[[sphere]]\ncentre = [0, 0]\nradius = 1\n",
         "a.toml:2: 'centre' in [[sphere]] is an array of 2; write [x, y, z]"},
        {"[[sphere]]\ncentre = 0\nradius = 1\n",
         "a.toml:2: 'centre' in [[sphere]] is the number 0; write [x, y, z]"},
        {"[[sphere]]\ncentre = [\n    0,\n    \"1\",\n    2]\nradius = 1\n",
         "a.toml:4: y of 'centre' in [[sphere]] is the text '1'; write a number"},
        {"[[sphere]]\ncentre = [0, 40000, 0]\nradius = 1\n",
         "a.toml:2: y of 'centre' in [[sphere]] is 40000; its range is -32767 .. 32767"},
        {"[[sphere]]\ncentre = [0, 0, 0]\nradius = 0\n",
         "a.toml:3: 'radius' in [[sphere]] is 0; its range is 2^-16 .. 32767"},
        {"[[sphere]]\ncentre = [0, 0, 0]\nradius = -1.5\n",
         "a.toml:3: 'radius' in [[sphere]] is -1.5; its range is 2^-16 .. 32767"},
        {"[[sphere]]\ncentre = [0, 0, 0]\nradius = \"1\"\n",
         "a.toml:3: 'radius' in [[sphere]] is the text '1'; write a number"},
        {"[[sphere]]\ncentre = [0, 0, 0]\nradius = 0x10\n",
         "a.toml:3: 'radius' in [[sphere]] is the number 0x10; write a decimal, such as 2.5"},
        {"[[sphere]]\ncentre = [0, 0, 0]\nradius = inf\n",
         "a.toml:3: 'radius' in [[sphere]] is the number inf; write a decimal, such as 2.5"},
        {"[[sphere]]\ncentre = [0, 0, 0]\nradius = true\n",
         "a.toml:3: 'radius' in [[sphere]] is a boolean; write a number"},
        {"[[sphere]]\ncentre = [0, 0, 0]\nradius = 1978-08-23\n",
         "a.toml:3: 'radius' in [[sphere]] is a date; write a number"},
        {"[[sphere]]\ncentre = [32766, 0, 0]\nradius = 2\n",
         "a.toml:3: the sphere reaches out of the world, -32767 .. 32767; scale the scene"},
    });
}

TEST(SceneErrors, Materials) {
    expect_messages({
        {"[[material]]\nname = \"clay\"\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n"
         "material = \"clya\"\n",
         "a.toml:6: unknown material 'clya' in [[sphere]]; did you mean 'clay'?"},
        {ball + "material = \"clay\"\n",
         "a.toml:4: unknown material 'clay' in [[sphere]]; add a [[material]] of that name"},
        {ball + "material = 1\n",
         "a.toml:4: 'material' in [[sphere]] is the number 1; write a name in quotes"},
        {"[[material]]\ndiffuse = 1\n",
         "a.toml:1: [[material]] has no 'name'; add name = \"clay\""},
        {"[[material]]\nname = \"a\"\n[[material]]\nname = \"a\"\n",
         "a.toml:4: there is a material 'a' already; rename one"},
        {"[[material]]\nname = \"a\"\ndiffuse = 256\n",
         "a.toml:3: 'diffuse' in [[material]] is 256; its range is 0 .. 255"},
        {"[[material]]\nname = \"a\"\nshininess = 2.5\n",
         "a.toml:3: 'shininess' in [[material]] is the number 2.5; write a whole number"},
    });
}

TEST(SceneErrors, PlanesAndPatches) {
    expect_messages({
        {"[[plane]]\norigin = [0, 0, 0]\nu = [1, 2, 3]\n",
         "a.toml:1: [[plane]] has no 'v'; add v = [0, 0, -1]"},
        {"[[plane]]\norigin = [0, 0, 0]\nu = [1, 2, 3]\nv = [-2, -4, -6]\n",
         "a.toml:4: 'u' and 'v' in [[plane]] are parallel; turn one of them"},
        {"[[plane]]\norigin = [30000, 0, 0]\nu = [3000, 0, 0]\nv = [0, 1, 0]\n",
         "a.toml:1: the plane reaches out of the world, -32767 .. 32767; scale the scene"},
        {"[[patch]]\ncontrol = [[0, 0, 0], [1, 0, 0]]\n",
         "a.toml:2: 'control' in [[patch]] holds 2 points; write 16, or 4 rows of 4"},
        {"[[patch]]\ncontrol = [[0, 0, 0], [1, 0]]\n",
         "a.toml:2: point 1 of 'control' in [[patch]] is an array of 2; write [x, y, z]"},
        {"[[patch]]\ncontrol = [[[0, 0, 0], [1, 0, 0], [2, 0, 0]]]\n",
         "a.toml:2: a row of 'control' in [[patch]] holds 3 points; write 16 points, or 4 rows of "
         "4"},
        {"[[patch]]\ncontrol = \"flat\"\n",
         "a.toml:2: 'control' in [[patch]] holds 0 points; write 16, or 4 rows of 4"},
    });
}

// Of some such bytes the TOML library's own check is undefined. In texts and comments they may be.
TEST(SceneErrors, ACharacterThatIsNotAsciiStandsInTextsAndCommentsAlone) {
    const auto error = [](const std::string& text) {
        return error_of({text, {}});
    };
    const std::string stray = ": this is not valid TOML: a character that is not ASCII stands "
                              "outside a text in quotes and a comment; remove it";
    const std::string light = "[light]\nazimuth = 5\n";
    for (const char* text : {"x = 0.0000152\xCD\xAD", "\xCD\xAD = 1", "x = \"\" \xCD\xAD",
                             "x = 'a' \xCE\xA9", "x = \"\"\"a\"\"\"\" \xCD\xAD",
                             "x = \"\\\"\" \xCD\xAD", "x = 1\"\xCD\xAD\""})
        EXPECT_EQ(error(light + text), "a.toml:3" + stray) << text;
    for (const char* text : {"x = \"\"\"a\\\n \xCC\xAB\"\"\"", "x = \"\"\"\n\\\xCC\xAB\"\"\""})
        EXPECT_EQ(error(light + text), "a.toml:4: a character that is not ASCII follows a "
                                       "backslash; write the text in one line") << text;
    const std::string named = light + "[[material]] # \xCE\xA9\nname = ";
    for (const char* name : {"\"\xCE\xA9\"", "'\xCD\xAD'", "\"\\\" \xCE\xA9\"",
                             "\"\"\"\xCE\xA9 \"\" \n\xCE\xA9\"\"\"", "'''\xCE\xA9'''"})
        EXPECT_EQ(error("\xEF\xBB\xBF" + named + name), "no error") << name;
    EXPECT_EQ(error(light + "x = 3x['\xEF\xBB\xBD'\n"),
              "a.toml:3: this is not valid TOML: Error while parsing decimal integer: expected "
              "digit, saw 'x'");
}

TEST(SceneErrors, ATextOfManyLinesIsToldInOne) {
    EXPECT_EQ(error_of({"[light]\nkind = \"\"\"a\n\tb\"\"\"\n", {}}),
              "a.toml:2: 'kind' in [light] is the text 'a  b'; known here: directional, point, "
              "area, sectors");
}

}  // namespace
}  // namespace umbra78::tools::test
