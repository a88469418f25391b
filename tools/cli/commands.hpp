// The program's subcommands. Each adds itself to the app; run, it leaves the exit code.
#pragma once

namespace CLI {
class App;
}

namespace umbra78::tools {

void add_figures_command(CLI::App&, int& exit_code);
void add_render_command(CLI::App&, int& exit_code);
void add_plan_command(CLI::App&, int& exit_code);
void add_animate_command(CLI::App&, int& exit_code);
void add_trace_command(CLI::App&, int& exit_code);
void add_settings_command(CLI::App&, int& exit_code);
void add_bands_command(CLI::App&, int& exit_code);
void add_study_command(CLI::App&, int& exit_code);
void add_cycles_command(CLI::App&, int& exit_code);

}  // namespace umbra78::tools
