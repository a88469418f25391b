// Lets the current piece of work finish when the user interrupts the program.
#pragma once

#include <atomic>
#include <csignal>

namespace umbra78::tools {

// While an object exists, SIGINT and SIGTERM only set asked(). At most one object may exist.
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
