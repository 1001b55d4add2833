#include "io/archive/web/http.h"

#include "io/archive/model/query.h"
#include "io/messages/messages.h"
#include "io/support/input_bytes.h"

#include <curl/curl.h>
#include <array>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <optional>

namespace angiopose::io {
namespace {

constexpr std::size_t maxBodyBytes = std::size_t{64} << 20;
constexpr long connectMilliseconds = 5000;

struct FreeList {
    void operator()(curl_slist* list) const { curl_slist_free_all(list); }
};
using HeaderList = std::unique_ptr<curl_slist, FreeList>;

void addHeader(HeaderList& list, const std::string& header)
{
    list.reset(curl_slist_append(list.release(), header.c_str()));
}

/// Returns the first line of the authorization file. The value is sent but never stored.
core::Result<std::string> authorizationOf(const ArchiveNode& node)
{
    if (node.authorizationFile.empty()) {
        return std::string();
    }
    const auto input = openInput(node.authorizationFile);
    if (!input) {
        return input.error();
    }
    const std::string_view text = input.value().view();
    return std::string(text.substr(0, text.find_first_of("\r\n")));
}

}   // namespace

struct HttpConnection::Impl {
    ArchiveNode node;
    StopCheck isStopRequested;
    std::string authorization;
    CURL* handle = nullptr;
    std::array<char, CURL_ERROR_SIZE> errorText{};

    // State of the current transfer.
    HttpResponse reply;
    const Sink* sink = nullptr;
    const Source* source = nullptr;
    std::optional<core::Error> failure;

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() { curl_easy_cleanup(handle); }

    void prepare(const std::string& url);
    core::Result<HttpResponse> perform();
    core::Error failureOf(CURLcode code) const;
    bool take(std::string_view piece);

    static std::size_t onBody(char* bytes, std::size_t, std::size_t size, void* self)
    {
        return static_cast<Impl*>(self)->take({bytes, size}) ? size : 0;
    }
    static std::size_t onSend(char* buffer, std::size_t unit, std::size_t count, void* self)
    {
        const auto given = (*static_cast<Impl*>(self)->source)(buffer, unit * count);
        return given.value_or(CURL_READFUNC_ABORT);
    }
    static int onProgress(void* self, curl_off_t, curl_off_t, curl_off_t, curl_off_t)
    {
        return static_cast<Impl*>(self)->isStopRequested() ? 1 : 0;
    }
};

void HttpConnection::Impl::prepare(const std::string& url)
{
    reply = {};
    sink = nullptr;
    source = nullptr;
    failure.reset();
    errorText.front() = '\0';
    curl_easy_reset(handle);
    const auto set = [this](CURLoption option, auto value) { curl_easy_setopt(handle, option, value); };
    set(CURLOPT_URL, url.c_str());
    set(CURLOPT_PROTOCOLS_STR, "http,https");
    set(CURLOPT_FOLLOWLOCATION, 0L);
    set(CURLOPT_NOSIGNAL, 1L);
    set(CURLOPT_NETRC, static_cast<long>(CURL_NETRC_IGNORED));
    set(CURLOPT_CONNECTTIMEOUT_MS, connectMilliseconds);
    set(CURLOPT_LOW_SPEED_LIMIT, 1L);
    set(CURLOPT_LOW_SPEED_TIME, static_cast<long>(node.responseTimeoutSeconds));
    set(CURLOPT_SSL_VERIFYPEER, 1L);
    set(CURLOPT_SSL_VERIFYHOST, node.verifiesHost ? 2L : 0L);
    set(CURLOPT_SSLVERSION, static_cast<long>(CURL_SSLVERSION_TLSv1_2));
    if (!node.caFile.empty()) {
        set(CURLOPT_CAINFO, node.caFile.c_str());
        set(CURLOPT_CAPATH, static_cast<const char*>(nullptr));
    }
    if (!node.certificateFile.empty()) {
        set(CURLOPT_SSLCERT, node.certificateFile.c_str());
        set(CURLOPT_SSLKEY, node.keyFile.c_str());
        set(CURLOPT_KEYPASSWD, "");
    }
    set(CURLOPT_ERRORBUFFER, errorText.data());
    set(CURLOPT_NOPROGRESS, 0L);
    set(CURLOPT_XFERINFOFUNCTION, &Impl::onProgress);
    set(CURLOPT_XFERINFODATA, this);
    set(CURLOPT_WRITEFUNCTION, &Impl::onBody);
    set(CURLOPT_WRITEDATA, this);
}

bool HttpConnection::Impl::take(std::string_view piece)
{
    if (reply.contentType.empty()) {
        const char* type = nullptr;
        curl_easy_getinfo(handle, CURLINFO_CONTENT_TYPE, &type);
        curl_easy_getinfo(handle, CURLINFO_RESPONSE_CODE, &reply.status);
        reply.contentType = type != nullptr ? type : "";
    }
    if (sink != nullptr && *sink && reply.status == 200) {
        auto taken = (*sink)(piece, reply.contentType);
        if (!taken) {
            failure = taken.error();
        }
        return static_cast<bool>(taken);
    }
    if (reply.body.size() + piece.size() > maxBodyBytes) {
        failure = core::Error(messages::archiveHttpTooLarge(sizeText(maxBodyBytes)).about(node.name));
        return false;
    }
    reply.body += piece;
    return true;
}

core::Error HttpConnection::Impl::failureOf(CURLcode code) const
{
    const std::string why = errorText.front() != '\0' ? errorText.data() : curl_easy_strerror(code);
    const auto about = [this](const core::Message& problem) { return core::Error(problem.about(node.name)); };
    switch (code) {
        case CURLE_ABORTED_BY_CALLBACK:
            return core::Error(core::Cancellation{messages::archiveStopped()}).about(node.name);
        case CURLE_COULDNT_RESOLVE_HOST:
        case CURLE_COULDNT_RESOLVE_PROXY:
        case CURLE_COULDNT_CONNECT:
            return about(messages::archiveNoConnection(node.webUrl, why));
        case CURLE_OPERATION_TIMEDOUT: {
            double connected = 0.0;
            curl_easy_getinfo(handle, CURLINFO_CONNECT_TIME, &connected);
            return about(connected > 0.0
                             ? messages::archiveNoAnswer(core::Quantity{double(node.responseTimeoutSeconds), 0, "s"})
                             : messages::archiveNoConnection(node.webUrl, why));
        }
        case CURLE_PEER_FAILED_VERIFICATION:
        case CURLE_SSL_CONNECT_ERROR:
        case CURLE_SSL_CERTPROBLEM:
        case CURLE_SSL_CACERT_BADFILE:
        case CURLE_SSL_ISSUER_ERROR:
        case CURLE_SSL_CIPHER:
            return about(messages::archiveTlsRefused(why));
        default:
            return about(messages::archiveBroken(why));
    }
}

core::Result<HttpResponse> HttpConnection::Impl::perform()
{
    const CURLcode code = curl_easy_perform(handle);
    if (failure) {
        return *failure;
    }
    if (code != CURLE_OK) {
        return failureOf(code);
    }
    curl_easy_getinfo(handle, CURLINFO_RESPONSE_CODE, &reply.status);
    if (reply.status == 401 || reply.status == 403) {
        return core::Error(messages::archiveHttpForbidden(reply.status).about(node.name));
    }
    return std::move(reply);
}

HttpConnection::HttpConnection(std::unique_ptr<Impl> parts) : impl_(std::move(parts)) {}
HttpConnection::HttpConnection(HttpConnection&&) noexcept = default;
HttpConnection::~HttpConnection() = default;

core::Result<HttpConnection> HttpConnection::open(const ArchiveNode& node, StopCheck isStopRequested)
{
    if (auto checked = checkNode(node); !checked) {
        return checked.error();
    }
    if (node.webUrl.empty()) {
        return core::Error(messages::archiveNoWeb().about(node.name));
    }
    static std::once_flag once;
    std::call_once(once, [] {
        curl_global_init(CURL_GLOBAL_DEFAULT);
        std::signal(SIGPIPE,
                    SIG_IGN);   // as in DCMTK, so that a closed connection is an error and does not end the program
    });
    auto authorization = authorizationOf(node);
    if (!authorization) {
        return authorization.error();
    }
    auto parts = std::make_unique<Impl>();
    parts->node = node;
    parts->isStopRequested = std::move(isStopRequested);
    parts->authorization = std::move(authorization).value();
    parts->handle = curl_easy_init();
    if (parts->handle == nullptr) {
        return core::Error(messages::archiveBroken("libcurl").about(node.name));
    }
    return HttpConnection(std::move(parts));
}

core::Result<HttpResponse> HttpConnection::get(const std::string& url, const std::string& accept, const Sink& sink)
{
    impl_->prepare(url);
    impl_->sink = &sink;
    HeaderList headers;
    addHeader(headers, "Accept: " + accept);
    if (!impl_->authorization.empty()) {
        addHeader(headers, "Authorization: " + impl_->authorization);
    }
    curl_easy_setopt(impl_->handle, CURLOPT_HTTPHEADER, headers.get());
    return impl_->perform();
}

core::Result<HttpResponse> HttpConnection::post(const std::string& url, const Upload& upload)
{
    impl_->prepare(url);
    impl_->source = &upload.source;
    HeaderList headers;
    addHeader(headers, "Accept: " + upload.accept);
    addHeader(headers, "Content-Type: " + upload.contentType);
    addHeader(headers, "Expect:");   // do not wait for "100 Continue"
    if (!impl_->authorization.empty()) {
        addHeader(headers, "Authorization: " + impl_->authorization);
    }
    curl_easy_setopt(impl_->handle, CURLOPT_HTTPHEADER, headers.get());
    curl_easy_setopt(impl_->handle, CURLOPT_POST, 1L);
    curl_easy_setopt(impl_->handle, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(upload.bytes));
    curl_easy_setopt(impl_->handle, CURLOPT_READFUNCTION, &Impl::onSend);
    curl_easy_setopt(impl_->handle, CURLOPT_READDATA, impl_.get());
    return impl_->perform();
}

std::string percentEncode(std::string_view text)
{
    std::string escaped;
    for (const char c : text) {
        const bool isPlain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' ||
                             c == '.' || c == '_' || c == '~' || c == '*';
        if (isPlain) {
            escaped += c;
        } else {
            std::array<char, 4> code{};
            std::snprintf(code.data(), code.size(), "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
            escaped += code.data();
        }
    }
    return escaped;
}

}   // namespace angiopose::io
