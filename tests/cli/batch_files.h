#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

namespace angiopose::test {

/// The files of a batch's folder by their path in it, without what differs from run to run: times in JSON and in
/// pictures, times.csv, and the order in which shards wrote their tables.
std::map<std::string, std::string> lastingContentOf(const std::string& folder);

/// Processes that work on the cases of a batch whose parent is this process.
std::vector<pid_t> batchWorkers();

/// The process that started another.
pid_t parentOf(pid_t process);

}   // namespace angiopose::test
