// umbra78 shadow: the shadow test on depth buffers that another program has drawn.
#include "tools/captured/matrix_text.hpp"
#include "tools/captured/report.hpp"
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/cli/two_numbers.hpp"
#include "tools/io/buffer_files.hpp"
#include "tools/io/console.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/scene/scene_error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace umbra78::tools {
namespace {

struct Options {
    std::string observer, light, matrix, truth, out, error, spectrum, buffers, pixel, size,
        light_size;
    std::string format = "d32f", convention = "d3d", vectors = "column", rows, z_range, y;
    std::vector<std::string> set;
    bool json = false, least_bias = false, truth_bright = false;
};

std::string check_size(const std::string& text) {
    if (two_numbers(text, 'x')) return "";
    return fmt::format("'{}' is not a size; write WIDTHxHEIGHT as in 1280x720", text);
}
std::string check_format(const std::string& text) {
    if (captured::find_depth_format(text)) return "";
    return fmt::format("'{}' is no depth format; give one of {}", text,
                       captured::names_of_depth_formats());
}
std::string check_convention(const std::string& text) {
    if (captured::find_convention(text)) return "";
    return fmt::format("'{}' is no convention; give d3d, vulkan or opengl", text);
}

// Whether an option says the first of two words; nothing where it is not given.
std::optional<bool> says(const char* option, const std::string& text, const std::string& yes,
                         const std::string& no) {
    if (text.empty()) return {};
    if (text == yes) return true;
    if (text == no) return false;
    throw SceneError(fmt::format("{} '{}': give {} or {}", option, text, yes, no));
}

captured::Convention convention_of(const Options& o) {
    captured::Convention c = *captured::find_convention(o.convention);
    c.row_vectors = *says("--vectors", o.vectors, "row", "column");
    c.first_row_on_top = says("--rows", o.rows, "top", "bottom").value_or(c.first_row_on_top);
    c.y_up = says("--y", o.y, "up", "down").value_or(c.y_up);
    c.z_from_minus_one = says("--z-range", o.z_range, "-1..1", "0..1").value_or(c.z_from_minus_one);
    return c;
}

// What the raw numbers of a file are, where its size is given.
std::optional<RawNumbers> raw_of(const std::string& size, NumberKind kind) {
    if (size.empty()) return {};
    const auto [width, height] = *two_numbers(size, 'x');
    return RawNumbers{width, height, kind};
}

NumberKind kind_of(const captured::DepthFormat& format) {
    return format.real ? NumberKind::f32
                       : format.unorm_bits > 16 ? NumberKind::u32 : NumberKind::u16;
}

captured::Capture capture_of(const Options& o) {
    captured::Capture capture;
    capture.format = *captured::find_depth_format(o.format);
    capture.convention = convention_of(o);
    const NumberKind kind = kind_of(capture.format);
    const std::string& light_size = o.light_size.empty() ? o.size : o.light_size;
    capture.observer = read_numbers(o.observer, raw_of(o.size, kind));
    capture.light = read_numbers(o.light, raw_of(light_size, kind));
    capture.matrix = captured::read_matrix(o.matrix);
    capture.matrix_name = std::filesystem::exists(o.matrix) ? o.matrix : "--matrix";
    capture.set = o.set;
    return capture;
}

captured::Asked asked_of(const Options& o, const captured::Capture& capture,
                         const hw::MachineSpec& spec) {
    captured::Asked asked;
    asked.least_bias = o.least_bias;
    if (!o.pixel.empty()) {
        const auto [x, y] = *two_numbers(o.pixel, ',');
        asked.pixel = Pixel{x, y};
    }
    if (o.truth.empty()) return asked;
    const NumberImage truth = read_numbers(o.truth, raw_of(o.size, NumberKind::u8));
    if (truth.width != capture.observer.width || truth.height != capture.observer.height)
        throw SceneError(fmt::format("{}: it has {} x {} numbers, and the observer's buffer {} x "
                                     "{}; give a mask of that size", truth.name, truth.width,
                                     truth.height, capture.observer.width,
                                     capture.observer.height));
    asked.truth = captured::darkness_of(truth, o.truth_bright,
                                        capture.convention.first_row_on_top, spec);
    return asked;
}

void write_files(const Options& o, const captured::Answer& a) {
    FileSet files;
    const captured::Sides sides = a.frame.observer_sides();
    if (!o.buffers.empty()) files.make_folder(o.buffers);
    if (!o.out.empty())
        write_png_gray(o.out, sides.width, sides.height, captured::mask_picture(a), &files);
    if (!o.error.empty())
        write_png_rgb(o.error, sides.width, sides.height, captured::error_picture(a), &files);
    if (!o.spectrum.empty()) {
        if (!a.judged.window)
            throw SceneError("--spectrum: no square of lit pixels has enough errors for one; "
                             "leave it out, or give less bias");
        const captured::Window& w = *a.judged.window;
        write_png_gray(o.spectrum, w.side, w.side, study::spectrum_picture(w.power, w.side),
                       &files);
    }
    if (!o.buffers.empty())
        for (const Buffer& buffer :
             {a.frame.buffer("observer_z", a.frame.observer()),
              a.frame.buffer("light_z", a.frame.light()),
              a.frame.buffer("mask", std::span<const std::uint8_t>(a.mask))}) {
            write_pgm(Path(o.buffers) / (buffer.name + ".pgm"), buffer, &files);
            write_npy(Path(o.buffers) / (buffer.name + ".npy"), buffer, &files);
        }
    files.commit();
}

void run(const Options& o) {
    const captured::Capture capture = capture_of(o);
    const captured::CapturedFrame frame(capture);
    const captured::Answer answer(capture, frame, asked_of(o, capture, frame.spec()));
    for (const std::string& warning : answer.warnings) print_error("warning: " + warning);
    write_files(o, answer);
    fmt::print("{}", o.json ? print(captured::to_json(answer)) : captured::print(answer));
}

constexpr const char* conventions_help =
    "What the matrix M is: (x, y, z, 1), a pixel's centre in the observer's normalized device\n"
    "coordinates with the depth that is stored there, becomes M (x, y, z, 1), the light's clip\n"
    "coordinates; their quotients by w are the place in the light's buffer. So M is the light's\n"
    "view-projection times the inverse of the observer's. x is -1 at the left edge and 1 at the\n"
    "right one.\n"
    "  --convention d3d     y is 1 at the top, z is 0..1 as stored, a file's first row is the top\n"
    "                       one; also for Metal and WebGPU\n"
    "               vulkan  the same, but y is -1 at the top\n"
    "               opengl  y is 1 at the top, z is -1..1 and stored as (z + 1)/2, a file's first\n"
    "                       row is the bottom one, as glReadPixels has it\n"
    "  --vectors column     the 16 numbers are rows of M, row by row\n"
    "            row        they are rows of the matrix that stands behind a row vector,\n"
    "                       p' = p M: Direct3D's textbooks, or OpenGL's memory\n"
    "Of a reversed format z is the stored depth, 1 near. A PFM's rows are brought from the top\n"
    "first, and --rows speaks of them then.\n"
    "\nWhat is rounded: a depth to a code of z_bits, half up and exactly (none of d16 and d24 at\n"
    "their own 16 and 24 bits; a float, at 26 bits and depth_store = float, keeps its 24 where it\n"
    "is 1/4 or more); M to coefficient_bits, half to even; a pixel's X and Y in the light to\n"
    "fraction_bits, its Z to a code. What the buffer was cleared to, the far plane, is\n"
    "background. z_bits, depth_store and xy_bits follow from the files; the bias is 0 and\n"
    "coefficient_bits 24 unless --set says otherwise.\n";

void add_options(Command& command, Options& o) {
    command.input("--observer-depth", o.observer, "FILE",
                  "The depth that the observer's picture was drawn with: PGM, NPY, PFM, or raw "
                  "numbers, low byte first, with --size")
        .required();
    command.input("--light-depth", o.light, "FILE", "The light's depth map").required();
    command.text("--matrix", o.matrix, "M",
                 "From the observer's device coordinates to the light's clip coordinates: 16 "
                 "numbers on the line, or a text file or an NPY that has them")
        .required();
    command.text("--depth-format", o.format, "FORMAT", captured::names_of_depth_formats())
        .checked(check_format)
        .default_shown();
    command.text("--convention", o.convention, "NAME", "d3d, vulkan or opengl: see below")
        .checked(check_convention)
        .default_shown();
    command.text("--vectors", o.vectors, "KIND", "column or row: see below").default_shown();
    command.text("--rows", o.rows, "FIRST", "top or bottom, in place of the convention's");
    command.text("--y", o.y, "UP", "up or down, in place of the convention's");
    command.text("--z-range", o.z_range, "RANGE", "0..1 or -1..1, in place of the convention's");
    command.text("--size", o.size, "WIDTHxHEIGHT", "Of raw numbers").checked(check_size);
    command.text("--light-size", o.light_size, "WIDTHxHEIGHT",
                 "Of the light's raw numbers, if it differs")
        .checked(check_size);
    command.input("--truth", o.truth, "FILE",
                  "The right mask, 255 (or 1) in shadow; without it false shadow is estimated");
    command.flag("--truth-bright", o.truth_bright, "Bright is lit in that mask");
}

}  // namespace

void add_shadow_command(CLI::App& app, int&) {
    const auto options = std::make_shared<Options>();
    Command command(app, "shadow", "Run the shadow test on depth buffers captured elsewhere");
    add_options(command, *options);
    command.text("--pixel", options->pixel, "X,Y", "Also print every word of that pixel's way")
        .checked(check_pixel);
    command.flag("--least-bias", options->least_bias,
                 "Also search the least constant bias with less than 0.1 % false shadow, away from "
                 "edges");
    command.output("--out", options->out, ".png", "The mask as a picture: black is lit");
    command.output("--error", options->error, ".png",
                   "Where it is wrong: red false shadow, blue false light");
    command.output("--spectrum", options->spectrum, ".png",
                   "The spectrum of the false shadow, where there is most of it");
    command.output_folder("--buffers", options->buffers,
                          "Folder for the depths in the machine's words and the mask, as PGM and "
                          "NPY");
    command.set(options->set);
    command.json(options->json);
    command.footer(std::string(conventions_help) +
                   "\nExample:\n  umbra78 shadow --observer-depth eye.npy --light-depth map.npy "
                   "--matrix m.txt --depth-format d16 --least-bias --error error.png");
    command.runs([options] { run(*options); });
}

}  // namespace umbra78::tools
