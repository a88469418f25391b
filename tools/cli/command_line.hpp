// The options, flags and positionals of a command, as a thin layer over CLI11.
//
// CLI11's templates take ten seconds to compile in every file that includes them, so only
// command_line.cpp and main.cpp do.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace umbra78::tools {

// A handle of an option, a flag or a positional of a command.
class Argument {
public:
    explicit Argument(CLI::Option* option) : option_(option) {}

    Argument& required();
    Argument& default_shown();
    Argument& range(int min, int max);
    Argument& excludes(const Argument& other);
    // Returns what is wrong with a value, in a sentence, or "".
    using Check = std::string (*)(const std::string& value);
    Argument& checked(Check);

private:
    CLI::Option* option_;
};

// A handle of a command of the program, or of a command below another (umbra78 study merge). The
// variables that values are written to must live until the command has run.
class Command {
public:
    Command(CLI::App& app, const std::string& name, const std::string& meaning);
    Command(const Command& above, const std::string& name, const std::string& meaning);

    // "--name" makes an option, "name" a positional. `type` is printed in the help.
    Argument text(const std::string& name, std::string& value, const std::string& type,
                  const std::string& help);
    Argument texts(const std::string& name, std::vector<std::string>& values,
                   const std::string& type, const std::string& help);
    Argument number(const std::string& name, int& value, const std::string& type,
                    const std::string& help);
    Argument number(const std::string& name, std::uint64_t& value, const std::string& type,
                    const std::string& help);
    Argument flag(const std::string& name, bool& value, const std::string& help);

    // Texts that are paths. Before the command runs, they are all tried: no output is an input, has
    // the ending of another format (`ending` is ".png"), or is without its folder, unless that is
    // in an output folder of the command. Where an output is "-", standard output takes the file,
    // and what is printed goes to standard error.
    Argument input(const std::string& name, std::string& value, const std::string& type,
                   const std::string& help);
    Argument inputs(const std::string& name, std::vector<std::string>& values,
                    const std::string& type, const std::string& help);
    Argument output(const std::string& name, std::string& value, std::string_view ending,
                    const std::string& help);
    Argument output_folder(const std::string& name, std::string& value, const std::string& help);

    // Arguments that most commands have.
    void scene(std::string& file);
    void set(std::vector<std::string>& overrides);
    void threads(int& value);
    Argument json(bool& value, const std::string& in_place_of = "text");

    void footer(const std::string& text);
    void footer(std::function<std::string()> text);
    void runs(std::function<void()> what);

    // For a command with others below it: makes these optional, and returns whether one was given.
    void needs_no_command_below();
    bool has_command_below() const;

private:
    struct Paths;
    CLI::App* app_;
    std::shared_ptr<Paths> paths_;
};

}  // namespace umbra78::tools
