// The layer over CLI11.
#include "tools/cli/command_line.hpp"

#include "tools/io/destination.hpp"
#include "tools/io/console.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <stdexcept>
#include <utility>

namespace umbra78::tools {
namespace {

std::string refuse_empty(std::string& value) {
    return value.empty() ? "it is empty; give a value, or leave it out" : "";
}

// CLI11 reads "010" as eight and cuts numbers that do not fit; here a number is decimal and fits.
template <class Number>
std::string refuse_no_number(std::string& value) {
    Number number{};
    const char* const end = value.data() + value.size();
    const auto [at, error] = std::from_chars(value.data(), end, number);
    const bool fits = error == std::errc() && at == end;
    if (fits && fmt::format("{}", number) == value) return "";
    return fmt::format("'{}' is not a whole number{}", value,
                       error == std::errc::result_out_of_range
                           ? fmt::format(" up to {}", std::numeric_limits<Number>::max())
                           : ", written in decimal digits without leading zeros");
}

}  // namespace

// Where the values of a command's paths will be when it runs.
struct Command::Paths {
    struct Output {
        const std::string* value;
        std::string ending;
    };
    std::vector<const std::string*> inputs, folders;
    std::vector<const std::vector<std::string>*> more_inputs;
    std::vector<Output> outputs;

    void check() const {
        for (const std::string* input : inputs) note_input(*input);
        for (const auto* list : more_inputs)
            for (const std::string& input : *list) note_input(input);
        std::vector<std::string> made;
        for (const std::string* folder : folders) {
            if (*folder == "-")
                throw std::runtime_error("cannot make the folder '-': standard output is no "
                                         "folder; name one, or ./- for a folder of this name");
            if (!folder->empty()) check_folder(*folder);  // empty: not given
            made.push_back(*folder);
        }
        bool taken = false;
        for (const Output& output : outputs) {
            if (output.value->empty()) continue;  // not given
            if (check_output(*output.value, output.ending, made) !=
                Destination::Kind::standard_output)
                continue;
            if (std::exchange(taken, true))
                throw std::runtime_error("standard output takes one file; name the others");
        }
        if (taken) take_standard_output();
    }
};

Argument& Argument::required() {
    option_->required();
    return *this;
}

Argument& Argument::default_shown() {
    option_->capture_default_str();
    return *this;
}

Argument& Argument::range(int min, int max) {
    option_->check(CLI::Range(min, max));
    return *this;
}

Argument& Argument::excludes(const Argument& other) {
    option_->excludes(other.option_);
    return *this;
}

Argument& Argument::checked(Check check) {
    option_->check(CLI::Validator([check](std::string& value) { return check(value); }, ""));
    return *this;
}

Command::Command(CLI::App& app, const std::string& name, const std::string& meaning)
    : app_(app.add_subcommand(name, meaning)), paths_(std::make_shared<Paths>()) {}

Command::Command(const Command& above, const std::string& name, const std::string& meaning)
    : Command(*above.app_, name, meaning) {}

Argument Command::text(const std::string& name, std::string& value, const std::string& type,
                       const std::string& help) {
    return Argument(app_->add_option(name, value, help)->type_name(type)->check(
        CLI::Validator(refuse_empty, "")));
}

// An option takes one value each time it is given, so that the scene may follow it.
Argument Command::texts(const std::string& name, std::vector<std::string>& values,
                        const std::string& type, const std::string& help) {
    const bool option = name.front() == '-';
    return Argument(app_->add_option(name, values, help)
                        ->type_name(type)
                        ->allow_extra_args(!option)
                        ->check(CLI::Validator(refuse_empty, "")));
}

Argument Command::number(const std::string& name, int& value, const std::string& type,
                         const std::string& help) {
    return Argument(app_->add_option(name, value, help)->type_name(type)->check(
        CLI::Validator(refuse_no_number<int>, "")));
}

Argument Command::number(const std::string& name, std::uint64_t& value, const std::string& type,
                         const std::string& help) {
    return Argument(app_->add_option(name, value, help)->type_name(type)->check(
        CLI::Validator(refuse_no_number<std::uint64_t>, "")));
}

Argument Command::flag(const std::string& name, bool& value, const std::string& help) {
    return Argument(app_->add_flag(name, value, help));
}

Argument Command::input(const std::string& name, std::string& value, const std::string& type,
                        const std::string& help) {
    paths_->inputs.push_back(&value);
    return text(name, value, type, help);
}

Argument Command::inputs(const std::string& name, std::vector<std::string>& values,
                         const std::string& type, const std::string& help) {
    paths_->more_inputs.push_back(&values);
    return texts(name, values, type, help);
}

Argument Command::output(const std::string& name, std::string& value, std::string_view ending,
                         const std::string& help) {
    paths_->outputs.push_back({&value, std::string(ending)});
    return text(name, value, "FILE", help + "; - is standard output");
}

Argument Command::output_folder(const std::string& name, std::string& value,
                                const std::string& help) {
    paths_->folders.push_back(&value);
    return text(name, value, name.front() == '-' ? "DIR" : "OUT", help);
}

void Command::scene(std::string& file) {
    input("scene", file, "FILE", "Scene file (TOML)").required();
}

void Command::set(std::vector<std::string>& overrides) {
    texts("--set", overrides, "KEY=VALUE", "key=value: a setting, observer.KEY or light.KEY");
}

Argument Command::json(bool& value, const std::string& in_place_of) {
    return flag("--json", value, "Print JSON instead of " + in_place_of);
}

void Command::threads(int& value) {
    number("--threads", value, "N",
           "Threads that draw a frame, 1 to 64; 0: one for each processor. The frame is the same "
           "with any number, to the bit")
        .range(0, 64)
        .default_shown();
}

void Command::footer(const std::string& text) { app_->footer(text); }

void Command::footer(std::function<std::string()> text) { app_->footer(std::move(text)); }

void Command::runs(std::function<void()> what) {
    app_->callback([paths = paths_, what = std::move(what)] {
        paths->check();
        what();
    });
}

void Command::needs_no_command_below() { app_->require_subcommand(0, 1); }

bool Command::has_command_below() const { return !app_->get_subcommands().empty(); }

}  // namespace umbra78::tools
