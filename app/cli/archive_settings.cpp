#include "app/cli/archive_arguments.h"
#include "io/archive/store/cache.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace angiopose::app {
namespace {

using SettingsJson = nlohmann::ordered_json;

std::string nodeFileOf(const ArchiveArguments& arguments)
{
    return arguments.nodeFile.empty() ? io::defaultArchiveSettingsFile() : arguments.nodeFile;
}

/// Reads the archive list, applies `change` and writes the list.
template <class Change>
int changeSettings(const ArchiveArguments& arguments, const Change& change)
{
    auto settings = io::readArchiveSettings(nodeFileOf(arguments));
    if (!settings) {
        return reportInputError(settings.error(), arguments.format);
    }
    io::ArchiveSettings changed = std::move(settings).value();
    if (auto done = change(changed); !done) {
        return reportInputError(done.error(), arguments.format);
    }
    if (auto written = io::writeArchiveSettings(changed, nodeFileOf(arguments)); !written) {
        return reportInputError(written.error(), arguments.format);
    }
    return exitSuccess;
}

void printSettingsJson(const SettingsJson& json)
{
    std::puts(json.dump(2, ' ', false, SettingsJson::error_handler_t::replace).c_str());
}

void dropNode(std::vector<io::ArchiveNode>& nodes, const std::string& name)
{
    std::erase_if(nodes, [&name](const io::ArchiveNode& node) { return node.name == name; });
}

}   // namespace

int runArchiveNodes(const ArchiveArguments& arguments)
{
    const auto settings = io::readArchiveSettings(nodeFileOf(arguments));
    if (!settings) {
        return reportInputError(settings.error(), arguments.format);
    }
    SettingsJson json{{"file", nodeFileOf(arguments)}, {"archives", SettingsJson::array()}};
    for (const io::ArchiveNode& node : settings.value().nodes) {
        const std::string address = node.host.empty() ? "" : io::hostAndPort(node) + " " + node.title;
        json["archives"].push_back(
            {{"name", node.name}, {"address", address}, {"tls", node.isTls}, {"url", node.webUrl}});
        if (arguments.format == OutputFormat::Text) {
            std::printf("%s  %s%s  %s\n", node.name.c_str(), address.c_str(), node.isTls ? " TLS" : "",
                        node.webUrl.c_str());
        }
    }
    if (arguments.format == OutputFormat::Json) {
        printSettingsJson(json);
    }
    return exitSuccess;
}

int runArchiveAdd(const ArchiveNodeArguments& arguments)
{
    io::ArchiveNode node = arguments.node;
    node.verifiesHost = !arguments.isHostUnchecked;
    const int exitCode = changeSettings(arguments.connection, [&node](io::ArchiveSettings& settings) {
        dropNode(settings.nodes, node.name);
        settings.nodes.push_back(node);
        return core::Status(core::Done{});
    });
    if (exitCode == exitSuccess) {
        printWarnings(io::connectionWarnings(node));
    }
    return exitCode;
}

int runArchiveRemove(const ArchiveArguments& arguments)
{
    return changeSettings(arguments, [&arguments](io::ArchiveSettings& settings) -> core::Status {
        if (auto found = io::findNode(settings, arguments.nodeName, nodeFileOf(arguments)); !found) {
            return found.error();
        }
        dropNode(settings.nodes, arguments.nodeName);
        return core::Done{};
    });
}

int runArchiveCacheList(const ArchiveCacheArguments& arguments)
{
    const auto settings = io::readArchiveSettings(nodeFileOf(arguments.connection));
    if (!settings) {
        return reportInputError(settings.error(), arguments.connection.format);
    }
    std::uint64_t limit = settings.value().cacheBytes;
    const std::string folder = settings.value().cache();
    if (arguments.limitGb) {
        limit = static_cast<std::uint64_t>(*arguments.limitGb * 1e9);
        const int exitCode = changeSettings(arguments.connection, [limit](io::ArchiveSettings& changed) {
            changed.cacheBytes = limit;
            return core::Status(core::Done{});
        });
        if (exitCode != exitSuccess) {
            return exitCode;
        }
        io::shrinkCache(folder, limit);
    }
    SettingsJson json{{"folder", folder}, {"limitBytes", limit}, {"series", SettingsJson::array()}};
    std::uint64_t bytes = 0;
    for (const io::CachedSeries& series : io::listCachedSeries(folder)) {
        bytes += series.bytes;
        json["series"].push_back({{"studyUid", series.studyUid},
                                  {"seriesUid", series.seriesUid},
                                  {"folder", series.folder},
                                  {"objects", series.objects},
                                  {"bytes", series.bytes},
                                  {"whole", series.isComplete}});
        if (arguments.connection.format == OutputFormat::Text) {
            std::printf("%s  %zu objects  %s%s\n", series.folder.c_str(), series.objects,
                        io::sizeText(series.bytes).c_str(), series.isComplete ? "" : "  incomplete");
        }
    }
    if (arguments.connection.format == OutputFormat::Json) {
        printSettingsJson(json);
    } else {
        std::printf("%s of at most %s in %s\n", io::sizeText(bytes).c_str(), io::sizeText(limit).c_str(),
                    folder.c_str());
    }
    return exitSuccess;
}

int runArchiveCacheEmpty(const ArchiveCacheArguments& arguments)
{
    const auto settings = io::readArchiveSettings(nodeFileOf(arguments.connection));
    if (!settings) {
        return reportInputError(settings.error(), arguments.connection.format);
    }
    const auto dropped = io::clearCache(settings.value().cache());
    if (!dropped) {
        return reportInputError(dropped.error(), arguments.connection.format);
    }
    if (arguments.connection.format == OutputFormat::Json) {
        printSettingsJson({{"dropped", dropped.value()}});
    } else {
        std::printf("%zu objects deleted\n", dropped.value());
    }
    return exitSuccess;
}

}   // namespace angiopose::app
