#include "tools/io/console.hpp"

#include "tools/io/first_error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace umbra78::tools {
namespace {

bool lost = false;
int taken = -1;  // standard output, once it is taken

bool print_all(const std::string& text) {
    return std::fwrite(text.data(), 1, text.size(), stderr) == text.size() &&
           std::fflush(stderr) == 0;
}

}  // namespace

// A descriptor takes the lowest free number, so the order is 0, 1, 2.
void open_standard_streams() {
    for (int number = 0; number <= 2; ++number)
        if (::fcntl(number, F_GETFD) < 0 && errno == EBADF)
            if (::open("/dev/null", number == 0 ? O_WRONLY : O_RDONLY) < 0) return;
}

void print_error(std::string text) {
    lost |= !print_all("umbra78: " + in_one_line(std::move(text)) + "\n");
}

void print_warning(const std::string& text) { print_error("warning: " + text); }

void print_progress(const std::string& text) { print_all(text); }

bool lost_messages() { return lost; }

void take_standard_output() {
    if (taken >= 0) return;
    std::fflush(stdout);
    taken = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    if (taken < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        throw std::runtime_error("standard output cannot be used for a file; name a file");
}

int standard_output() { return taken >= 0 ? taken : STDOUT_FILENO; }

}  // namespace umbra78::tools
