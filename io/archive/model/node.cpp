#include "io/archive/model/node.h"

#include "io/messages/messages.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr std::size_t maxTitle = 16;
constexpr std::size_t maxName = 64;

bool isPort(int port)
{
    return port >= 1 && port <= 65535;
}

bool isHostName(std::string_view host)
{
    return std::ranges::all_of(host, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' ||
               c == '_';
    });
}

bool isHttpUrl(std::string_view url)
{
    const bool hasScheme = url.starts_with("https://") || url.starts_with("http://");
    return hasScheme && std::ranges::all_of(url, [](char c) { return c > ' ' && c <= '~'; });
}

bool isHere(std::string_view host)
{
    return host == "localhost" || host.starts_with("127.");
}

std::string_view hostOfUrl(std::string_view url)
{
    const std::size_t begin = url.find("://") + 3;
    return url.substr(begin, url.find_first_of(":/", begin) - begin);
}

std::vector<core::Message> problemsOf(const ArchiveNode& node)
{
    std::vector<core::Message> found;
    const auto refuseIf = [&found](bool isWrong, const core::Message& problem) {
        if (isWrong) {
            found.push_back(problem);
        }
    };
    refuseIf(node.name.empty() || node.name.size() > maxName, messages::archiveNoName());
    refuseIf(node.host.empty() && node.webUrl.empty(), messages::archiveNoAddress());
    refuseIf(!isHostName(node.host), messages::archiveBadHost(node.host));
    refuseIf(!isPort(node.port), messages::archiveBadPort(node.port));
    refuseIf(node.receivePort != 0 && !isPort(node.receivePort), messages::archiveBadPort(node.receivePort));
    refuseIf(!isAeTitle(node.title), messages::archiveBadTitle(node.title));
    refuseIf(!isAeTitle(node.ownAeTitle), messages::archiveBadTitle(node.ownAeTitle));
    refuseIf(!node.webUrl.empty() && !isHttpUrl(node.webUrl), messages::archiveBadUrl(node.webUrl));
    refuseIf(node.certificateFile.empty() != node.keyFile.empty(), messages::archiveKeyWithoutCertificate());
    refuseIf(node.responseTimeoutSeconds < 1 || node.responseTimeoutSeconds > 600, messages::archiveBadTime());
    return found;
}

}   // namespace

bool isAeTitle(std::string_view title)
{
    const bool isPlain = std::ranges::all_of(title, [](char c) { return c >= ' ' && c <= '~' && c != '\\'; });
    return isPlain && title.size() <= maxTitle && title.find_first_not_of(' ') != std::string_view::npos;
}

std::string hostAndPort(const ArchiveNode& node)
{
    return node.host + ":" + std::to_string(node.port);
}

core::Status checkNode(const ArchiveNode& node)
{
    const auto problems = problemsOf(node);
    return problems.empty() ? core::Status(core::Done{}) : core::Error(problems.front().about(node.name));
}

core::Messages connectionWarnings(const ArchiveNode& node)
{
    core::Messages notes;
    if (!node.host.empty() && !node.isTls && !isHere(node.host)) {
        notes.push_back(messages::archivePlainText(hostAndPort(node)).about(node.name));
    }
    if (node.webUrl.starts_with("http://") && !isHere(hostOfUrl(node.webUrl))) {
        notes.push_back(messages::archivePlainText(node.webUrl).about(node.name));
    }
    return notes;
}

}   // namespace angiopose::io
