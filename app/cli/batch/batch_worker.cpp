#include "app/cli/batch/batch_worker.h"

#include "app/cli/batch/batch_job.h"
#include "app/cli/batch/batch_row.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "core/support/parallel_for.h"
#include "io/support/system/worker_process.h"

namespace angiopose::app {

std::vector<std::string> workerEnvironment(int threads)
{
    std::vector<std::string> environment{"MALLOC_MMAP_THRESHOLD_=67108864", "MALLOC_TRIM_THRESHOLD_=268435456",
                                         "MALLOC_ARENA_MAX=2"};
    for (const char* name :
         {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "ITK_GLOBAL_DEFAULT_NUMBER_OF_THREADS", "VTK_SMP_MAX_THREADS"}) {
        environment.push_back(std::string(name) + "=" + std::to_string(threads));
    }
    return environment;
}

int runBatchWorker(int parent, int threads)
{
    if (!io::WorkerChannel::open(parent)) {
        printMessage("batch-worker is internal and is started only by `batch`.");
        return exitUsageError;
    }
    core::limitThreads(threads);
    for (std::string line; io::WorkerChannel::receiveLine(line, isInterrupted);) {
        const auto outcome = processRow(parseJob(line));
        if (!outcome || !io::WorkerChannel::sendLine(toJsonLine(*outcome))) {
            return exitInterrupted;
        }
    }
    return exitSuccess;
}

}   // namespace angiopose::app
