#include "tools/models/ply_values.hpp"

#include "tools/models/words.hpp"

#include <fmt/format.h>

#include <charconv>

namespace umbra78::tools {
namespace {

std::string within(const PlyElement& element, std::uint64_t number) {
    return fmt::format("element {} {} of {}", shown(element.name), number, element.count);
}

class TextValues : public PlyValues {
public:
    TextValues(const PlyHeader& header, const ModelData& model, FirstError& error)
        : model_(model), words_(header.data, model.name, false, error, header.data_line) {}

    void begin(const PlyElement& element, std::uint64_t number) override {
        element_ = &element, number_ = number;
        if (!words_.done() && words_.peek().line == line_)
            words_.report(line_, fmt::format("{} does not begin a line; the lines do not hold what "
                                             "the header's properties say: correct one of them",
                                             within(element, number)));
        line_ = words_.peek().line;
    }
    int line() const override { return line_; }

    std::int64_t coordinate(Scalar) override {
        return read_coordinate(take(), model_.name, words_.error());
    }
    std::int64_t whole(Scalar) override {
        const ModelWord word = take();
        std::int64_t value = 0;
        const char *begin = word.text.data(), *end = begin + word.text.size();
        const auto [stop, status] = std::from_chars(begin, end, value);
        if (stop == end && status == std::errc{}) return value;
        words_.report(word.line, shown(word.text) + " is no whole number that fits; correct it");
        return 0;
    }
    void skip(Scalar, std::uint64_t count) override {
        for (; count > 0 && !words_.error().any(); --count) take();
    }
    void end() override {
        if (!words_.done())
            words_.report(words_.peek().line,
                          fmt::format("{} follows the last element; correct the counts of the "
                                      "header, or remove it", shown(words_.peek().text)));
    }
    void report(const std::string& what) override { words_.report(line_, what); }

private:
    ModelWord take() {
        if (words_.done()) words_.report_end(within(*element_, number_));
        const ModelWord word = words_.take();
        line_ = word.line;
        return word;
    }

    const ModelData& model_;
    ModelWords words_;
    const PlyElement* element_ = nullptr;
    std::uint64_t number_ = 0;
    int line_ = 0;  // of the word that was taken last
};

class BinaryValues : public PlyValues {
public:
    BinaryValues(const PlyHeader& header, ModelData& model, FirstError& error)
        : model_(model), error_(error), rest_(header.data),
          big_(header.format == PlyFormat::big_endian) {}

    void begin(const PlyElement& element, std::uint64_t number) override {
        element_ = &element, number_ = number;
        model_.counted = element.name == "vertex" ? "vertex" : "face";
    }
    int line() const override { return static_cast<int>(number_); }

    std::int64_t coordinate(Scalar type) override {
        const std::uint64_t bits = take(type);
        return error_.any() ? 0 : read_coordinate(bits, type, model_, line(), error_);
    }
    std::int64_t whole(Scalar type) override { return whole_of(take(type), type); }
    void skip(Scalar type, std::uint64_t count) override {
        if (count > rest_.size() / type.bytes) report_end();
        else rest_.remove_prefix(count * type.bytes);
    }
    void end() override {
        if (!rest_.empty())
            error_.report(fmt::format("{}: {} bytes follow the last element; correct the counts of "
                                      "the header, or remove them", model_.name, rest_.size()));
    }
    void report(const std::string& what) override {
        error_.report(fmt::format("{}: {}: {}", model_.name, within(*element_, number_), what));
    }

private:
    std::uint64_t take(Scalar type) {
        if (rest_.size() < type.bytes) {
            report_end();
            return 0;
        }
        const std::uint64_t bits = bits_of(rest_.substr(0, type.bytes), big_);
        rest_.remove_prefix(type.bytes);
        return bits;
    }
    void report_end() {
        report("the file ends in it; add the rest, or correct the counts of the header");
    }

    ModelData& model_;
    FirstError& error_;
    std::string_view rest_;
    bool big_;
    const PlyElement* element_ = nullptr;
    std::uint64_t number_ = 0;
};

}  // namespace

std::unique_ptr<PlyValues> ply_values(const PlyHeader& header, ModelData& model,
                                      FirstError& error) {
    if (header.format == PlyFormat::ascii)
        return std::make_unique<TextValues>(header, model, error);
    return std::make_unique<BinaryValues>(header, model, error);
}

}  // namespace umbra78::tools
