// The program's commands, a file each (tools/cli/<command>.cpp).
//
// Each function adds its command to the app. A command that can end with another exit code than 0
// without an error (a golden that differs) writes it to `exit_code` when it runs.
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
void add_bias_command(CLI::App&, int& exit_code);
void add_shadow_command(CLI::App&, int& exit_code);
void add_study_command(CLI::App&, int& exit_code);
void add_model_command(CLI::App&, int& exit_code);
void add_pack_command(CLI::App&, int& exit_code);
void add_cycles_command(CLI::App&, int& exit_code);

}  // namespace umbra78::tools
