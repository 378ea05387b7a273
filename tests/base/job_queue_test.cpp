#include "base/job_queue.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace crawford {
namespace {

TEST(JobQueue, RunsEveryJobOnceAndTellsOfEachEnd) {
    std::atomic<int> ran = 0;
    std::vector<Job> jobs;
    for (int k = 0; k < 20; ++k)
        jobs.push_back({std::to_string(k), 1.0, [&](const Job::Progress&) { ++ran; }});
    std::vector<std::size_t> ended;
    run_jobs(jobs, {.ended = [&](const Job&, double, const std::exception_ptr& failure,
                                 const QueueStanding& standing) {
                 EXPECT_FALSE(failure);
                 EXPECT_EQ(standing.total, 20U);
                 ended.push_back(standing.ended);
             }});
    EXPECT_EQ(ran, 20);
    ASSERT_EQ(ended.size(), 20U);
    for (std::size_t k = 0; k < ended.size(); ++k) EXPECT_EQ(ended[k], k + 1);
}

TEST(JobQueue, BeginsWithTheLongest) {
    std::mutex mutex;
    std::vector<std::string> begun;
    const auto begin = [&](const char* name) {
        return [&, name](const Job::Progress&) {
            const std::scoped_lock lock(mutex);
            begun.emplace_back(name);
        };
    };
    run_jobs({{"short", 1.0, begin("short")}, {"long", 9.0, begin("long")}});
    ASSERT_EQ(begun.size(), 2U);
    if (std::thread::hardware_concurrency() < 2) {
        EXPECT_EQ(begun.front(), "long");
    }
}

TEST(JobQueue, AJobThatThrowsStopsNoOther) {
    std::atomic<int> ran = 0;
    std::string said;
    run_jobs({{"bad", 2.0, [](const Job::Progress&) { throw std::runtime_error("no"); }},
              {"good", 1.0, [&](const Job::Progress&) { ++ran; }}},
             {.ended = [&](const Job& job, double, const std::exception_ptr& failure,
                           const QueueStanding&) {
                 if (failure) said = job.name;
             }});
    EXPECT_EQ(ran, 1);
    EXPECT_EQ(said, "bad");
}

TEST(JobQueue, PassesOnHowMuchOfAJobIsDone) {
    std::vector<double> told;
    double to_go = -1.0;
    run_jobs({{"one", 10.0, [](const Job::Progress& progress) { progress(0.25); }}},
             {.progress = [&](const Job&, double done, const QueueStanding& standing) {
                 told.push_back(done);
                 to_go = standing.to_go;
             }});
    EXPECT_EQ(told, std::vector<double>{0.25});
    EXPECT_GE(to_go, 0.0);
}

TEST(JobQueue, TimeToGoSharesTheWorkButWaitsForTheLongest) {
    EXPECT_DOUBLE_EQ(time_to_go({4.0, 4.0}, 0.0, 0.0, 2), 4.0) << "as expected, at first";
    EXPECT_DOUBLE_EQ(time_to_go({6.0, 2.0}, 0.0, 0.0, 2), 6.0) << "the longest cannot be shared";
    EXPECT_DOUBLE_EQ(time_to_go({4.0, 4.0}, 4.0, 4.0, 2), 8.0) << "half as fast as expected";
    EXPECT_DOUBLE_EQ(time_to_go({}, 4.0, 4.0, 2), 0.0);
}

}  // namespace
}  // namespace crawford
