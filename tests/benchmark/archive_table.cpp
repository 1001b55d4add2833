#include "io/archive/archive.h"
#include "io/archive/dimse/get_series.h"
#include "io/archive/store/cache.h"
#include "io/dicom/dicom_item.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/timing.h"
#include "tests/io/archive/orthanc.h"
#include "tests/support/for_each.h"
#include "tests/support/temporary_folder.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

// archive_table [--megabytes N] [--seed N] Sends simulated CT slices (2000 MB of them) to an Orthanc that it starts,
// and retrieves them by C-GET, C-MOVE and WADO-RS. Compares every received data set with the sent one, byte for byte.
// Prints wall seconds, processor seconds of this program, and MB per wall second; fails if an object is missing or
// differs. Needs three times N of disk space for temporary files. The archive's own computing counts in the wall time
// only.

using namespace angiopose;
using namespace std::string_literals;

namespace {

constexpr int side = 512;
constexpr const char* studyUid = "2.25.2000";
constexpr const char* seriesUid = "2.25.2000.1";
constexpr double megabyte = 1e6;

/// Pixels of a body of 300 mm with scanner noise, in Hounsfield units + 1024.
std::vector<std::uint16_t> slicePixels(int index, std::uint64_t& state)
{
    std::vector<std::uint16_t> pixels;
    pixels.reserve(std::size_t{side} * side);
    test::forEachPixel(side, side, [&](int x, int y) {
        state ^= state << 13U;
        state ^= state >> 7U;
        state ^= state << 17U;
        const int dx = x - side / 2, dy = y - side / 2;
        const bool isBody = dx * dx + 2 * dy * dy < 200 * 200;
        const auto grain = static_cast<int>(state % 64U);
        pixels.push_back(static_cast<std::uint16_t>((isBody ? 1060 + index % 40 : 24) + grain));
    });
    return pixels;
}

std::string sliceText(int index, std::uint64_t& state)
{
    io::DicomObject object;
    io::DicomItem root = object.root();
    const std::string number = std::to_string(index + 1);
    root.text(0x00080005, "CS", "ISO_IR 192");
    root.text(0x00080008, "CS", "ORIGINAL\\PRIMARY\\AXIAL");
    root.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2");
    root.text(0x00080018, "UI", std::string(seriesUid) + "." + number);
    root.text(0x00080020, "DA", "20240305");
    root.text(0x00080060, "CS", "CT");
    root.text(0x00100010, "PN", "Simulated^Slices");
    root.text(0x00100020, "LO", "SIM-2000");
    root.text(0x0020000d, "UI", studyUid);
    root.text(0x0020000e, "UI", seriesUid);
    root.text(0x00200013, "IS", number);
    root.setDecimals(0x00200032, {-150.0, -150.0, 0.5 * index});
    root.setDecimals(0x00200037, {1, 0, 0, 0, 1, 0});
    root.setUnsignedShort(0x00280002, 1);
    root.text(0x00280004, "CS", "MONOCHROME2");
    root.setUnsignedShort(0x00280010, side);
    root.setUnsignedShort(0x00280011, side);
    root.setDecimals(0x00280030, {0.586, 0.586});
    root.setUnsignedShort(0x00280100, 16);
    root.setUnsignedShort(0x00280101, 16);
    root.setUnsignedShort(0x00280102, 15);
    root.setUnsignedShort(0x00280103, 0);
    root.setDecimals(0x00281052, {-1024});
    root.setDecimals(0x00281053, {1});
    root.words(0x7fe00010, slicePixels(index, state));
    const auto content = object.content();
    return content ? content.value() : std::string();
}

std::string nameOf(int index)
{
    return std::string(seriesUid) + "." + std::to_string(index + 1) + ".dcm";
}

/// Writes slices as files up to the given size and returns their number.
int writeSlices(const test::TemporaryFolder& folder, double megabytes, std::uint64_t seed)
{
    std::uint64_t state = seed * 2 + 1;
    double written = 0.0;
    int count = 0;
    for (; written < megabytes * megabyte; ++count) {
        const std::string text = sliceText(count, state);
        folder.write("sent/" + nameOf(count), text);
        written += static_cast<double>(text.size());
    }
    return count;
}

/// Number of objects that are missing or whose data set differs. File headers are not compared because each writer
/// makes its own.
int lackingOrOther(const test::TemporaryFolder& folder, const std::string& came, int count)
{
    int faults = 0;
    for (int i = 0; i < count; ++i) {
        const std::string sent = test::readText(folder.file("sent/" + nameOf(i)));
        const std::string stored = test::readText(came + "/" + nameOf(i));
        const std::size_t dataset = sent.find("\x08\0\x05\0"s);
        faults += stored.ends_with(std::string_view(sent).substr(dataset)) ? 0 : 1;
    }
    return faults;
}

struct Row {
    std::string way;
    std::size_t objects = 0;
    std::uint64_t bytes = 0;
    int faults = 0;
    benchmarks::Timing time{};
    std::string problem{};
};

void print(const Row& row)
{
    const double sent = static_cast<double>(row.bytes) / megabyte;
    std::printf("%-8s %8zu %9.1f %9.1f %8.1f %10.1f %8d  %s\n", row.way.c_str(), row.objects, sent, row.time.wall,
                sent / row.time.wall, row.time.processor, row.faults, row.problem.c_str());
    std::fflush(stdout);
}

std::string problemOf(const io::TransferReport& report)
{
    return report.end                ? report.end->message.text()
           : report.problems.empty() ? std::string()
                                     : report.problems.front().text();
}

class ArchiveTable {
public:
    ArchiveTable(double megabytes, std::uint64_t seed) : count_(writeSlices(folder_, megabytes, seed)) {}

    int run()
    {
        if (!orthanc_.isRunning()) {
            std::printf("%s\n", orthanc_.whyNot().c_str());
            return 1;
        }
        std::printf("%-8s %8s %9s %9s %8s %10s %8s\n", "way", "objects", "MB", "wall s", "MB/s", "our cpu s", "faults");
        Row sent{"C-STORE"};
        io::TransferReport report;
        sent.time = benchmarks::timed(
            [&] { report = io::sendToArchive(node(), io::ArchiveProtocol::Dimse, {folder_.file("sent")}); });
        take(report, sent);
        sent.faults = count_ - static_cast<int>(report.transferred);
        print(sent);
        faults_ += sent.faults;
        const auto retrieve = [this](io::ArchiveProtocol way) {
            return [this, way](const io::ObjectStore& store) {
                return io::retrieveFromArchive(node(), way, {studyUid, {seriesUid}}, store, {});
            };
        };
        come("C-GET", retrieve(io::ArchiveProtocol::Dimse));
        come("C-MOVE", [this](const io::ObjectStore& store) { return moved(store); });
        come("WADO-RS", retrieve(io::ArchiveProtocol::Web));
        return faults_ == 0 ? 0 : 1;
    }

private:
    io::ArchiveNode node() const
    {
        io::ArchiveNode node;
        node.name = "orthanc";
        node.host = "127.0.0.1";
        node.port = orthanc_.dicomPort();
        node.title = test::Orthanc::title;
        node.receivePort = orthanc_.movePort();
        node.webUrl = orthanc_.webUrl();
        node.caFile = orthanc_.caFile();
        node.responseTimeoutSeconds = 120;   // the machine may be busy
        return node;
    }

    io::TransferReport moved(const io::ObjectStore& store) const
    {
        io::TransferReport report;
        const io::ArchiveObserver observe;
        io::StoreWriter storeWriter(store, {}, report, observe);
        const std::vector<io::ArchiveObject> objects;
        if (auto done = io::moveSeries(node(), {studyUid, seriesUid, objects}, storeWriter); !done) {
            report.end = done.error();
        }
        return report;
    }

    static void take(const io::TransferReport& report, Row& row)
    {
        row.objects = report.transferred;
        row.bytes = report.bytes;
        row.problem = problemOf(report);
    }

    void come(const std::string& way, const std::function<io::TransferReport(const io::ObjectStore&)>& retrieve)
    {
        const std::string into = folder_.file("came");
        const auto store = io::ObjectStore::open(into, io::defaultMaxObjectBytes);
        Row row{way};
        io::TransferReport report;
        row.time = benchmarks::timed([&] { report = retrieve(store.value()); });
        take(report, row);
        row.faults = lackingOrOther(folder_, store.value().seriesFolder(studyUid, seriesUid), count_);
        faults_ += row.faults;
        print(row);
        std::error_code ignored;
        std::filesystem::remove_all(into, ignored);
    }

    test::TemporaryFolder folder_;
    int count_;
    int faults_ = 0;
    test::Orthanc orthanc_;
};

}   // namespace

int main(int argc, char** argv)
{
    const benchmarks::Arguments arguments(argc, argv, "archive_table [--megabytes <2000>] [--seed <1>]\n");
    return ArchiveTable(arguments.number("megabytes", 2000.0),
                        static_cast<std::uint64_t>(arguments.number("seed", 1.0)))
        .run();
}
