#include "io/archive/web/dicom_json.h"
#include "io/archive/web/http.h"
#include "io/archive/web/multipart.h"
#include "io/archive/web/web_archive.h"
#include "io/messages/messages.h"

#include <optional>
#include <set>
#include <utility>

namespace angiopose::io {
namespace {

constexpr std::size_t pageSize = 200;

// "*" requests the stored transfer syntax.
constexpr const char* acceptAsStored = "multipart/related; type=\"application/dicom\"; transfer-syntax=*";

/// Stores the objects of a multipart response.
class PartWriter {
public:
    PartWriter(ExpectedObject expected, StoreWriter& storeWriter)
        : expected_(std::move(expected)), storeWriter_(storeWriter)
    {
    }

    core::Status take(std::string_view piece, const std::string& contentType)
    {
        if (!reader_) {
            const auto boundary = parseBoundary(contentType);
            if (!boundary) {
                return core::Error(messages::archiveNonsense(contentType));
            }
            reader_.emplace(*boundary, handler());
        }
        return reader_->feed(piece);
    }

    bool isComplete() const { return reader_ && reader_->isClosed(); }

private:
    MultipartReader::Handler handler()
    {
        return {[this] { return begin(); },
                [this](std::string_view bytes) { return storeWriter_.write(*object_, bytes); },
                [this] { return end(); }};
    }

    core::Status begin()
    {
        auto begun = storeWriter_.begin();
        if (!begun) {
            return begun.error();
        }
        object_.emplace(std::move(begun).value());
        return core::Done{};
    }

    core::Status end()
    {
        const auto fate = storeWriter_.take(std::move(*object_), expected_);
        object_.reset();
        return fate ? core::Status(core::Done{}) : core::Status(fate.error());
    }

    ExpectedObject expected_;
    StoreWriter& storeWriter_;
    std::optional<MultipartReader> reader_;
    std::optional<IncomingObject> object_;
};

class WebSource : public SeriesSource {
public:
    WebSource(ArchiveNode node, std::function<bool()> isStopRequested)
        : node_(std::move(node)), isStopRequested_(std::move(isStopRequested))
    {
    }

    core::Result<std::vector<std::string>> seriesOf(const std::string& studyUid) override
    {
        auto answer = ask(dicomWebUrl(node_) + "/studies/" + studyUid + "/series");
        if (!answer) {
            return answer.error();
        }
        auto found = parseMatches(answer.value());
        if (!found) {
            return found.error().about(node_.name);
        }
        std::vector<std::string> series;
        for (const ArchiveMatch& match : found.value()) {
            series.push_back(match.seriesUid);
        }
        return series;
    }

    core::Result<std::vector<ArchiveObject>> objectsOf(const std::string& studyUid,
                                                       const std::string& seriesUid) override
    {
        std::vector<ArchiveObject> objects;
        std::set<std::string> seen;
        for (bool hasMore = true; hasMore && objects.size() < maxObjects;) {
            auto page = objectsFrom(seriesUrl(studyUid, seriesUid), objects.size());
            if (!page) {
                return page.error();
            }
            hasMore = false;   // stop unless the page has new objects: some archives return all objects every time
            for (const ArchiveObject& object : page.value()) {
                if (seen.insert(object.sopInstance).second) {
                    objects.push_back(object);
                    hasMore = true;
                }
            }
        }
        return objects;
    }

    core::Status fetch(const std::string& studyUid, const std::string& seriesUid,
                       const std::vector<ArchiveObject>& /*objects*/, StoreWriter& storeWriter) override
    {
        auto opened = HttpConnection::open(node_, [&storeWriter] { return storeWriter.isStopRequested(); });
        if (!opened) {
            return opened.error();
        }
        HttpConnection http = std::move(opened).value();
        PartWriter parts({studyUid, seriesUid, {}}, storeWriter);
        auto reply =
            http.get(seriesUrl(studyUid, seriesUid), acceptAsStored,
                     [&parts](std::string_view piece, const std::string& type) { return parts.take(piece, type); });
        if (!reply) {
            return reply.error();
        }
        if (reply.value().status != 200) {
            const std::string status = std::to_string(reply.value().status);
            return core::Error(messages::archiveHttpStatus("WADO-RS", status).about(node_.name));
        }
        return parts.isComplete() ? core::Status(core::Done{})
                                  : core::Error(messages::archiveBroken("multipart").about(node_.name));
    }

private:
    std::string seriesUrl(const std::string& studyUid, const std::string& seriesUid) const
    {
        return dicomWebUrl(node_) + "/studies/" + studyUid + "/series/" + seriesUid;
    }

    /// Lists one page of objects, because an archive that collects all objects of a large series may not respond for a
    /// long time.
    core::Result<std::vector<ArchiveObject>> objectsFrom(const std::string& series, std::size_t first)
    {
        auto answer = ask(series + "/instances?limit=" + std::to_string(pageSize) + "&offset=" + std::to_string(first));
        if (!answer) {
            return answer.error();
        }
        auto objects = parseObjects(answer.value());
        if (!objects) {
            return objects.error().about(node_.name);
        }
        return std::vector<ArchiveObject>(objects.value());
    }

    core::Result<std::string> ask(const std::string& url)
    {
        auto opened = HttpConnection::open(node_, isStopRequested_);
        if (!opened) {
            return opened.error();
        }
        HttpConnection http = std::move(opened).value();
        return queryDicomWeb(http, node_, "QIDO-RS", url);
    }

    ArchiveNode node_;
    std::function<bool()> isStopRequested_;
};

}   // namespace

std::unique_ptr<SeriesSource> makeWebSource(const ArchiveNode& node, const std::function<bool()>& isStopRequested)
{
    return std::make_unique<WebSource>(node, isStopRequested);
}

}   // namespace angiopose::io
