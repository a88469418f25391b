// The layer over CLI11.
#include "tools/cli/command_line.hpp"

#include <CLI/CLI.hpp>

#include <utility>

namespace umbra78::tools {

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
    : app_(app.add_subcommand(name, meaning)) {}

Command::Command(const Command& above, const std::string& name, const std::string& meaning)
    : Command(*above.app_, name, meaning) {}

Argument Command::text(const std::string& name, std::string& value, const std::string& type,
                       const std::string& help) {
    return Argument(app_->add_option(name, value, help)->type_name(type));
}

// An option takes one value each time it is given, so that the scene may follow it.
Argument Command::texts(const std::string& name, std::vector<std::string>& values,
                        const std::string& type, const std::string& help) {
    const bool option = name.front() == '-';
    return Argument(app_->add_option(name, values, help)
                        ->type_name(type)
                        ->allow_extra_args(!option));
}

Argument Command::number(const std::string& name, int& value, const std::string& type,
                         const std::string& help) {
    return Argument(app_->add_option(name, value, help)->type_name(type));
}

Argument Command::number(const std::string& name, std::uint64_t& value, const std::string& type,
                         const std::string& help) {
    return Argument(app_->add_option(name, value, help)->type_name(type));
}

Argument Command::flag(const std::string& name, bool& value, const std::string& help) {
    return Argument(app_->add_flag(name, value, help));
}

void Command::scene(std::string& file) {
    text("scene", file, "FILE", "Scene file (TOML)").required();
}

void Command::set(std::vector<std::string>& overrides) {
    texts("--set", overrides, "KEY=VALUE", "key=value: a setting, observer.KEY or light.KEY");
}

Argument Command::json(bool& value, const std::string& in_place_of) {
    return flag("--json", value, "Print JSON instead of " + in_place_of);
}

void Command::footer(const std::string& text) { app_->footer(text); }

void Command::footer(std::function<std::string()> text) { app_->footer(std::move(text)); }

void Command::runs(std::function<void()> what) { app_->callback(std::move(what)); }

void Command::needs_no_command_below() { app_->require_subcommand(0, 1); }

bool Command::has_command_below() const { return !app_->get_subcommands().empty(); }

}  // namespace umbra78::tools
