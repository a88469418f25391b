// The pool does each part once, whatever the number of threads, and a frame is the same with any.
#include "tools/render/thread_pool.hpp"

#include "tests/support/paths.hpp"
#include "tools/io/buffers.hpp"
#include "tools/render/render_job.hpp"
#include "tools/scene/scene_file.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <vector>

namespace umbra78::tools {
namespace {

TEST(ThreadPool, DoesEachPartOnce) {
    for (const std::size_t workers : {1u, 2u, 5u}) {
        ThreadPool pool(workers);
        const shadow::Executor executor = pool.executor();
        EXPECT_EQ(executor.workers, workers);
        for (const std::size_t parts : {0u, 1u, 2u, 3u, 200u}) {
            std::vector<std::atomic<int>> done(parts);
            std::atomic<int> strangers{0};
            for (int run = 0; run < 20; ++run)
                executor(parts, [&](std::size_t p, std::size_t worker) {
                    ++done[p];
                    if (worker >= workers) ++strangers;
                });
            for (const std::atomic<int>& d : done) EXPECT_EQ(d, 20);
            EXPECT_EQ(strangers, 0);
        }
    }
}

TEST(ThreadPool, HasAWorkerForEachProcessorIfNoneAreAskedFor) {
    EXPECT_EQ(workers_for(1), 1u);
    EXPECT_EQ(workers_for(7), 7u);
    EXPECT_GE(workers_for(0), 1u);
    EXPECT_EQ(workers_for(1000), shadow::max_workers);
}

TEST(ThreadPool, DrawsTheSameFrame) {
    const std::vector<std::string> small{"xy_bits=7"};
    for (const char* name : {"figures.toml", "mesh.toml"}) {
        const LoadedScene scene =
            load_scene(std::string(UMBRA78_SOURCE_DIR) + "/tools/scenes/" + name, small);
        RenderJob one(scene.view(), scene.settings);
        ThreadPool pool(3);
        RenderJob three(scene.view(), scene.settings, Maps::shown, pool.executor());
        one.render();
        three.render();
        for (const PlaneOf& plane : one.planes())
            EXPECT_EQ(hash_of(one.buffer(plane)), hash_of(three.buffer(plane)))
                << name << ": " << one.buffer(plane).name;
    }
}

}  // namespace
}  // namespace umbra78::tools
