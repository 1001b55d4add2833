#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

namespace angiopose::test {

/// The files in a batch's output folder by relative path, without the content that varies between executions: times in
/// JSON and in images, times.csv, and the order in which shards wrote their tables.
std::map<std::string, std::string> lastingContentOf(const std::string& folder);

/// Worker processes of a batch whose parent is this process.
std::vector<pid_t> batchWorkers();

pid_t parentOf(pid_t process);

}   // namespace angiopose::test
