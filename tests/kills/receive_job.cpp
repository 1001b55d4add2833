#include "tests/kills/receive_job.h"

#include "io/angiogram_file.h"
#include "io/archive/archive.h"
#include "io/archive/dimse/storage_scp.h"
#include "tests/io/archive/archive_objects.h"
#include "tests/io/archive/orthanc.h"

#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <thread>

namespace angiopose::test {
namespace {

namespace fs = std::filesystem;

constexpr int side = 256;
constexpr int objectsAtOnce = 6;
constexpr std::uint64_t maxBytes = 1U << 30;

std::string storeOf(const std::string& folder)
{
    return folder + "/arrivals";
}

/// Objects that no earlier program has sent.
std::vector<std::string> newObjects(const std::string& folder, int turn)
{
    const std::string series = "2.25.4711." + std::to_string(::getpid()) + "." + std::to_string(turn);
    const fs::path place = fs::path(folder) / "sent";
    fs::remove_all(place);
    fs::create_directories(place);
    std::vector<std::string> files;
    for (int i = 0; i < objectsAtOnce; ++i) {
        files.push_back((place / (std::to_string(i) + ".dcm")).string());
        std::ofstream(files.back(), std::ios::binary) << objectText(i, series, side);
    }
    return files;
}

/// Whether the file is a complete object, with the pixels of `objectText` for one of the numbers.
bool isWholeObject(const std::string& path)
{
    const auto read = io::readAngiogram(path);
    if (!read || read.value().width() != side || read.value().height() != side) {
        return false;
    }
    const std::vector<float>& pixels = read.value().frames.front().pixels;
    const int first = static_cast<int>(pixels.front());
    for (int i = 0; i < side * side; ++i) {
        if (static_cast<int>(pixels[static_cast<std::size_t>(i)]) != (i * 31 + first) % 4096) {
            return false;
        }
    }
    return true;
}

}   // namespace

int receiveForEver(const std::string& folder, int ready)
{
    auto store = io::ObjectStore::open(storeOf(folder), maxBytes);
    io::StorageScpOptions options;
    options.port = freePort();
    auto listening = io::StorageScp::listen(options);
    if (!store || !listening) {
        return 1;
    }
    io::StorageScp receiver = std::move(listening).value();
    io::TransferReport report;
    const io::ArchiveObserver observe;
    io::StoreWriter storeWriter(store.value(), {}, report, observe);
    std::thread([&] { receiver.serve(storeWriter, [] { return false; }); }).detach();
    io::ArchiveNode node;
    node.name = "here";
    node.host = "127.0.0.1";
    node.port = options.port;
    node.title = options.ownAeTitle;
    (void)!::write(ready, "r", 1);
    for (int turn = 0; io::sendToArchive(node, io::ArchiveProtocol::Dimse, newObjects(folder, turn)).isComplete();
         ++turn) {
    }
    return 1;
}

std::string findHalfReceived(const std::string& folder)
{
    std::string half;
    std::error_code absent;
    for (const auto& entry : fs::recursive_directory_iterator(storeOf(folder), absent)) {
        if (entry.path().extension() == ".dcm" && !isWholeObject(entry.path().string())) {
            half += " " + entry.path().string();
        }
    }
    return half;
}

std::size_t interruptedIn(const std::string& folder)
{
    std::error_code absent;
    const fs::directory_iterator begin(fs::path(storeOf(folder)) / io::incomingFolder, absent);
    return absent ? 0 : static_cast<std::size_t>(std::distance(begin, fs::directory_iterator()));
}

void receiveAgain(const std::string& folder)
{
    (void)io::ObjectStore::open(storeOf(folder), maxBytes);
    fs::remove_all(fs::path(storeOf(folder)) / studyUid);
}

}   // namespace angiopose::test
