#include "tools/models/patch_files.hpp"

#include "tools/models/words.hpp"

#include <fmt/format.h>

namespace umbra78::tools {
namespace {

// Far more than a frame can draw; it keeps an index in an int.
constexpr int most_patches = 1 << 20;

void refuse_rest(ModelWords& words, const std::string& after) {
    if (!words.done())
        words.report(words.peek().line,
                     fmt::format("{} follows {}; correct the count, or remove it",
                                 shown(words.peek().text), after));
}

ModelPatch read_points(ModelWords& words, const std::string& within) {
    ModelPatch patch;
    for (ModelPoint& point : patch) point = words.point(within);
    return patch;
}

void check_orders(ModelWords& words, int number) {
    for (int k = 0; k < 2 && !words.error().any(); ++k) {
        const int line = words.peek().line;
        const int order = words.count(fmt::format("the order of patch {}", number), 0, 1000);
        if (order != 3)
            words.report(line, fmt::format("patch {} has order {}; only bicubic patches, of order "
                                           "3 3, have an exact form here", number, order));
    }
}

// What a Geomview header means: degrees of u and v, numbers a point, and numbers that follow the
// points of a patch.
struct BezHeader {
    char u = '3', v = '3', dimension = '3';
    int skipped = 0;
    bool known = false;
};

BezHeader parse_header(std::string_view word) {
    BezHeader header;
    const auto drop = [&](std::string_view prefix) {
        const bool there = word.starts_with(prefix);
        if (there) word.remove_prefix(prefix.size());
        return there;
    };
    constexpr int colours = 4 * 4, texture = 4 * 2;
    if (drop("ST")) header.skipped += texture;
    if (drop("C")) header.skipped += colours;
    if (drop("BBP")) {
        header.known = word.empty();
        return header;
    }
    if (!drop("BEZ") || word.size() < 3) return header;
    header.u = word[0], header.v = word[1], header.dimension = word[2];
    word.remove_prefix(3);
    if (drop("_ST")) header.skipped += texture;
    header.known = word.empty();
    return header;
}

BezHeader read_header(ModelWords& words) {
    const ModelWord word = words.take();
    const BezHeader header = parse_header(word.text);
    const std::string title = shown(word.text);
    if (!header.known)
        words.report(word.line, title + " begins no Geomview Bezier file; begin it with BBP or "
                                        "BEZ333");
    else if (header.dimension == '4')
        words.report(word.line, title + " is rational: its points have weights, by which the "
                                        "machine would have to divide; write BEZ333");
    else if (header.u != '3' || header.v != '3' || header.dimension != '3')
        words.report(word.line, title + " is not bicubic: only patches of degree 3 by 3 have an "
                                        "exact form here; write BEZ333");
    else if (words.peek().text == "BINARY")
        words.report(words.peek().line, "the file is binary; write it as text");
    return header;
}

}  // namespace

void read_bpt(std::string_view text, ModelData& model, FirstError& error) {
    ModelWords words(text, model.name, false, error);
    const int patches = words.count("the number of patches", 1, most_patches);
    for (int k = 1; k <= patches && !error.any(); ++k) {
        check_orders(words, k);
        model.patches.push_back(read_points(words, fmt::format("patch {} of {}", k, patches)));
    }
    refuse_rest(words, fmt::format("patch {0} of {0}", patches));
}

void read_bez(std::string_view text, ModelData& model, FirstError& error) {
    ModelWords words(text, model.name, false, error);
    if (words.done()) return;
    const BezHeader header = read_header(words);
    if (words.done()) words.report_end("its header");
    for (int k = 1; !words.done(); ++k) {
        const std::string within = fmt::format("patch {}", k);
        model.patches.push_back(read_points(words, within));
        for (int skipped = 0; skipped < header.skipped && !error.any(); ++skipped) {
            if (words.done()) words.report_end(within);
            else read_coordinate(words.take(), model.name, error);
        }
    }
}

void read_tea(std::string_view text, ModelData& model, FirstError& error) {
    ModelWords words(text, model.name, true, error);
    const int patches = words.count("the number of patches", 1, most_patches);
    std::vector<std::array<ModelWord, 16>> numbers;
    for (int k = 1; k <= patches && !error.any(); ++k) {
        numbers.emplace_back();
        for (ModelWord& word : numbers.back()) {
            if (words.done())
                words.report_end(fmt::format("the list of patch {} of {}", k, patches));
            word = words.take();
        }
    }
    const int vertices = words.count("the number of vertices", 1, 16 * most_patches);
    std::vector<ModelPoint> points;
    for (int k = 1; k <= vertices && !error.any(); ++k)
        points.push_back(words.point(fmt::format("vertex {} of {}", k, vertices)));
    refuse_rest(words, fmt::format("vertex {0} of {0}", vertices));
    for (std::size_t k = 0; k < numbers.size() && !error.any(); ++k) {
        model.patches.emplace_back();
        const std::string called = fmt::format("a vertex number of patch {}", k + 1);
        for (std::size_t i = 0; i < 16 && !error.any(); ++i)
            model.patches.back()[i] = points[static_cast<std::size_t>(
                read_whole(numbers[k][i], called, 1, vertices, model.name, error) - 1)];
    }
}

}  // namespace umbra78::tools
