// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/common/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace scan_to_path {
namespace {

std::vector<double> squareRoots(std::size_t count, int threads) {
  std::vector<double> result(count, -1.0);
  parallelFor(count, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = std::sqrt(static_cast<double>(i));
  });
  return result;
}

TEST(Parallel, EveryIndexOnceWithAnyNumberOfThreads) {
  for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
    for (const int threads : {0, 1, 2, 3, 16}) {
      std::vector<std::atomic<int>> visits(count);
      parallelFor(count, threads, [&](std::size_t begin, std::size_t end) {
        EXPECT_LT(begin, end);
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      for (const auto& visit : visits) EXPECT_EQ(visit, 1);
    }
  }
}

TEST(Parallel, ResultDoesNotDependOnThreads) {
  const auto expected = squareRoots(10001, 1);
  for (const int threads : {0, 2, 3, 8}) EXPECT_EQ(squareRoots(10001, threads), expected);
}

TEST(Parallel, UsesTheThreadsAskedFor) {
  std::mutex mutex;
  std::set<std::thread::id> ids;
  parallelFor(4, 4, [&](std::size_t, std::size_t) {
    const std::lock_guard lock(mutex);
    ids.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(ids.size(), 4U);
  EXPECT_EQ(ids.count(std::this_thread::get_id()), 1U);
}

TEST(Parallel, LowestFailureIsThrownAfterAllHaveEnded) {
  for (const int threads : {1, 2, 4}) {
    std::atomic<int> ended = 0;
    const auto work = [&](std::size_t begin, std::size_t) {
      ++ended;
      throw std::runtime_error("chunk " + std::to_string(begin));
    };
    try {
      parallelFor(100, threads, work);
      FAIL() << "nothing thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "chunk 0");
    }
    EXPECT_EQ(ended, threads);
  }
}

TEST(Parallel, FailureOfALaterChunkIsThrownToo) {
  EXPECT_THROW(parallelFor(8, 4,
                           [](std::size_t begin, std::size_t) {
                             if (begin >= 6) throw std::out_of_range("late");
                           }),
               std::out_of_range);
}

}  // namespace
}  // namespace scan_to_path
