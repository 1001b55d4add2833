#include "core/support/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <opencv2/core/utility.hpp>
#include <thread>

namespace angiopose::core {
namespace {

std::atomic<int> threadLimit{0};   // thread limit of the process; 0 for all processors

}   // namespace

int availableThreads()
{
    const int allowed = threadLimit;
    return allowed > 0 ? allowed : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void limitThreads(int threads)
{
    threadLimit = std::max(1, threads);
    cv::setNumThreads(std::max(1, threads));
}

}   // namespace angiopose::core
