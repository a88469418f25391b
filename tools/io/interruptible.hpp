// An interruption lets what is at hand be finished.
#pragma once

#include <atomic>
#include <csignal>

namespace umbra78::tools {

// While it lives SIGINT and SIGTERM are noted, no more. One at a time.
class Interruptible {
public:
    Interruptible() : interrupt_(std::signal(SIGINT, ask)), terminate_(std::signal(SIGTERM, ask)) {}
    ~Interruptible() {
        std::signal(SIGINT, interrupt_);
        std::signal(SIGTERM, terminate_);
    }
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;

    static bool asked() { return asked_; }

private:
    static inline std::atomic<bool> asked_ = false;
    static_assert(std::atomic<bool>::is_always_lock_free);  // a signal may store it
    static void ask(int) { asked_ = true; }
    void (*interrupt_)(int);
    void (*terminate_)(int);
};

}  // namespace umbra78::tools
