#include "tools/cli/manual.hpp"

#include "shadow/frame/profiles.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>
#include <vector>

namespace umbra78::tools {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

// A hyphen that may be copied, no escapes, no line that roff takes for a request.
std::string roff(std::string_view text) {
    std::string made;
    for (const char c : text) {
        const bool first = made.empty() || made.back() == '\n';
        if (first && (c == '.' || c == '\'')) made += "\\&";
        if (c == '\\')
            made += "\\e";
        else if (c == '-')
            made += "\\-";
        else
            made += c;
    }
    return made;
}

std::string roff_options(const CLI::App& app, bool positional) {
    std::string text;
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional() != positional) continue;
        const std::string type = option->get_type_name();
        text += fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", roff(option->get_name(positional, true)),
                            type.empty() ? "" : " \\fI" + roff(type) + "\\fR",
                            roff(option->get_description()));
    }
    return text;
}

std::string roff_command(const CLI::App& app, const std::string& name) {
    std::string text = fmt::format(".SS {}\n{}\n{}{}", roff(name), roff(app.get_description()),
                                   roff_options(app, true), roff_options(app, false));
    if (const std::string footer = app.get_footer(); !footer.empty())
        text += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(footer));
    for (const CLI::App* below : commands_of(app))
        text += roff_command(*below, name + " " + below->get_name());
    return text;
}

// A line of a case in the script: for these words, those words.
std::string shell_case(std::string_view key, const std::vector<std::string>& words) {
    return fmt::format("    '{}') echo '{}' ;;\n", key, fmt::join(words, " "));
}

void shell_commands(const CLI::App& app, const std::string& name, std::string& cases) {
    std::vector<std::string> words;
    for (const CLI::App* below : commands_of(app)) words.push_back(below->get_name());
    for (const CLI::Option* option : app.get_options())
        for (const std::string& each : option->get_lnames()) words.push_back("--" + each);
    cases += shell_case(name, words);
    for (const CLI::App* below : commands_of(app))
        shell_commands(*below, name + " " + below->get_name(), cases);
}

// The values of settings that are choices.
std::string shell_values() {
    std::string cases;
    for (const shadow::Setting& setting : shadow::settings_table()) {
        const std::vector<std::string> names(setting.names.begin(), setting.names.end());
        if (!names.empty()) cases += shell_case(setting.key, names);
    }
    std::vector<std::string> profiles;
    for (const shadow::Profile& profile : shadow::profiles()) profiles.emplace_back(profile.name);
    return cases + shell_case("profile", profiles);
}

std::string shell_keys() {
    std::string keys = "profile=";
    for (const shadow::Setting& setting : shadow::settings_table())
        keys += fmt::format(" {}=", setting.key);
    return keys;
}

}  // namespace

std::string manual_page(const CLI::App& app) {
    std::string text = fmt::format(
        ".TH UMBRA78 1 \"\" \"umbra78 {}\" \"User Commands\"\n.SH NAME\numbra78 \\- curved shadows "
        "of 1978, bit for bit\n.SH SYNOPSIS\n.B umbra78\n\\fICOMMAND\\fR [\\fIOPTION\\fR]...\n"
        ".SH DESCRIPTION\n{}\n.SH OPTIONS\n{}.SH COMMANDS\n",
        UMBRA78_VERSION, roff(app.get_description()), roff_options(app, false));
    for (const CLI::App* command : commands_of(app))
        text += roff_command(*command, command->get_name());
    return text + ".SH EXIT STATUS\n0: done; 1: it failed, a golden or a row differs, or something "
                  "could not be printed; 2: wrong usage.\n";
}

std::string bash_completion(const CLI::App& app) {
    std::string cases;
    shell_commands(app, "umbra78", cases);
    return fmt::format(R"bash(# Completion of umbra78 for bash, written by: umbra78 --completion
_umbra78_words() {{
  case $1 in
{0}  esac
}}
_umbra78_values() {{
  case $1 in
{1}  esac
}}
_umbra78() {{
  local line=${{COMP_LINE:0:COMP_POINT}} word command=umbra78 before="" words=""
  local current=${{line##*[[:space:]]}}
  for word in ${{line%"$current"}}; do # the commands so far, and the word before
    case $word in
      umbra78 | */umbra78 | -*) ;;
      *) [ -z "$(_umbra78_words "$command $word")" ] || command="$command $word" ;;
    esac
    before=$word
  done
  case $before in
    --set | --vary)
      words="{2}"
      case $current in *=*)
        words=$(_umbra78_values "${{current%%=*}}")
        words="${{words:+${{current%%=*}}=}}${{words// / ${{current%%=*}}=}}" ;;
      esac
      compopt -o nospace 2>/dev/null ;;
    *) words=$(_umbra78_words "$command") ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$current"))
  # Readline has taken what is before the last '=' off the word already.
  [ "$before" = "--set" ] || [ "$before" = "--vary" ] || return 0
  case $COMP_WORDBREAKS in *=*)
    COMPREPLY=("${{COMPREPLY[@]#"${{current%"${{current##*=}}"}}"}}") ;;
  esac
}}
complete -o default -F _umbra78 umbra78
)bash",
                       cases, shell_values(), shell_keys());
}

}  // namespace umbra78::tools
