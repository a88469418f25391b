// The chain of stages against a slow model that moves tokens and then asks, of the picture at the
// cycle's end, what each blocked one waits for; and small cases by hand.
#include "hw/clocked/handshake.hpp"

#include "tests/fixed/boundary.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace umbra78::hw {
namespace {

using fixed::test::Random;

struct Counts {
    std::uint64_t work = 0, blocked = 0, held = 0;
    std::vector<std::uint64_t> by;
};

// Tokens in the order they entered, each with its stage and the work it has left there.
class SlowChain {
public:
    explicit SlowChain(std::vector<int> stay) : stay_(std::move(stay)), counts_(stay_.size()) {
        for (Counts& c : counts_) c.by.resize(stay_.size());
    }

    bool ready() const { return at(0) == nullptr; }
    void enter(int slot) { tokens_.push_back({slot, 0, stay_[0], -1, 0}); }
    const Counts& counts(int k) const { return counts_[std::size_t(k)]; }
    std::uint64_t waited(int slot) const {
        for (const Token& t : tokens_)
            if (t.slot == slot) return t.waited;
        return 0;
    }

    // Returns the slot that left, or -1.
    int tick(std::uint64_t held) {
        const auto is_held = [&](int k) { return (held >> k & 1) != 0; };
        for (Token& t : tokens_) {
            Counts& c = counts_[std::size_t(t.stage)];
            if (is_held(t.stage)) {
                ++c.held, ++t.waited;
            } else if (t.left > 0) {
                ++c.work, --t.left;
            } else {
                ++c.blocked, ++t.waited, ++c.by[std::size_t(t.blocker)];
            }
        }
        int out = -1;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {  // the oldest, and farthest, first
            Token& t = tokens_[i];
            if (is_held(t.stage) || t.left > 0) continue;
            const int next = t.stage + 1;
            if (next == int(stay_.size())) {
                out = t.slot;
                tokens_.erase(tokens_.begin());
                --i;
            } else if (at(next) == nullptr && !is_held(next)) {
                t.stage = next;
                t.left = stay_[std::size_t(next)];
            }
        }
        // Who waits looks along the tokens that wait, too, to the first stage that is at work or
        // held: that one it waits for.
        for (Token& t : tokens_) {
            if (is_held(t.stage) || t.left > 0) continue;
            int by = t.stage + 1;
            while (!is_held(by) && at(by)->left == 0) ++by;
            t.blocker = by;
        }
        return out;
    }

private:
    struct Token {
        int slot, stage, left, blocker;
        std::uint64_t waited;
    };
    const Token* at(int stage) const {
        for (const Token& t : tokens_)
            if (t.stage == stage) return &t;
        return nullptr;
    }
    std::vector<int> stay_;
    std::vector<Token> tokens_;
    std::vector<Counts> counts_;
};

std::unique_ptr<Chain<>> chain_of(const std::vector<int>& stay) {
    auto chain = std::make_unique<Chain<>>();
    for (const int cycles : stay) chain->add("stage", cycles);
    return chain;
}

TEST(Chain, EqualsTheSlowModel) {
    Random random;
    for (int round = 0; round < 300; ++round) {
        const int n = round == 0 ? max_stages : static_cast<int>(random.between(1, 8));
        std::vector<int> stay;
        for (int k = 0; k < n; ++k) stay.push_back(static_cast<int>(random.between(1, 4)));
        const auto chain = chain_of(stay);
        SlowChain slow(stay);
        const auto holds = random.between(0, 3);   // how many stages are held, of 4
        const auto feeds = random.between(1, 4);   // how often a token is offered, of 4
        int slot = 0;
        for (int cycle = 0; cycle < 400; ++cycle) {
            ASSERT_EQ(chain->ready(0), slow.ready());
            if (slow.ready() && random.between(1, 4) <= feeds) {
                chain->enter(static_cast<std::int8_t>(slot));
                slow.enter(slot);
                slot = (slot + 1) % (max_stages + 1);
            }
            std::uint64_t held = 0;
            for (int k = 0; k < n; ++k)
                held |= std::uint64_t{random.between(0, 3) < holds} << k;
            ASSERT_EQ(int{chain->tick(held, [](int, int, int) {})}, slow.tick(held));
            for (int k = 0; k < n; ++k) {
                const Counts& c = slow.counts(k);
                ASSERT_EQ(chain->time(k).work, c.work) << "stage " << k << ", cycle " << cycle;
                ASSERT_EQ(chain->time(k).blocked, c.blocked) << "stage " << k;
                ASSERT_EQ(chain->time(k).held, c.held) << "stage " << k;
                for (int by = 0; by < n; ++by)
                    ASSERT_EQ(chain->blocked_by(k, by), c.by[std::size_t(by)])
                        << "stage " << k << " for " << by << " of " << n << ", cycle " << cycle;
                if (chain->slot(k) >= 0) {
                    ASSERT_EQ(chain->waited(chain->slot(k)), slow.waited(chain->slot(k)));
                }
            }
        }
    }
}

// Stays 1, 1 and 5, always fed: the stage of five blocks both, also the one that is not next to it.
TEST(Chain, TheSlowStageIsBlamedAllTheWayBack) {
    const auto chain = chain_of({1, 1, 5});
    for (int cycle = 0; cycle < 60; ++cycle) {
        if (chain->ready(0)) chain->enter(static_cast<std::int8_t>(cycle % 60));
        chain->tick(0, [](int, int, int) {});
    }
    EXPECT_GT(chain->time(0).blocked, 40u);
    EXPECT_EQ(chain->blocked_by(0, 2), chain->time(0).blocked);
    EXPECT_EQ(chain->blocked_by(1, 2), chain->time(1).blocked);
    EXPECT_EQ(chain->time(2).blocked, 0u);
}

// An empty stage that is held takes nothing: it is to blame, though it has no token.
TEST(Chain, AHeldEmptyStageIsBlamed) {
    const auto chain = chain_of({1, 1, 1});
    chain->enter(0);
    for (int cycle = 0; cycle < 5; ++cycle) chain->tick(2, [](int, int, int) {});
    EXPECT_EQ(chain->time(0).work, 1u);
    EXPECT_EQ(chain->time(0).blocked, 4u);
    EXPECT_EQ(chain->blocked_by(0, 1), 4u);
    EXPECT_EQ(chain->time(1).held, 0u) << "without a token in it";
    EXPECT_EQ(chain->culprit(0), 1);
}

// work() is called once for each cycle of each stay, in order, with the slot.
TEST(Chain, WorkIsCalledCycleByCycle) {
    const auto chain = chain_of({2, 3});
    chain->enter(7);
    std::string calls;
    int left = -1;
    for (int cycle = 0; cycle < 6; ++cycle) {
        const int out = chain->tick(cycle == 1 ? 1 : 0, [&](int stage, int at, int slot) {
            calls += std::to_string(stage) + std::to_string(at) + std::to_string(slot) + ' ';
        });
        if (out >= 0) left = cycle;
    }
    EXPECT_EQ(calls, "007 017 107 117 127 ");
    EXPECT_EQ(left, 5);
    EXPECT_TRUE(chain->empty());
}

TEST(StageList, IsTheChainsStagesAndFewBytes) {
    StageList list;
    EXPECT_EQ(list.add("a", 3), 0);
    EXPECT_EQ(list.add("b"), 1);
    EXPECT_EQ(list.stages(), 2);
    EXPECT_EQ(list.name(0), "a");
    EXPECT_EQ(list.stay(0), 3);
    EXPECT_EQ(list.stay(1), 1);
    static_assert(sizeof(StageList) <= 2048, "a stack frame of the ledger's");
    EXPECT_DEATH(list.add("none", 0), "63 stages of one cycle or more");
    while (list.stages() < max_stages) list.add("more");
    EXPECT_DEATH(list.add("64th"), "63 stages of one cycle or more");
}

}  // namespace
}  // namespace umbra78::hw
