#pragma once

#include "app/cli/console.h"
#include "io/archive/archive.h"
#include "io/archive/dimse/storage_scp.h"
#include "io/archive/node_file.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::app {

/// Arguments common to all archive commands.
struct ArchiveArguments {
    std::string nodeFile;   ///< if empty, the user's archive list
    std::string nodeName;
    io::ArchiveProtocol protocol = io::ArchiveProtocol::Default;
    OutputFormat format = OutputFormat::Text;
};

struct ArchiveFindArguments {
    ArchiveArguments connection;
    io::ArchiveQuery query;
    std::string dates;   ///< study dates, as typed
};

struct ArchiveRetrieveArguments {
    ArchiveArguments connection;
    io::RetrieveRequest request;
    std::string folder;   ///< if empty, the cache
    std::string auditFile;   ///< empty if not requested
    double maxObjectGb = 4.0;
};

struct ArchiveSendArguments {
    ArchiveArguments connection;
    std::vector<std::string> paths;
};

struct ArchiveReceiveArguments {
    io::StorageScpOptions options;
    std::string folder;
    std::string auditFile;   ///< empty if not requested
    double maxObjectGb = 4.0;
    double maxGb = 0.0;   ///< size limit of the folder; 0 if only the disk limits it
    std::size_t count = 0;   ///< exit after this number of objects; 0 to run until canceled
    OutputFormat format = OutputFormat::Text;
};

struct ArchiveNodeArguments {
    ArchiveArguments connection;
    io::ArchiveNode node;
    bool isHostUnchecked = false;
};

struct ArchiveCacheArguments {
    ArchiveArguments connection;
    std::optional<double> limitGb;
};

int runArchiveEcho(const ArchiveArguments& arguments);
int runArchiveFind(const ArchiveFindArguments& arguments);
int runArchiveRetrieve(const ArchiveRetrieveArguments& arguments);
int runArchiveSend(const ArchiveSendArguments& arguments);
int runArchiveReceive(const ArchiveReceiveArguments& arguments);
int runArchiveNodes(const ArchiveArguments& arguments);
int runArchiveAdd(const ArchiveNodeArguments& arguments);
int runArchiveRemove(const ArchiveArguments& arguments);
int runArchiveCacheList(const ArchiveCacheArguments& arguments);
int runArchiveCacheEmpty(const ArchiveCacheArguments& arguments);

}   // namespace angiopose::app
