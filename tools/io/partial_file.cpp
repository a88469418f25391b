#include "tools/io/partial_file.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstring>
#include <utility>

namespace umbra78::tools {

// A signal may come at any time and in any thread, so entries are only ever added in front, and
// are never freed: a few hundred bytes for each file written.
struct PartialFile::Entry {
    const char* name;
    std::atomic<bool> live;
    Entry* next;
};

namespace {

std::atomic<PartialFile::Entry*> entries = nullptr;
static_assert(std::atomic<PartialFile::Entry*>::is_always_lock_free);

// Calls only what a signal handler may call.
void remove_and_end(int signal) {
    for (PartialFile::Entry* e = entries; e != nullptr; e = e->next)
        if (e->live) ::unlink(e->name);
    ::signal(signal, SIG_DFL);
    ::raise(signal);
}

}  // namespace

void remove_partial_files_on_signals() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT}) {
        struct sigaction now {};
        if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN) continue;
        now = {};
        now.sa_handler = remove_and_end;
        ::sigaction(signal, &now, nullptr);
    }
    ::signal(SIGXFSZ, SIG_IGN);
}

PartialFile::PartialFile(const std::filesystem::path& of)
    : entry_(new Entry{::strdup(fmt::format("{}.partial-{}", of.string(), getpid()).c_str()), true,
                       entries.load()}) {
    while (!entries.compare_exchange_weak(entry_->next, entry_)) {
    }
}

PartialFile::PartialFile(PartialFile&& other) noexcept
    : entry_(std::exchange(other.entry_, nullptr)) {}

PartialFile::~PartialFile() {
    if (entry_ == nullptr || !entry_->live) return;
    std::remove(entry_->name);
    entry_->live = false;
}

const char* PartialFile::name() const { return entry_->name; }

bool PartialFile::rename_to(const std::filesystem::path& path) {
    if (std::rename(entry_->name, path.c_str()) != 0) return false;
    entry_->live = false;
    return true;
}

}  // namespace umbra78::tools
