// Malformed scene files and --set values: views and settings.
#include "tests/tools/scene/malformed.hpp"

namespace umbra78::tools::test {
namespace {

TEST(ViewErrors, Views) {
    expect_messages({
        {ball + "[light]\nelevation = 1\n",
         "a.toml:4: [light] has no 'azimuth'; add azimuth = -100"},
        {ball + "[light]\nazimuth = 361\n",
         "a.toml:5: 'azimuth' in [light] is 361; its range is -360 .. 360"},
        {ball + "[light]\nazimuth = 0\nelevation = -90.5\n",
         "a.toml:6: 'elevation' in [light] is -90.5; its range is -90 .. 90"},
        {ball + "[light]\nkind = \"spot\"\n",
         "a.toml:5: 'kind' in [light] is the text 'spot'; known here: directional, point, area, "
         "sectors"},
        {ball + "[light]\nkind = \"directonal\"\n",
         "a.toml:5: 'kind' in [light] is the text 'directonal'; did you mean 'directional'?"},
        {ball + "[light]\nkind = \"point\"\n",
         "a.toml:4: [light] has no 'position'; add position = [-4, 6, 5]"},
        {ball + "[light]\nkind = \"point\"\nposition = [0, 0, 0]\n",
         "a.toml:6: 'position' in [light] is its target, the middle of the scene; move one "
         "of them"},
        {ball + "[light]\nkind = \"point\"\nposition = [1, 1, 1]\ntarget = [1, 1, 1]\n",
         "a.toml:6: 'position' in [light] is its target, as given; move one of them"},
        {ball + "[light]\nkind = \"point\"\nposition = [32767, 32767, 0]\n",
         "a.toml:6: 'position' in [light] is farther than 32767 from its target; use kind = "
         "\"directional\""},
        {ball + "[light]\nkind = \"point\"\nposition = [1, 1, 1]\nazimuth = 3\n",
         "a.toml:7: 'azimuth' in [light] needs kind = \"directional\""},
        {ball_and_light + "position = [1, 1, 1]\n",
         "a.toml:6: 'position' in [light] needs kind = \"point\""},
        {ball_and_light + "extent = 0\n",
         "a.toml:6: 'extent' in [light] is 0; its range is 2^-16 .. 32767"},
        {ball_and_light + "extent = -2\n",
         "a.toml:6: 'extent' in [light] is -2; its range is 2^-16 .. 32767"},
        {ball_and_light + "extent = 1e-9\n",
         "a.toml:6: 'extent' in [light] is 1e-9; its range is 2^-16 .. 32767"},
        {ball_and_light + "near = 2\nfar = 1\n",
         "a.toml:7: 'near' in [light] is not less than 'far'; exchange them, or leave both "
         "out to fit them to the scene"},
        {ball_and_light + "near = 3\n",
         "a.toml:6: 'near' in [light] is not less than 'far'; give both, or neither to fit "
         "them to the scene"},
        {ball_and_light + "[observer]\nprojection = \"perspective\"\n",
         "a.toml:6: [observer] has no 'distance'; add distance = 8"},
        {ball_and_light + "[observer]\nprojection = \"perspective\"\ndistance = 5\nnear = 0\n",
         "a.toml:9: 'near' in [observer] is 0; its range is 2^-16 .. 131068"},
        {ball_and_light + "[observer]\ndistance = 5\n",
         "a.toml:7: 'distance' in [observer] needs projection = \"perspective\""},
        {ball_and_light + "[observer]\nprojection = 2\n",
         "a.toml:7: 'projection' in [observer] is the number 2; known here: orthographic, "
         "perspective"},
    });
}

TEST(ViewErrors, Settings) {
    expect_messages({
        {ball_and_light + "[settings]\nbais = 3\n",
         "a.toml:7: unknown key 'bais' in [settings]; did you mean 'bias'?"},
        {ball_and_light + "[settings]\nxy_bits = 13\n",
         "a.toml:7: 'xy_bits' in [settings] is 13; its range is 4 .. 12"},
        {ball_and_light + "[settings]\nxy_bits = 9.0\n",
         "a.toml:7: 'xy_bits' in [settings] is the number 9.0; write a whole number"},
        {ball_and_light + "[settings]\nmultipliers = 3\n",
         "a.toml:7: 'multipliers' in [settings] is 3, which the machine cannot be built "
         "with (16 x 16 multipliers in the unit: 1, 4 or 16)"},
        {ball_and_light + "[settings]\nlookup = \"nearst\"\n",
         "a.toml:7: 'lookup' in [settings] is the text 'nearst'; did you mean 'nearest'?"},
        {ball_and_light + "[settings]\nlookup = 1\n",
         "a.toml:7: 'lookup' in [settings] is the number 1; known here: nearest, bilinear, "
         "percentage, filtered_depth"},
        {ball_and_light + "[settings]\nambient = 1.5\n",
         "a.toml:7: 'ambient' in [settings] is 1.5; its range is 0 .. 1"},
        {ball_and_light + "[settings]\ndither_seed = 0\n",
         "a.toml:7: 'dither_seed' in [settings] is 0; its range is 1 .. 2147483647"},
        {ball_and_light + "[settings]\nprofile = \"affine\"\n",
         "a.toml:7: 'profile' in [settings] is the text 'affine'; did you mean 'affine16'?"},
        {ball_and_light + "[settings]\nbias = 1e8\n",
         "a.toml:7: 'bias' in [settings] is 1e8; its range is -16777216 .. 16777216"},
        {"settings = 3\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n[light]\nazimuth = -100\n",
         "a.toml:1: [settings] is the number 3; write [settings] and its keys below it"},
    });
}

TEST(ViewErrors, WhatDoesNotFitTheMachine) {
    expect_messages({
        {ball + "[light]\nkind = \"point\"\nposition = [0, 0, 20000]\nextent = 2e-5\n",
         "a.toml: the light's matrix does not fit the machine's words; bring its extent "
         "nearer the scene's size"},
        {ball_and_light + "[observer]\nprojection = \"perspective\"\ndistance = 20000\n"
         "extent = 2e-5\n",
         "a.toml: the observer's matrix does not fit the machine's words; bring its extent "
         "nearer the scene's size"},
        {ball_and_light + "near = -0.001\nfar = 0.001\n[settings]\nbias = 16000000\n"
         "bias_unit = \"world\"\n",
         "a.toml: the bias is beyond 2^47 quanta; lower it"},
    });
}

TEST(ViewErrors, SetOverrides) {
    expect_messages({
        {ball_and_light,
         "--set bias: write key=value, such as --set bias=64",
         {"bias"}},
        {ball_and_light,
         "--set =3: write key=value, such as --set bias=64",
         {"=3"}},
        {ball_and_light,
         "--set bias=: write key=value, such as --set bias=64",
         {"bias="}},
        {ball_and_light,
         "--set bais=3: unknown key 'bais' in [settings]; did you mean 'bias'?",
         {"bais=3"}},
        {ball_and_light,
         "--set bias=much: 'bias' in [settings] is the text 'much'; write a number",
         {"bias=much"}},
        {ball_and_light,
         "--set xy_bits=3: 'xy_bits' in [settings] is 3; its range is 4 .. 12",
         {"xy_bits=3"}},
        {ball_and_light,
         "--set lookup=cubic: 'lookup' in [settings] is the text 'cubic'; known here: "
         "nearest, bilinear, percentage, filtered_depth",
         {"lookup=cubic"}},
        {ball_and_light + "[settings]\nform = \"correct\"\nlookup = \"percentage\"\n",
         "a.toml:8: 'lookup' in [settings] is percentage, which the machine cannot be "
         "built with (form = correct with arithmetic = fixed has lookup = nearest, bilinear, "
         "filtered_depth)"},
        {ball_and_light + "[settings]\nlookup = \"filtered_depth\"\n",
         "--set arithmetic=ap120b: 'arithmetic' in [settings] is ap120b, which the "
         "machine cannot be built with (form = post_process with arithmetic = ap120b has lookup = "
         "nearest, bilinear)",
         {"arithmetic=ap120b"}},
        {ball_and_light + "[settings]\nlookup = \"percentage\"\n",
         "--set receiver=plane: 'receiver' in [settings] is plane, which the machine cannot be "
         "built with (lookup = percentage with arithmetic = fixed has receiver = point or normal)",
         {"receiver=plane"}},
        {ball_and_light + "[settings]\nform = \"correct\"\n",
         "--set receiver=normal: 'receiver' in [settings] is normal, which the machine cannot be "
         "built with (form = correct with arithmetic = fixed has receiver = point alone)",
         {"receiver=normal"}},
        {ball_and_light + "[settings]\nreceiver = \"normal\"\n",
         "--set arithmetic=ap120b: 'arithmetic' in [settings] is ap120b, which the machine cannot "
         "be built with (form = post_process with arithmetic = ap120b has receiver = point alone)",
         {"arithmetic=ap120b"}},
        {ball_and_light + "[settings]\ntaps = 6\n",
         "a.toml:7: 'taps' in [settings] is 6; its range is 2 .. 5"},
        {ball_and_light,
         "--set lamp.azimuth=3: unknown key 'lamp.azimuth'; set a setting, observer.KEY or "
         "light.KEY",
         {"lamp.azimuth=3"}},
        {ball_and_light,
         "--set light.azimut=3: unknown key 'azimut' in [light]; did you mean 'azimuth'?",
         {"light.azimut=3"}},
        {ball_and_light,
         "--set light.azimuth=400: 'azimuth' in [light] is 400; its range is -360 .. 360",
         {"light.azimuth=400"}},
        {ball_and_light,
         "--set light.target=[0, 1: the value is not valid TOML; write [x, y, z], a number or a "
         "name",
         {"light.target=[0, 1"}},
        {ball_and_light,
         "--set observer.target=[0, 1]: 'target' in [observer] is an array of 2; write [x, "
         "y, z]",
         {"observer.target=[0, 1]"}},
        {ball_and_light,
         "--set observer.distance=3: 'distance' in [observer] needs projection = "
         "\"perspective\"",
         {"observer.distance=3"}},
        {ball_and_light,
         "a.toml:4: [light] has no 'position'; add position = [-4, 6, 5]",
         {"light.kind=point"}},
        {ball_and_light,
         "--set light.near=5: 'near' in [light] is not less than 'far'; give both, or "
         "neither to fit them to the scene",
         {"light.near=5"}},
    });
}

}  // namespace
}  // namespace umbra78::tools::test
