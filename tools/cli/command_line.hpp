// What a command takes from the command line. CLI11 reads it: its templates take ten seconds to
// compile in every file that includes them, so only command_line.cpp and main.cpp do.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace umbra78::tools {

// An option, a flag or a positional of a command; a handle.
class Argument {
public:
    explicit Argument(CLI::Option* option) : option_(option) {}

    Argument& required();
    Argument& default_shown();
    Argument& range(int min, int max);
    Argument& excludes(const Argument& other);
    // What is wrong with a value, in a sentence; "" if nothing is.
    using Check = std::string (*)(const std::string& value);
    Argument& checked(Check);

private:
    CLI::Option* option_;
};

// A command of the program, or one below it; a handle. Values must live until it has run.
class Command {
public:
    Command(CLI::App& app, const std::string& name, const std::string& meaning);
    Command(const Command& above, const std::string& name, const std::string& meaning);

    // A name with dashes is an option's, one without a positional's. `type` is for the help.
    Argument text(const std::string& name, std::string& value, const std::string& type,
                  const std::string& help);
    Argument texts(const std::string& name, std::vector<std::string>& values,
                   const std::string& type, const std::string& help);
    Argument number(const std::string& name, int& value, const std::string& type,
                    const std::string& help);
    Argument number(const std::string& name, std::uint64_t& value, const std::string& type,
                    const std::string& help);
    Argument flag(const std::string& name, bool& value, const std::string& help);

    // What most commands take.
    void scene(std::string& file);
    void set(std::vector<std::string>& overrides);
    Argument json(bool& value, const std::string& in_place_of = "text");

    void footer(const std::string& text);
    void footer(std::function<std::string()> text);
    void runs(std::function<void()> what);

    // Of a command with others below it: they may be left out, and whether one was given.
    void needs_no_command_below();
    bool has_command_below() const;

private:
    CLI::App* app_;
};

}  // namespace umbra78::tools
