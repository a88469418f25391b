// Standard output and standard error, which may be closed, full or a broken pipe.
//
// An error or a warning is one line on standard error. Printing one never throws. What could not
// be printed is noted, so that the program does not end as if all were well.
#pragma once

#include <string>

namespace umbra78::tools {

// At the program's start: a standard stream that is closed is opened so that writing to it fails.
// Otherwise the next file to be opened would get its number, and warnings would go into that file.
void open_standard_streams();

// "umbra78: <text>" and a newline. Control characters become blanks: the message stays one line.
void print_error(std::string text);
void print_warning(const std::string& text);  // "umbra78: warning: <text>"
// What only informs: it may be lost.
void print_progress(const std::string& text);

bool lost_messages();  // whether an error or a warning could not be printed

// From here on what the program prints goes to standard error, and standard output is free for a
// file.
void take_standard_output();
int standard_output();  // its descriptor, taken or not

}  // namespace umbra78::tools
