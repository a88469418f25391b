// umbra78: the program. It reads the command line, runs one command and returns its exit code.
//
// Exit code 0: done; 1: it failed, a golden or a row differs, or something that is to be printed
// could not be; 2: wrong usage. An error is one line on standard error, whatever a file or an
// argument contained.
#include "fixed/trap.hpp"
#include "tools/cli/commands.hpp"
#include "tools/cli/manual.hpp"
#include "tools/io/console.hpp"
#include "tools/io/partial_file.hpp"
#include "tools/io/suggest.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace {

using namespace umbra78::tools;

int fail(std::string what, int exit_code) {
    print_error(std::move(what));
    return exit_code;
}

// CLI11 prints help with std::cout, whose buffer is standard output's.
bool printed_all() {
    errno = 0;
    std::cout.flush();
    return std::fflush(stdout) == 0 && std::cout.good() && std::ferror(stdout) == 0;
}

// The reason is lost where std::cout met it.
int fail_to_print() {
    const std::string why = errno != 0 ? std::generic_category().message(errno)
                                       : "standard output is full or closed";
    return fail("cannot print: " + why + "; give a place that can be written to", 1);
}

// CLI11's error as one line, with what to do about it.
int fail_of_usage(const CLI::App& app, const CLI::ParseError& error) {
    const CLI::App* chosen = &app;
    std::string words;
    while (!chosen->get_subcommands().empty()) {
        chosen = chosen->get_subcommands().front();
        words += chosen->get_name() + " ";
    }
    const CLI::App& at = *chosen;
    const std::string help = fmt::format("see umbra78 {}--help", words);
    const std::vector<std::string> unknown = app.remaining(true);
    if (unknown.empty()) return fail(fmt::format("{}; {}", error.what(), help), 2);

    std::vector<std::string> names;
    for (const CLI::App* command : at.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    for (const CLI::Option* option : at.get_options()) names.push_back(option->get_name());
    const std::vector<std::string_view> known(names.begin(), names.end());
    return fail(fmt::format("unknown argument '{}'; {}; {}", unknown.front(),
                            suggest(unknown.front(), known), help), 2);
}

}  // namespace

// A broken precondition of the machine (fixed/trap.hpp): a fault of the program, not of its input.
// Called just before the trap instruction stops it, so it does no more than print.
extern "C" void umbra78_trapped(const char* why) {
    std::fprintf(stderr, "umbra78: internal error: %s\n", why);
}

int main(int argc, char** argv) {
    open_standard_streams();
    remove_partial_files_on_signals();
    CLI::App app{"The shadow machine of Lance Williams' \"Casting Curved Shadows on Curved "
                 "Surfaces\" (1978), in fixed point and bit for bit."};
    app.name("umbra78");
    app.set_version_flag("--version", "umbra78 " UMBRA78_VERSION);
    const auto prints = [&app](const char* flag, std::string (*text)(const CLI::App&),
                               const char* meaning) {
        app.add_flag_callback(flag, [&app, text] {
            fmt::print("{}", text(app));
            throw CLI::Success();
        }, meaning);
    };
    prints("--manual", manual_page, "Print the manual page (roff) and exit");
    prints("--completion", bash_completion, "Print the completion for bash and exit");
    app.require_subcommand(1);
    int exit_code = 0;
    add_figures_command(app, exit_code);
    add_render_command(app, exit_code);
    add_plan_command(app, exit_code);
    add_animate_command(app, exit_code);
    add_cycles_command(app, exit_code);
    add_trace_command(app, exit_code);
    add_bands_command(app, exit_code);
    add_bias_command(app, exit_code);
    add_shadow_command(app, exit_code);
    add_study_command(app, exit_code);
    add_model_command(app, exit_code);
    add_pack_command(app, exit_code);
    add_settings_command(app, exit_code);
    app.footer("Example:\n  umbra78 figures --out out");  // last, or the commands would inherit it
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) return fail_of_usage(app, error);
        app.exit(error);  // --help, --version
    } catch (const std::bad_alloc&) {
        return fail("not enough memory; lower xy_bits or z_bits", 1);
    } catch (const std::exception& error) {
        if (std::ferror(stdout) != 0) return fail_to_print();
        return fail(error.what(), 1);
    }
    if (!printed_all()) return fail_to_print();
    return lost_messages() ? 1 : exit_code;
}
